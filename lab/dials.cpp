#include "lab/dials.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "lab/failure.h"
#include "lab/nearest.h"
#include "lab/parsing.h"

namespace wander {

namespace {

std::string chains_help() {
  constexpr ChainSettings usual;
  return fmt::format(
      "chains of all {0} groups together, a multiple of {0} (default: {0}, and up to {1} where the "
      "budget gives each {2} mutations; of a pooled film where samples hardly find light, {3} and "
      "{4}; of a pooled image, {5} and {6}, or {7} where it has more samples than mutations); the "
      "fewer, the longer",
      usual.groups, usual.groups * usual.chains_per_group, usual.steps_per_chain,
      usual.groups * RareLight::chains_per_group, RareLight::steps_per_chain,
      usual.groups * ChainsOfImage::chains_per_group, ChainsOfImage::steps_per_chain,
      ChainsOfImage::steps_per_chain_of_rare_light);
}
std::string seed_share_help() {
  return fmt::format(
      "length of the seed pass: samples for each mutation of a sample budget, seconds for each "
      "second of the chains in a time budget; for an error, of a pooled film, samples for each "
      "mutation beside the chains (default: as many as earn more than steps do, of an "
      "image all before the chains, of a curve but for a few beside them; where samples hardly "
      "find light {} in a time budget, {} in one of "
      "samples; with --film chains, {})",
      RareLight::seed_share_of_time, RareLight::samples_per_step, ChainSettings::usual_seed_share);
}
int parse_chains(std::string_view text) {
  constexpr int groups = ChainSettings{}.groups;
  const auto chains = static_cast<int>(parse_count("--chains", text, groups, 1 << 20));
  if (chains % groups != 0)
    throw UsageError(fmt::format("--chains '{}': allowed are multiples of {}", text, groups));
  return chains / groups;
}

std::string estimator_help() {
  const auto usual = [](StepEstimator estimator) {
    return in_words(methods_that([estimator](const Method& m) {
      return m.dials.has(DialId::estimator) && m.usual_estimator == estimator;
    }));
  };
  return fmt::format(
      "of {}: kelemen (large steps count as independent samples, too; the default of {}) or "
      "expected (plain expected values; the default of {})",
      in_words(methods_that([](const Method& m) { return m.dials.has(DialId::estimator); })),
      usual(StepEstimator::kelemen), usual(StepEstimator::expected));
}

std::string asked_for_help(std::string_view what) {
  return fmt::format(
      "keep {} also where the film has more than {} bins; they take memory (docs/memory.md)", what,
      FilmLayout{}.most_small);
}
Keep parse_keep(std::string_view option, std::string_view text) {
  if (text != "on")
    throw UsageError(fmt::format("{} '{}': it is asked for by `on`, or not at all", option, text));
  return Keep::always;
}

const std::vector<Dial>& dial_table() {
  static const std::vector<Dial> known{
      {DialId::mutations, "mutations", "SPEC", mutations_help(),
       [](Dials& dials, std::string_view text) { dials.mutations = parse_mutations(text); }},
      {DialId::estimator, "estimator", "RULE", estimator_help(),
       [](Dials& dials, std::string_view text) { dials.estimator = parse_estimator(text); }},
      {DialId::max_vertices, "max_vertices", "N",
       "longest paths, both ends counted (default: what the scene says)",
       [](Dials& dials, std::string_view text) { dials.max_vertices = parse_max_vertices(text); }},
      {DialId::chains, "chains", "N", chains_help(),
       [](Dials& dials, std::string_view text) {
         dials.chains.chains_per_group = parse_chains(text);
         dials.chains.steps_per_chain = 0;
       }},
      {DialId::seed_share, "seed_share", "X", seed_share_help(),
       [](Dials& dials, std::string_view text) {
         dials.chains.seed_share = parse_positive("--seed-share", text, 1e4);
       }},
      {DialId::film, "film", "PARTS",
       "pooled (default: the film of the seed pass and the chains together) or chains (of the "
       "chains alone)",
       [](Dials& dials, std::string_view text) { dials.chains.film_parts = parse_film(text); }},
      {DialId::target, "target", "RULE",
       "what chains of mlt come to on an image: even (default: all of it about as often, by a test "
       "image) or light (as often as it is bright; so in trace, and on a curve)",
       [](Dials& dials, std::string_view text) { dials.chains.target = parse_target(text); }},
      {DialId::normalization, "normalization", "RULE",
       "where b comes from: bridge (default: bridge sampling of the seed pass and the chains), "
       "least-squares (their films) or seed (the mean of the seed pass)",
       [](Dials& dials, std::string_view text) {
         dials.chains.normalization = parse_normalization(text);
       }},
      {DialId::precision, "precision", "TYPE",
       "of scattering, densities and sampling: double (the default) or float; geometry is double",
       [](Dials& dials, std::string_view text) { dials.precision = parse_precision(text); }},
      {DialId::large_step, "large_step", "P",
       fmt::format("of the steps in primary sample space, the share that forgets the present "
                   "path: between 0 and 1 (default: {})",
                   default_large_step),
       [](Dials& dials, std::string_view text) { dials.large_step = parse_large_step(text); }},
      {DialId::kernel, "kernel", "FACTOR",
       "how many times as far small moves go, those of primary sample space and of the lens, "
       "caustic and multi-chain perturbations; or auto (the default: as far as suits the scene, "
       "by a trial before the run; 1 where the budget is small, in trace, and for the mutations in "
       "check)",
       [](Dials& dials, std::string_view text) { dials.kernel = parse_kernel(text); }},
      {DialId::by_length, "by_length", "", asked_for_help("films by path length"),
       [](Dials& dials, std::string_view text) {
         dials.film.by_length = parse_keep("--by-length", text);
       }},
      {DialId::maps, "maps", "", asked_for_help("maps of acceptance and proposals"),
       [](Dials& dials, std::string_view text) { dials.film.maps = parse_keep("--maps", text); }},
  };
  return known;
}

}  // namespace

std::string Dial::option() const {
  std::string name = "--" + std::string(word);
  std::ranges::replace(name, '_', '-');
  return name;
}

std::span<const Dial> dials() { return dial_table(); }

const Dial& find_dial(std::string_view word) {
  std::vector<std::string_view> words;
  for (const Dial& dial : dial_table()) {
    if (dial.word == word) return dial;
    words.push_back(dial.word);
  }
  throw UsageError(unknown_word("dial", word, words));
}

void require_dial(const Dial& dial, const Method& method) {
  if (dial.is_of(method)) return;
  const auto of = methods_that([&](const Method& other) { return dial.is_of(other); });
  throw UsageError(
      fmt::format("{} is for {}; {} does not have it", dial.option(), in_words(of), method.name));
}

}  // namespace wander

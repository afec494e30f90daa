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
      "budget gives each {2} mutations); the fewer, the longer",
      usual.groups, usual.groups * usual.chains_per_group, usual.steps_per_chain);
}
std::string seed_share_help() {
  return fmt::format(
      "length of the seed pass: samples for each mutation of a sample budget, seconds for each "
      "second of the chains in a time budget (default: {})",
      ChainSettings{}.seed_share);
}
int parse_chains(std::string_view text) {
  constexpr int groups = ChainSettings{}.groups;
  const auto chains = static_cast<int>(parse_count("--chains", text, groups, 1 << 20));
  if (chains % groups != 0)
    throw UsageError(fmt::format("--chains '{}': allowed are multiples of {}", text, groups));
  return chains / groups;
}

std::string_view for_all(std::string_view) { return {}; }
std::string_view for_mlt(std::string_view method) {
  return method == "mlt" ? "" : "is for mlt, whose mutations can be chosen";
}
std::string_view for_primary_methods(std::string_view method) {
  return method == "pssmlt" || method == "mmlt" ? "" : "is for pssmlt and mmlt";
}
std::string_view for_chains(std::string_view method) {
  return method == "mlt" || method == "pssmlt" || method == "mmlt"
             ? ""
             : "is for the Markov chain methods mlt, pssmlt and mmlt";
}
std::string_view for_counted_chains(std::string_view method) {
  return method == "mlt" || method == "pssmlt"
             ? ""
             : "is for mlt and pssmlt; mmlt has one chain for each path length in each group";
}

const std::vector<Dial>& table() {
  static const std::vector<Dial> known{
      {"mutations", "SPEC", mutations_help(), for_mlt,
       [](Dials& dials, std::string_view text) { dials.mutations = parse_mutations(text); }},
      {"estimator", "RULE",
       "of pssmlt and mmlt: kelemen (large steps count as independent samples, too; what "
       "pssmlt does by default) or expected (plain expected values; mmlt's default)",
       for_primary_methods,
       [](Dials& dials, std::string_view text) { dials.estimator = parse_estimator(text); }},
      {"max_vertices", "N", "longest paths, both ends counted (default: what the scene says)",
       for_all,
       [](Dials& dials, std::string_view text) { dials.max_vertices = parse_max_vertices(text); }},
      {"chains", "N", chains_help(), for_counted_chains,
       [](Dials& dials, std::string_view text) {
         dials.chains.chains_per_group = parse_chains(text);
         dials.chains.steps_per_chain = 0;
       }},
      {"seed_share", "X", seed_share_help(), for_chains,
       [](Dials& dials, std::string_view text) {
         dials.chains.seed_share = parse_positive("--seed-share", text, 1e4);
       }},
      {"normalization", "RULE",
       "where b comes from: bridge (default: bridge sampling of the seed pass and the chains), "
       "least-squares (their films) or seed (the mean of the seed pass)",
       for_chains,
       [](Dials& dials, std::string_view text) {
         dials.chains.normalization = parse_normalization(text);
       }},
      {"precision", "TYPE",
       "of scattering, densities and sampling: double (the default) or float; geometry is double",
       for_all,
       [](Dials& dials, std::string_view text) { dials.precision = parse_precision(text); }},
      {"large_step", "P",
       fmt::format("of the steps in primary sample space, the share that forgets the present "
                   "path: between 0 and 1 (default: {})",
                   default_large_step),
       for_chains,
       [](Dials& dials, std::string_view text) { dials.large_step = parse_large_step(text); }},
      {"kernel", "FACTOR",
       "how many times as far small moves go (default: 1): those of primary sample space and of "
       "the lens, caustic and multi-chain perturbations",
       for_chains, [](Dials& dials, std::string_view text) { dials.kernel = parse_kernel(text); }},
  };
  return known;
}

}  // namespace

StepEstimator usual_estimator(std::string_view method) {
  return method == "pssmlt" ? StepEstimator::kelemen : StepEstimator::expected;
}

std::string Dial::option() const {
  std::string name = "--" + std::string(word);
  std::ranges::replace(name, '_', '-');
  return name;
}

std::span<const Dial> dials() { return table(); }

const Dial& find_dial(std::string_view word) {
  std::vector<std::string_view> words;
  for (const Dial& dial : table()) {
    if (dial.word == word) return dial;
    words.push_back(dial.word);
  }
  throw UsageError(unknown_word("dial", word, words));
}

void require_dial(const Dial& dial, std::string_view method) {
  if (const std::string_view why = dial.missing(method); !why.empty())
    throw UsageError(fmt::format("{} {}; {} does not have it", dial.option(), why, method));
}

void require_precision(Precision precision, const description::Scene& scene) {
  if (const std::string why = why_beyond(precision, scene); !why.empty())
    throw UsageError(fmt::format("--precision {} cannot hold this scene: {}; use double",
                                 name_of(precision), why));
}

}  // namespace wander

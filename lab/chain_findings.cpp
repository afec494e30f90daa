#include "lab/chain_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/reliability.h"
#include "lab/film_mean.h"
#include "lab/seldom_seen.h"
#include "mlt/run/large_pooled_film.h"
#include "mlt/run/normalized_film.h"
#include "mlt/run/reliability.h"
#include "mlt/run/warnings.h"

namespace wander {

namespace {

SeedTally tally_of(std::span<const GroupFindings> groups) {
  SeedTally tally = *groups.front().seeds;
  for (const GroupFindings& group : groups.subspan(1)) tally.merge(*group.seeds);
  return tally;
}

}  // namespace

ChainFindings::ChainFindings(std::string method, std::vector<int> shape, MutationStatistics none,
                             const FoundByChance& must_meet)
    : method_(std::move(method)),
      shape_(std::move(shape)),
      statistics_(std::move(none)),
      must_meet_(must_meet) {}

void ChainFindings::keep() {
  for (std::size_t g = kept_.size(); g < groups_.size(); ++g)
    groups_[g] = kept_.emplace_back(groups_[g]).found();
  for (std::size_t p = kept_films_.size(); p < parts_.size() && parts_[p].shared; ++p) {
    SharedLight& light = *parts_[p].shared;
    light.films = &kept_films_.emplace_back(*light.films);
    if (light.samples) light.samples = &kept_samples_.emplace_back(*light.samples);
    if (light.total) light.total = &kept_totals_.emplace_back(*light.total);
  }
}

Rendering ChainFindings::rendering() const {
  Rendering r;
  r.method = method_;
  r.samples = statistics_.steps();
  r.adaptation = parts_.front().adaptation;
  for (const Part& part : parts_) {
    r.chains += part.chains;
    r.groups += part.settings.groups;
  }
  normalize(r);
  judge(r);
  return r;
}

// ---- groups of different sizes

double ChainFindings::Part::size() const {
  if (cost_of_sample)
    return static_cast<double>(steps) + *cost_of_sample * static_cast<double>(seeds);
  const double share = settings.seed_share.value_or(ChainSettings::usual_seed_share);
  return 1 / (1 / static_cast<double>(steps) + share / static_cast<double>(seeds));
}

// In units of those of the first part, so that groups of one size weigh 1.
std::vector<GroupFindings> ChainFindings::weighed_groups() const {
  if (parts_.size() == 1) return groups_;
  std::vector<GroupFindings> groups;
  for (const Part& part : parts_)
    for (int g = 0; g < part.settings.groups; ++g)
      groups.push_back(groups_[groups.size()].weighing(relative_size(part)));
  return groups;
}
double ChainFindings::relative_size(const Part& part) const {
  const auto each = [](const Part& of) { return of.size() / of.settings.groups; };
  return parts_.size() == 1 ? 1 : each(part) / each(parts_.front());
}

// ---- the film

// A part counts as its seed pass does in b, of which this film is the distribution.
FilmEstimate ChainFindings::unbiased() const {
  if (parts_.size() == 1) return unbiased(parts_.front());
  std::vector<WeightedFilm> films;
  int groups = 0;
  for (const Part& part : parts_) {
    films.push_back({unbiased(part), static_cast<double>(part.seeds)});
    groups += part.settings.groups;
  }
  FilmEstimate film = mean_film(films);
  film.reliable = reliability_of_groups(film, static_cast<std::size_t>(groups));
  return film;
}

FilmEstimate ChainFindings::unbiased(const Part& part) const {
  return part.shared ? mean_film(*part.shared, shape_) : part.unbiased.estimate();
}

std::vector<SharedLight> ChainFindings::shared_light() const {
  std::vector<SharedLight> runs;
  for (const Part& part : parts_) {
    runs.push_back(*part.shared);
    runs.back().weight = relative_size(part);
  }
  return runs;
}

FilmEstimate ChainFindings::chains_film(NormalizationMethod method, const Constant& b,
                                        std::span<const GroupFindings> groups) const {
  if (is_pooled() && is_large()) return total_film(shared_light(), b, shape_);
  if (method == NormalizationMethod::seed_pass) return unbiased();
  return is_large() ? normalized_film(shared_light(), b, shape_)
                    : normalized_film(groups, b, shape_);
}

PooledFilm ChainFindings::pooled_film(const Constant& b,
                                      std::span<const GroupFindings> groups) const {
  if (is_large()) return wander::pooled_film(shared_light(), groups, b, shape_);
  return wander::pooled_film(groups, groups_of_runs(), b, shape_);
}

std::vector<int> ChainFindings::groups_of_runs() const {
  std::vector<int> counts;
  for (const Part& part : parts_) counts.push_back(part.settings.groups);
  return counts;
}

namespace {

// Of groups whose chains know the class of their states; each weighs as what it deposits does.
std::vector<ClassRecord> class_records(std::span<const GroupFindings> groups) {
  struct Light {
    double all = 0, of_chains = 0;
  };
  std::map<std::string, Light> classes;
  double all = 0;
  for (const GroupFindings& group : groups) {
    const ClassParts& parts = group.parts.front().classes();
    for (std::size_t c = 0; c < parts.size(); ++c) {
      if (parts.states(c) == 0) continue;
      Light& light = classes[name_of_class(parts.path_class(c))];
      light.all += group.scale * parts.states(c);
      light.of_chains += group.scale * parts.of_chains(c);
      all += group.scale * parts.states(c);
    }
  }
  std::vector<ClassRecord> records;
  for (const auto& [name, light] : classes)
    if (light.all > 0) records.push_back({name, light.all / all, 1 - light.of_chains / light.all});
  std::ranges::stable_sort(records, std::greater(), &ClassRecord::light);
  return records;
}

// What samples of a pooled film seldom found they may have missed where they saw none of it.  Which bins that are is not
// known, so none is called unreliable for it: in most it is not there.
void warn_of_rare_light(Rendering& r, std::span<const GroupFindings> groups) {
  TechniqueTally techniques = groups.front().parts.front().techniques();
  for (const GroupFindings& group : groups.subspan(1))
    techniques.merge(group.parts.front().techniques());
  const std::uint64_t samples = tally_of(groups).samples;
  const std::vector<bool> without = without_rare_light(r.film, techniques, samples);
  std::size_t bins = 0, left = 0;
  for (std::size_t i = 0; i < without.size(); ++i) {
    if (!r.film.reliable[i]) continue;
    ++bins;
    left += without[i] ? 1 : 0;
  }
  if (2 * left >= bins) return;
  const SeldomSeen rare = seldom_seen(techniques, r.film, samples);
  r.warnings.push_back(fmt::format(
      "techniques (n, s) that found light in few samples, most of it {}, carry {} of the film: "
      "bins that have seen none of it may be called reliable and be too low; a larger budget finds "
      "more of it",
      rare.names, rare.share));
}

}  // namespace

void ChainFindings::normalize(Rendering& r) const {
  const NormalizationMethod wanted = parts_.front().settings.normalization;
  const std::vector<GroupFindings> groups = weighed_groups();
  Constants b = constants(groups);
  const NormalizationMethod method = b.usable(wanted);
  const bool has_parts = is_pooled() && r.samples > 0;
  if (has_parts) b.pooled = pooled_constant(groups, groups_of_runs());
  r.normalization = normalization(groups, b, method);
  if (has_parts) {
    PooledFilm pooled = pooled_film(b[method], groups);
    r.film = std::move(pooled.film);
    r.normalization->by_length = pooled_lengths(groups, groups_of_runs(), b[method]);
    warn_of_rare_light(r, groups);
    r.pooling = {groups.front().parts.front().pooling(), tally_of(groups).samples,
                 pooled.light_of_samples, std::move(pooled.of_samples), class_records(groups)};
    r.chains_film = chains_film(method, b[method], groups);
  } else {
    r.film = chains_film(method, b[method], groups);
  }
  if (b[method].effective_samples < fewest_effective_samples)
    r.film.reliable.assign(r.film.reliable.size(), false);
  doubt_what_was_not_met(r, must_meet_, tally_of(groups).ends_met, tally_of(groups).samples);
  if (std::string few = dominated_film(r.film, r.groups); !few.empty())
    r.warnings.push_back(std::move(few));
  if (method == NormalizationMethod::seed_pass && method != wanted)
    r.warnings.push_back("b is the mean of the seed pass, for the " + std::string(name_of(wanted)) +
                         " estimate failed: " + b[wanted].failure);
  if (std::string alarm = disagreement_of_constants(groups, b); !alarm.empty())
    r.warnings.push_back(std::move(alarm));
}

// ---- the chains

double ChainFindings::Part::steps_per_chain() const {
  return draws.chains() > 0 ? static_cast<double>(steps) / static_cast<double>(draws.chains()) : 0;
}

// Chains are compared over as many draws as the shortest has: those of runs that are less than half
// as long as the longest would take from all others what they know.
std::vector<const ChainFindings::Part*> ChainFindings::long_enough() const {
  double longest = 0;
  for (const Part& part : parts_) longest = std::max(longest, part.steps_per_chain());
  std::vector<const Part*> found;
  for (const Part& part : parts_)
    if (parts_.size() == 1 || 2 * part.steps_per_chain() >= longest) found.push_back(&part);
  return found;
}

void ChainFindings::judge(Rendering& r) const {
  const std::vector<const Part*> parts = long_enough();
  ChainDraws draws, even;  // of all chains; of as many chains of each group
  int fewest = parts.front()->settings.chains_per_group;
  for (const Part* part : parts) fewest = std::min(fewest, part->settings.chains_per_group);
  const auto count = static_cast<std::size_t>(fewest);
  for (const Part* part : parts) {
    draws.add(part->draws, 1, 1);
    even.add(part->draws, count, static_cast<std::size_t>(part->settings.chains_per_group));
  }
  std::size_t all_chains = 0, all_groups = 0;  // that have draws
  for (const Part& part : parts_) {
    all_chains += part.draws.chains();
    all_groups += part.draws.chains() / static_cast<std::size_t>(part.settings.chains_per_group);
  }
  ChainsRecord chains;
  if (draws.chains() > 0) {
    chains = diagnostics(draws);
    chains.longest_rejection_run = statistics_.longest_rejection_run();
    r.chains_record = chains;
  }
  r.mutations = statistics_.records();
  if (draws.chains() < all_chains)
    r.warnings.push_back(fmt::format(
        "R-hat and the effective sample sizes are of {} of {} chains: the others are less than "
        "half as long as the longest",
        draws.chains(), all_chains));
  for (std::string& warning :
       warnings({tally_of(groups_), even, chains, statistics_, count, all_chains, all_groups,
                 1 - (r.pooling ? r.pooling->light_of_samples : 0)}))
    r.warnings.push_back(std::move(warning));
}

}  // namespace wander

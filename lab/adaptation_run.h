// Adapts the kernel of a run (mlt/run/adaptation.h): no more of it than the budget has to spare.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lab/copied_seeds.h"
#include "lab/pilot_run.h"
#include "mlt/run/adaptation.h"
#include "mlt/run/chain_settings.h"

namespace wander {

// The film of each group, window by window.
template <class Groups>
class Windows {
 public:
  explicit Windows(const Groups& groups) {
    for (const auto& group : groups) {
      const GroupFindings found = group->findings();
      films_.push_back(found.parts.empty() ? found.film : &found.parts.front().of_chains());
      all_.push_back(found.film);
    }
    before_.assign(films_.size(), std::vector<double>(films_.front()->bins()));
  }

  // The next one, of every group that has deposited anything.
  void add_to(WindowSpread& spread) {
    std::vector<double> shares(films_.front()->bins());
    ++count_;
    for (std::size_t g = 0; g < films_.size(); ++g) {
      double light = 0;
      for (const double weight : all_[g]->weights()) light += weight;
      if (!(light > 0)) continue;
      const double windows = count_ / light;
      std::vector<double> now = films_[g]->weights();
      for (std::size_t j = 0; j < shares.size(); ++j)
        shares[j] = (now[j] - before_[g][j]) * windows;
      before_[g] = std::move(now);
      spread.add(shares);
    }
  }

 private:
  std::vector<const GroupFilm*> films_, all_;  // of what is asked, and of all that is deposited
  std::vector<std::vector<double>> before_;
  double count_ = 0;
};

// What their samples found.
template <class Groups>
Pilot samples_of(const Groups& groups) {
  Pilot found;
  for (const auto& group : groups) {
    found.samples += static_cast<double>(group->tally().samples);
    found.rays += static_cast<double>(group->tally().rays);
    for (const RatioHistogram& stratum : group->findings().evidence->ratios)
      found.found.add(stratum, 1);
  }
  return found;
}

class AdaptationBudget {
 public:
  explicit AdaptationBudget(const Run& run) : run_(run), begin_(run.spent()) {}

  // Of all chains of one factor together; 0: the budget is too small.
  std::uint64_t steps() const {
    constexpr double share = 1. / 128, fewest = 1 << 12, most = 1 << 15;
    const auto expected = expected_steps(run_);
    const double steps = expected ? share * *expected : most;
    return steps < fewest ? 0 : static_cast<std::uint64_t>(std::min(steps, most));
  }
  bool is_over() const {
    constexpr double share = 0.05;
    const auto* time = std::get_if<TimeBudget>(&run_.session().budget);
    return run_.is_interrupted() || (time && run_.spent() - begin_ > share * time->seconds);
  }

 private:
  const Run& run_;
  double begin_;
};

// `make(factor)`: ChainGroups with one chain each, whose small moves go so many times as far and of
// which nothing has been made.  All chains start from the same seeds.  `parts`: of which film, of so
// many bins.
template <class Make>
class AdaptationRun {
 public:
  AdaptationRun(const Make& make, FilmParts parts, std::size_t bins, const Run& run)
      : make_(make), parts_(parts), bins_(bins), run_(run), budget_(run) {}

  // The usual factor, with nothing tried, where the budget or the light does not suffice.
  Adaptation run() {
    KernelSearch search;
    if (budget_.steps() == 0 || !make_seeds()) return search.found();
    while (const auto factor = search.next()) {
      const auto groups = started(*factor);
      const std::optional<double> spread = spread_of(*groups);
      if (!spread) break;
      search.tell(*spread);
    }
    return search.found();
  }

 private:
  // False: they do not tell enough.
  bool make_seeds() {
    constexpr std::uint64_t per_round = 1 << 11, most = 1 << 13;
    const auto groups = make_(1);
    Pilot found;
    const std::uint64_t of_each = std::min(per_round / groups->count(), groups->seed_stride());
    for (std::uint64_t made = 0;
         made < most && found.rays < ChainSettings::most_rays && !is_telling(found);
         made += of_each * groups->count()) {
      if (budget_.is_over()) return false;
      groups->add_seeds(of_each);
      found = samples_of(*groups);
    }
    if (!is_telling(found)) return false;
    if (parts_ == FilmParts::pooled)
      pooling_ = Pooling{.partition = best_pooling(found, bins_).partition};
    seeds_ = CopiedSeeds(*groups);
    return true;
  }

  auto started(double factor) const {
    auto groups = make_(factor);
    seeds_.give(*groups);
    if (pooling_) groups->pool(*pooling_);
    groups->start(1);
    return groups;
  }

  // None, if the time is over before.
  template <class Groups>
  std::optional<double> spread_of(Groups& groups) const {
    Windows<Groups> windows(groups);
    WindowSpread spread((*groups.begin())->findings().film->bins());
    const std::uint64_t window = steps_of_window * groups.active();
    for (std::uint64_t done = 0; done + window <= budget_.steps(); done += window) {
      for (const std::uint64_t goal = groups.steps() + window; groups.steps() < goal;) {
        if (budget_.is_over()) return std::nullopt;
        groups.advance_to(std::min(goal, groups.steps() + groups.step_stride()));
      }
      windows.add_to(spread);
    }
    return spread.value();
  }

  const Make& make_;
  FilmParts parts_;
  std::size_t bins_;
  const Run& run_;
  AdaptationBudget budget_;
  std::optional<Pooling> pooling_;
  CopiedSeeds seeds_;
};

}  // namespace wander

// Makes the pilot of a run (mlt/run/pilot.h): no more of it than the budget has to spare.
#pragma once

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

#include "mlt/run/pilot.h"
#include "work/parallel.h"

namespace wander {

// Few chains, so that they are long.
inline constexpr int chains_of_pilot = 16;

// How many steps a run may make, all chains together; none where that is not known.
inline std::optional<double> expected_steps(const Run& run) {
  constexpr double steps_per_second = 1e6;  // of a processor
  const Budget& budget = run.session().budget;
  if (const auto* samples = std::get_if<SampleBudget>(&budget))
    return static_cast<double>(samples->samples);
  const auto* time = std::get_if<TimeBudget>(&budget);
  if (!time) return {};
  const double processors = time->kind == TimeKind::wall ? run.threads() : 1;
  return steps_per_second * processors * time->seconds;
}

class PilotBudget {
 public:
  explicit PilotBudget(const Run& run) : run_(run), begin_(run.spent()) {}

  // A part of a budget of time may be spent so far; and nothing when the run is interrupted.
  bool is_over(double share) const {
    const auto* time = std::get_if<TimeBudget>(&run_.session().budget);
    return run_.is_interrupted() || (time && run_.spent() - begin_ > share * time->seconds);
  }
  // Of all chains together.
  std::uint64_t steps() const {
    constexpr double share = 1. / 32, fewest = 1 << 12, most = 1 << 18;
    const auto expected = expected_steps(run_);
    return static_cast<std::uint64_t>(
        std::clamp(expected ? share * *expected : most, fewest, most));
  }

 private:
  const Run& run_;
  double begin_;
};

template <class Groups>
Pilot found_by(const Groups& groups, std::uint64_t steps) {
  std::vector<GroupFindings> found;
  double rays = 0;
  for (const auto& group : groups) {
    found.push_back(group->findings());
    rays += static_cast<double>(group->rays());
  }
  return pilot_of(found, rays, steps);
}

// `trial`: ChainGroups with one chain each, of which nothing has been made.  Samples until they tell
// enough, then steps.
// `steps_per_chain`: of the run.
template <class Groups>
Pilot make_pilot(Groups& trial, const Run& run, double steps_per_chain) {
  constexpr std::uint64_t samples_per_round = 1 << 11, enough = 1 << 13, most = 1 << 15,
                          steps_per_round = 1 << 11;
  // Of a budget of time.
  constexpr double share_of_samples = 0.05, share_of_early = 0.07, share_of_all = 0.1;
  const PilotBudget budget(run);
  Pilot pilot;
  for (std::uint64_t made = 0; made < most && !budget.is_over(share_of_samples);) {
    trial.add_seeds(samples_per_round / trial.count());
    made += samples_per_round;
    pilot = found_by(trial, 0);
    if (made >= enough && tells_enough(pilot)) break;
  }
  if (!is_telling(pilot)) return pilot;
  for (const double c : borders_around(pilot.b())) trial.pool({.partition = {c}});
  trial.start(1);
  const auto pilot_to = [&](std::uint64_t steps, double share) {
    while (trial.steps() < steps && !budget.is_over(share))
      trial.advance_to(std::min(steps, trial.steps() + steps_per_round));
    return found_by(trial, trial.steps() / trial.active());
  };
  const Pilot early = pilot_to(budget.steps() / 4, share_of_early);
  return extrapolated(early, pilot_to(budget.steps(), share_of_all), steps_per_chain);
}

}  // namespace wander

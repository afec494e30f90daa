// Makes the pilot of a run (mlt/run/pilot.h): no more of it than the budget has to spare.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "lab/copied_seeds.h"
#include "mlt/run/chain_settings.h"
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
  PilotBudget(const Run& run, std::span<const int> resolution)
      : run_(run), is_of_image_(resolution.size() > 1), begin_(run.spent()) {}

  // A part of a budget of time may be spent so far; and nothing when the run is interrupted.
  bool is_over(double share) const {
    const auto* time = std::get_if<TimeBudget>(&run_.session().budget);
    return is_interrupted() || (time && spent() > share * time->seconds);
  }
  bool is_interrupted() const { return run_.is_interrupted(); }
  // What is spent between the two is spent on something else.
  void pause() { paused_ = run_.spent(); }
  void go_on() { begin_ += run_.spent() - paused_; }
  // Of all chains together.  Of an image it takes more to know how they differ, for its pixels are many and
  // its dark parts seldom visited.
  std::uint64_t steps() const {
    constexpr double fewest = 1 << 12;
    const double share = is_of_image_ ? 1. / 10 : 1. / 32, most = is_of_image_ ? 1 << 19 : 1 << 18;
    const auto expected = expected_steps(run_);
    return static_cast<std::uint64_t>(
        std::clamp(expected ? share * *expected : most, fewest, most));
  }

 private:
  double spent() const { return run_.spent() - begin_; }

  const Run& run_;
  bool is_of_image_;
  double begin_, paused_ = 0;
};

template <class Groups>
std::vector<TrialFindings> findings_of(const Groups& groups) {
  std::vector<TrialFindings> found;
  for (const auto& group : groups) found.push_back(group->findings());
  return found;
}

// A trial of chains and samples in a space: first the samples, and if these cannot decide, the chains.
// `make(kernel)`: ChainGroups of TrialGroup with one chain each, of which nothing has been made.
template <class Make>
class PilotRun {
 public:
  PilotRun(const Make& make, double kernel, std::span<const int> resolution, const Run& run)
      : make_(make),
        kernel_(kernel),
        resolution_(resolution),
        budget_(run, resolution),
        trial_(make_(kernel)) {
    make_samples();
    budget_.pause();
  }

  // Until they told enough.
  const Pilot& samples() const { return samples_; }

  // And then steps, with a kernel that may have been found since: the samples are the same.
  // `steps_per_chain`: of the run.  Where is_decided(pilot) of a quarter of the steps, the rest is not made.
  template <class Decided>
  Pilot with_chains(double kernel, double steps_per_chain, Decided&& is_decided) {
    budget_.go_on();
    if (kernel != kernel_) {
      const CopiedSeeds seeds(*trial_);
      trial_ = make_(kernel);
      seeds.give(*trial_);
    }
    if (!is_telling(samples_) || budget_.is_interrupted()) return samples_;
    const BinWorth worth(resolution_, findings_of(*trial_));
    trial_->start(1);
    make_steps(budget_.steps() / 4, share_of_early);
    const Pilot early = found_by(worth);
    if (trial_->steps() >= budget_.steps() / 4)
      if (Pilot so_far = extrapolated({}, early, steps_per_chain); is_decided(so_far))
        return so_far;
    make_steps(budget_.steps(), share_of_all);
    return extrapolated(early, found_by(worth), steps_per_chain);
  }

 private:
  static constexpr std::uint64_t samples_per_round = 1 << 11, enough = 1 << 13,
                                 steps_per_round = 1 << 11;
  // Of a budget of time.
  static constexpr double share_of_samples = 0.05, share_of_early = 0.07, share_of_all = 0.1;

  void make_samples() {
    const std::uint64_t of_each =
        std::min(samples_per_round / trial_->count(), trial_->seed_stride());
    for (std::uint64_t made = 0; made < most_samples_of_a_pilot &&
                                 samples_.rays < ChainSettings::most_rays &&
                                 !budget_.is_over(share_of_samples);) {
      trial_->add_seeds(of_each);
      made += of_each * trial_->count();
      samples_ = found_by(BinWorth(resolution_, findings_of(*trial_)));
      if (made >= enough && tells_enough(samples_)) break;
    }
  }
  void make_steps(std::uint64_t steps, double share) {
    const std::uint64_t of_each = std::min(steps_per_round, trial_->step_stride());
    while (trial_->steps() < steps && !budget_.is_over(share))
      trial_->advance_to(std::min(steps, trial_->steps() + of_each));
  }
  // Nothing, once the run is interrupted: it may take a while where paths are long.
  Pilot found_by(const BinWorth& worth) const {
    if (budget_.is_interrupted()) return {};
    PilotSteps of_each;
    if (const std::uint64_t active = trial_->active(); active > 0)
      of_each = {trial_->steps() / active, budget_.steps() / active};
    Pilot pilot =
        pilot_of(findings_of(*trial_), worth, of_each, [this] { return budget_.is_interrupted(); });
    if (resolution_.size() > 1) pilot.rays_per_step = rays_per_step_in_space;
    return pilot;
  }

  const Make& make_;
  double kernel_;
  std::span<const int> resolution_;
  PilotBudget budget_;
  std::invoke_result_t<Make, double> trial_;
  Pilot samples_;
};

}  // namespace wander

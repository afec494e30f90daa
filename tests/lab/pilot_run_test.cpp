// When a pilot hears an interrupt: before its chains start, and between their steps and the weighing of what they
// found.  Trials that count what is asked of them, and find the same light with every sample.
#include "lab/pilot_run.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace wander::test::pilot_run {
namespace {

constexpr std::array resolution{8};
constexpr std::uint64_t groups = 2;

class CountedGroup {
 public:
  void add_seeds(std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i)
      log_.found.push_back({log_.samples++, static_cast<int>(i % resolution[0]), 1, 1});
  }
  void advance() { log_.states.push_back({0, 0, 1}); }
  TrialFindings findings() const { return {&log_, 4.0 * log_.samples, {1.0}}; }

 private:
  TrialLog log_;
};

class CountedTrial {
 public:
  // Interrupted by the first of its steps, if there is what to raise.
  explicit CountedTrial(std::atomic<bool>* raised) : raised_(raised) {
    for (std::uint64_t g = 0; g < groups; ++g) groups_.push_back(std::make_unique<CountedGroup>());
  }

  auto begin() const { return groups_.begin(); }
  auto end() const { return groups_.end(); }
  std::uint64_t count() const { return groups; }
  std::uint64_t seed_stride() const { return 256; }
  static constexpr std::uint64_t of_long_paths = 64;
  std::uint64_t step_stride() const { return of_long_paths; }
  void add_seeds(std::uint64_t count) {
    for (const auto& group : groups_) group->add_seeds(count);
  }
  void start(int) { is_started_ = true; }
  bool is_started() const { return is_started_; }
  std::uint64_t active() const { return is_started_ ? groups : 0; }
  std::uint64_t steps() const { return steps_; }
  void advance_to(std::uint64_t target) {
    for (const auto& group : groups_) group->advance();
    steps_ = target;
    if (raised_) *raised_ = true;
  }
  template <class Archive>
  void serialize_seeds(Archive&) {}

 private:
  std::vector<std::unique_ptr<CountedGroup>> groups_;
  std::atomic<bool>* raised_;
  bool is_started_ = false;
  std::uint64_t steps_ = 0;
};

struct Outcome {
  Pilot pilot;
  bool is_started;
  std::uint64_t steps;
};

const auto never = [](const Pilot&) { return false; };

// What a pilot finds, if `before_chains` raises what interrupts it, or its first step does.
template <class BeforeChains>
Outcome outcome(std::atomic<bool>& interrupted, std::atomic<bool>* raised_by_step,
                BeforeChains&& before_chains, const std::function<bool(const Pilot&)>& is_decided) {
  Session session;
  session.budget = SampleBudget{1'000'000};
  session.threads = 1;
  session.interrupted = &interrupted;
  const Run run(session);
  const CountedTrial* made = nullptr;
  const auto make = [&](double) {
    auto trial = std::make_unique<CountedTrial>(raised_by_step);
    made = trial.get();
    return trial;
  };
  PilotRun pilot(make, 1, resolution, run);
  before_chains();
  Pilot found = pilot.with_chains(1, 1000, is_decided);
  return {std::move(found), made->is_started(), made->steps()};
}

TEST(PilotRun, TellsWhatItsChainsFound) {
  std::atomic<bool> interrupted = false;
  const Outcome all = outcome(
      interrupted, nullptr, [] {}, never);
  EXPECT_TRUE(all.is_started);
  EXPECT_EQ(all.steps, 1'000'000 / 32);
  EXPECT_EQ(all.pilot.chains.size(), groups);
  EXPECT_FALSE(all.pilot.borders.empty());
}

TEST(PilotRun, EndsAfterAQuarterOfItsStepsWhereTheseDecide) {
  std::atomic<bool> interrupted = false;
  bool is_asked = false;
  const auto decided = [&](const Pilot& early) { return is_asked = !early.borders.empty(); };
  const Outcome early = outcome(
      interrupted, nullptr, [] {}, decided);
  EXPECT_TRUE(is_asked);
  EXPECT_EQ(early.steps, 1'000'000 / 32 / 4);
  EXPECT_EQ(early.pilot.steps_per_chain, 1000) << "of the run";
}

TEST(PilotRun, StartsNoChainsOnceItIsInterrupted) {
  std::atomic<bool> interrupted = false;
  const Outcome early = outcome(
      interrupted, nullptr, [&] { interrupted = true; }, never);
  EXPECT_FALSE(early.is_started);
  EXPECT_GT(early.pilot.samples, 0);
}

TEST(PilotRun, WeighsNothingOnceItIsInterrupted) {
  std::atomic<bool> interrupted = false;
  const Outcome stopped = outcome(
      interrupted, &interrupted, [] {}, never);
  EXPECT_TRUE(stopped.is_started);
  EXPECT_LE(stopped.steps, CountedTrial::of_long_paths);
  EXPECT_EQ(stopped.pilot.samples, 0);
  EXPECT_TRUE(stopped.pilot.borders.empty());
}

}  // namespace
}  // namespace wander::test::pilot_run

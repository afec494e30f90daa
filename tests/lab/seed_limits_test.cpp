// How many samples a seed pass makes where they are dear: as many as a share asks for, and of those that
// nobody asked for no more than cost a bounded number of rays.  A run that counts, and does nothing else.
#include <gtest/gtest.h>

#include <atomic>

#include "mlt/run/chain_settings.h"
#include "tests/lab/counting_run.h"

namespace wander::test::seed_limits {
namespace {

constexpr std::uint64_t slices = CountingRun::slices;

// By the first of its samples.
class InterruptedRun final : public CountingRun {
 public:
  explicit InterruptedRun(std::atomic<bool>& interrupted)
      : CountingRun(30, 0), interrupted_(interrupted) {}

  void seed(std::uint64_t of_each) override {
    CountingRun::seed(of_each);
    interrupted_ = true;
  }

 private:
  std::atomic<bool>& interrupted_;
};

// How many chains of each group start.
int chains_of(CountingRun& run, const std::atomic<bool>& interrupted) {
  Session session;
  session.budget = SampleBudget{100'000'000};
  session.threads = 1;
  session.interrupted = &interrupted;
  Run execution(session);
  drive(run, execution);
  return run.chains();
}

std::uint64_t seeds_of(const Budget& budget, std::uint64_t rays_per_sample, double share = 0) {
  CountingRun run(rays_per_sample, share);
  Session session;
  session.budget = budget;
  session.threads = 1;
  Run execution(session);
  drive(run, execution);
  return run.seeds().samples;
}

constexpr std::uint64_t most_rays = ChainSettings::most_rays, fewest = ChainSettings{}.fewest_seeds;

TEST(SeedLimits, AreTheFewestWhereSamplesCostLittle) {
  EXPECT_EQ(seeds_of(SampleBudget{1000}, most_rays / fewest), fewest);
  EXPECT_EQ(seeds_of(SampleBudget{1000}, 30), fewest);
}

TEST(SeedLimits, AreWhatTheRaysSufficeFor) {
  EXPECT_EQ(seeds_of(SampleBudget{1000}, 4096), most_rays / 4096);
  EXPECT_EQ(seeds_of(SampleBudget{1000}, 1 << 20), 8 * slices) << "some of each slice";
}

// And end with a stride.
TEST(SeedLimits, AreNoLessThanAShareAsksFor) {
  for (const std::uint64_t steps : {20'000U, 100'000U}) {
    const std::uint64_t seeds = seeds_of(SampleBudget{steps}, 1 << 20, 0.25);
    EXPECT_GE(seeds, steps / 4 / slices * slices);
    EXPECT_LT(seeds, steps / 4 + CountingRun::samples_per_stride * slices);
  }
}

// An error that the first look does not meet takes what it takes.
TEST(SeedLimits, OfAnErrorHoldForTheFirstLookAlone) {
  EXPECT_EQ(seeds_of(ErrorBudget{0.5}, 4096), most_rays / 4096);
  for (const std::uint64_t rays_per_sample : {4096U, 1U << 20}) {
    const std::uint64_t seeds = seeds_of(ErrorBudget{0.1}, rays_per_sample);
    EXPECT_GE(seeds, 40'000U - 1) << "where the error is half of what was asked for";
    EXPECT_LT(seeds, 41'000U);
  }
}

// Thousands of long paths take seconds to start, and the run goes on from its seeds.
TEST(SeedPass, IsShownByOneChainOfEachGroupIfItIsInterrupted) {
  std::atomic<bool> interrupted = false;
  CountingRun whole(30, 0);
  EXPECT_GT(chains_of(whole, interrupted), 1);
  InterruptedRun run(interrupted);
  EXPECT_EQ(chains_of(run, interrupted), 1);
}

}  // namespace
}  // namespace wander::test::seed_limits

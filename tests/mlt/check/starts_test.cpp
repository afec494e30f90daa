// Where tests of kernels start: paths of samples under roulette, measured as those of a space without it.
#include "mlt/check/starts.h"

#include <gtest/gtest.h>

#include "core/techniques.h"
#include "tests/support/path_equality.h"
#include "tests/support/test_scenes.h"

namespace wander::test::starts_test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

constexpr std::uint64_t seed = 3, samples = 20'000;

// A sample of which all light is one path weighs what its clipped ratio says, or the average, if the
// roulette has raised it to that.
TEST(Starts, WeighWhatTheClippedRatioOfTheirPathSays) {
  const FlatScene scene = build(mirror_and_glass());
  const Flat space(*scene, Roulette::off);
  Starts<Flat> starts(space, seed);
  PathSampler<Flat> sampler(space.with(Roulette::by_albedo), all_techniques, Heuristic::balance);
  Rng numbers(seed, Purpose::test, 0);
  int alone = 0, raised = 0;
  double average = 0;
  for (std::uint64_t i = 0; i < samples; ++i) {
    const double weight = starts.draw(i);
    if (weight == 0) continue;
    int paths = 0;
    numbers.start(i);
    sampler.sample(numbers, [&](const JoinedPath<W>&, int, double) { ++paths; });
    if (paths != 1) continue;
    Path<W> x = starts.path();
    weigh(space, x);
    const double ratio = (x.contribution / x.intensity_under_roulette).value();
    const double clip = starts.clip(x);
    ++alone;
    if (std::abs(weight - ratio * clip) <= 1e-9 * weight) continue;
    EXPECT_LT(ratio * clip, weight) << i;
    if (raised++ == 0) average = weight;
    EXPECT_EQ(weight, average) << i;
  }
  EXPECT_GT(alone, 1000);
  EXPECT_LT(raised, alone);
}

// Bright paths all weigh the same bound.
TEST(Starts, AreClippedByTheirRatioUnderRoulette) {
  const FlatScene scene = build(mirror_and_glass());
  const Flat space(*scene, Roulette::off);
  Starts<Flat> starts(space, seed);
  double bound = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    if (starts.draw(i) == 0) continue;
    Path<W> x = starts.path();
    weigh(space, x);
    EXPECT_EQ(starts.clip(x), 1) << i;
    x.contribution = x.contribution * 1e9;
    const double clipped = starts.clip(x) * (x.contribution / x.intensity_under_roulette).value();
    if (bound == 0) bound = clipped;
    EXPECT_NEAR(clipped, bound, 1e-9 * bound) << i;
  }
  EXPECT_GT(bound, 0);
}

TEST(Starts, AreMeasuredWithoutRoulette) {
  const FlatScene scene = build(mirror_and_glass());
  const Flat space(*scene, Roulette::off);
  Starts<Flat> starts(space, seed);
  int seen = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    if (starts.draw(i) == 0) continue;
    Path<W> x = starts.path();
    for (int k = 0; k < x.size(); ++k) space.evaluate(x, k);
    ASSERT_TRUE(identical(x, starts.path())) << i;
    ++seen;
  }
  EXPECT_GT(seen, 300);
}

}  // namespace
}  // namespace wander::test::starts_test

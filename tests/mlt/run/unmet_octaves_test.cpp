// What a bridge makes of octaves of l that samples found and chains did not meet: their light is what samples say, beside the
// bridge of all others.  Exact, for the same sides are asked with and without them.
#include <gtest/gtest.h>

#include <cmath>

#include "mlt/run/bridge.h"
#include "tests/mlt/run/bridge_sides.h"

namespace wander::test::unmet_octaves_test {
namespace {

using bridge_sides::Sides;

constexpr double rare = 0x1p30;  // l far above all others
constexpr bridge_sides::Model usual{.sigma = 1, .samples = 20'000, .states = 32'000};

// Each of `events` groups found one path of l `rare`, and each of `met` has so many states there.
Sides sides_with(int events, int met, int states) {
  Sides sides = bridge_sides::simulate(usual, 1);
  for (int g = 0; g < events; ++g) sides.found[static_cast<std::size_t>(3 * g)].add(rare);
  for (int g = 0; g < met; ++g)
    for (int i = 0; i < states; ++i)
      sides.states[static_cast<std::size_t>(bridge_sides::groups - 1 - g)].add(rare);
  return sides;
}
double rare_light(int events, int groups) { return events * rare / (625.0 * groups); }

void expect_sum(const BridgeFit& fit, const BridgeFit& without_rare, int events) {
  ASSERT_TRUE(fit.failure.empty()) << fit.failure;
  constexpr int groups = bridge_sides::groups;
  EXPECT_NEAR(fit.b / (without_rare.b + rare_light(events, groups)), 1, 1e-7);
  for (int g = 0; g < groups; ++g) {
    const bool found = g % 3 == 0 && g < 3 * events;
    const auto k = static_cast<std::size_t>(g);
    const double expected =
        without_rare.without[k] + rare_light(found ? events - 1 : events, groups - 1);
    EXPECT_NEAR(fit.without[k] / expected, 1, 1e-7) << g;
  }
}

TEST(UnmetOctaves, AreWhatSamplesSayWhereNoGroupOrOneMetThem) {
  const BridgeFit plain = bridge(sides_with(0, 0, 0).data());
  for (const int met : {0, 1}) expect_sum(bridge(sides_with(3, met, 40).data()), plain, 3);
}

// The three events are nearly all of the light, and as many tell it as there are.
TEST(UnmetOctaves, AreKnownByTheEventsThatFoundThem) {
  const BridgeFit fit = bridge(sides_with(3, 0, 0).data());
  // Σ d² of three groups of 32 that have a third each: 3 (1/3)² - 1/32.
  EXPECT_NEAR(fit.effective_samples, 1 / (1.0 / 3 - 1.0 / 32), 0.01);
  const double error = jackknife_error(fit.without);
  EXPECT_NEAR(error * error / (fit.b * fit.b), (1.0 / 3 - 1.0 / 32) * 32 / 31, 0.01);
}

// Where two groups met it they and the others tell; chains that saw all of it in so many states leave less than a
// hundredth of what samples say.
TEST(UnmetOctaves, AreBridgedWhereTwoGroupsMetThem) {
  const BridgeFit fit = bridge(sides_with(3, 2, 40).data());
  EXPECT_LT(fit.b, 0.01 * rare_light(3, bridge_sides::groups));
}

// Of less light than two states of each group show, their lack tells nothing; a group has a thousand.
TEST(UnmetOctaves, AreBridgedWhereHardlyAnyStateIsExpected) {
  constexpr bridge_sides::Model narrow{.sigma = 0.3, .samples = 20'000, .states = 32'000};
  for (const double share : {0.0019, 0.0021}) {
    Sides sides = bridge_sides::simulate(narrow, 1);
    const double before = bridge(sides.data()).b;
    const double light = share / (1 - share) * sides.direct;
    sides.found[5].add(light * 20'000);
    const double change = bridge(sides.data()).b - before;
    if (share > 0.002)
      EXPECT_NEAR(change / light, 1, 1e-5);
    else
      EXPECT_LT(change, 0.9 * light);
  }
}

}  // namespace
}  // namespace wander::test::unmet_octaves_test

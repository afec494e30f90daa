// What a test of invariance would have seen, from sums that are written out.
#include <gtest/gtest.h>

#include <cmath>

#include "mlt/check/invariance.h"
#include "statistics/visible_error.h"

namespace wander::test {
namespace {

// 200 starts of weight 1 where a function is 1/2; 160 of them go up or down by a quarter.
TEST(VisibleDeviations, AreRelativeToWhatTheStartsHold) {
  constexpr std::size_t function = 3;
  Deviations deviations;
  FunctionValues before{}, up{}, down{};
  before[function] = 0.5;
  up[function] = 0.75;
  down[function] = 0.25;
  for (int i = 0; i < 200; ++i) {
    deviations.add_level(before, 1);
    if (i < 160) deviations.add(before, i % 2 == 0 ? up : down, 1);
  }
  const Decision decision = deviations.decide(1, 1e-6);
  ASSERT_EQ(decision.comparisons, 1);
  EXPECT_EQ(decision.worst, function);
  EXPECT_NEAR(decision.visible, visible_sum(160 / 16.0, 1, decision.threshold) / 100, 1e-12);
}

// There 60 and back 40: an error of both relative to 50.
TEST(VisibleDeviations, OfFluxAreRelativeToItsMean) {
  Flux flux;
  for (int i = 0; i < 60; ++i) flux.add(1, 2, 1);
  for (int i = 0; i < 40; ++i) flux.add(2, 1, 1);
  const Decision decision = flux.decide(1, 1e-6);
  ASSERT_EQ(decision.comparisons, 1);
  EXPECT_NEAR(decision.visible, visible_sum(100, 1, decision.threshold) / 50, 1e-12);
}

TEST(VisibleDeviations, AreNotKnownWhereNothingMoved) {
  EXPECT_TRUE(std::isnan(Deviations().decide(1, 1e-6).visible));
}

}  // namespace
}  // namespace wander::test

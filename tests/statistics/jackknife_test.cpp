// The jackknife of means and of ratios, whose errors are known.
#include "statistics/jackknife.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wander::test {
namespace {

TEST(Jackknife, OfAMeanIsTheStandardErrorOfTheMean) {
  const std::vector<double> x{3, 1, 4, 1, 5, 9, 2, 6};
  double sum = 0, squares = 0;
  for (const double v : x) sum += v;
  std::vector<double> without;
  for (const double v : x) {
    without.push_back((sum - v) / 7);
    squares += (v - sum / 8) * (v - sum / 8);
  }
  EXPECT_DOUBLE_EQ(jackknife_error(without), std::sqrt(squares / (8 * 7)));
  EXPECT_TRUE(std::isnan(jackknife_error(std::vector<double>{1})));
}

TEST(Jackknife, HasAsManyDegreesOfFreedomAsGroupsThatMoveIt) {
  EXPECT_EQ(jackknife_degrees(std::vector<double>{2, 2, 2, 2}), 3);
  EXPECT_EQ(jackknife_degrees(std::vector<double>{8, 0, 0, 0}), 0);
  EXPECT_EQ(jackknife_degrees(std::vector<double>{5, 5, 0, 0}), 1);
  EXPECT_EQ(jackknife_degrees(std::vector<double>{0, 0, 0}), 2);
  EXPECT_EQ(jackknife_degrees(std::vector<double>{NAN, 1, 1}), 0);
}

TEST(RatioJackknife, SharesAWholeAndLeavesGroupsOut) {
  const std::vector<std::vector<double>> groups{{1, 3}, {2, 2}, {3, 1}};
  const RatioJackknife jackknife(groups);
  EXPECT_DOUBLE_EQ(jackknife.value(0), 6.0 / 12);
  EXPECT_DOUBLE_EQ(jackknife.without(0, 0), 5.0 / 8);
  EXPECT_DOUBLE_EQ(jackknife.without(1, 2), 5.0 / 8);
  // 5/8, 4/8, 3/8 times b: √(2/3 · 2/64) with b = 1.
  EXPECT_DOUBLE_EQ(jackknife.error(0, std::vector<double>{1, 1, 1}), std::sqrt(2.0 / 3 * 2 / 64));
  // b that moves against the share takes the error away.
  EXPECT_NEAR(jackknife.error(0, std::vector<double>{4.0 / 5, 1, 4.0 / 3}), 0, 1e-15);
}

TEST(RatioJackknife, WithoutTheOnlyGroupThatHoldsAnythingIsUnknown) {
  const std::vector<std::vector<double>> groups{{1, 3}, {0, 0}};
  const RatioJackknife jackknife(groups);
  EXPECT_TRUE(std::isnan(jackknife.without(0, 0)));
  EXPECT_DOUBLE_EQ(jackknife.without(0, 1), 0.25);
  EXPECT_TRUE(std::isnan(jackknife.error(0, std::vector<double>{1, 1})));
}

}  // namespace
}  // namespace wander::test

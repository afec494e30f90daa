// Quadrature: rules are exact up to their degree and no further, and the adaptive rule keeps what
// it promises at corners and jumps.
#include "tests/support/quadrature.h"

#include <gtest/gtest.h>

#include <numbers>

namespace wander::test {
namespace {

double power_integral(std::size_t points, int power) {
  const GaussRule& rule = gauss_rule(points);
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
  return sum;
}

TEST(Quadrature, GaussRulesAreExactToTheirDegreeAndNoFurther) {
  for (const std::size_t n : {1, 2, 3, 5, 8, 13, 30}) {
    const int degree = 2 * static_cast<int>(n) - 1;
    for (int k = 0; k <= degree; ++k) EXPECT_NEAR(power_integral(n, k), 1.0 / (k + 1), 1e-14) << n;
  }
  EXPECT_GT(std::abs(power_integral(3, 6) - 1.0 / 7), 1e-4);
}

TEST(Quadrature, TheAdaptiveRuleHandlesRootsAndJumps) {
  EXPECT_NEAR(integral([](double x) { return std::sqrt(x); }, 0, 1), 2.0 / 3, 1e-10);
  EXPECT_NEAR(integral([](double x) { return x < 1 / std::numbers::pi ? 1.0 : 0.0; }, 0, 1),
              1 / std::numbers::pi, 1e-10);
  EXPECT_NEAR(integral([](double x) { return std::sin(x); }, 0, std::numbers::pi), 2, 1e-13);
}

TEST(Quadrature, TheAdaptiveRuleWorksInTwoDimensions) {
  const auto disc = [](const std::array<double, 2>& x) {
    return x[0] * x[0] + x[1] * x[1] < 1 ? 1.0 : 0.0;
  };
  const Accuracy accuracy{1e-9, 11};
  EXPECT_NEAR(integral<2>(disc, Box<2>{{0, 0}, {1, 1}}, accuracy), std::numbers::pi / 4, 1e-5);
}

}  // namespace
}  // namespace wander::test

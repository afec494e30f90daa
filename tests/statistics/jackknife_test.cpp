// The jackknife of means and of ratios, whose errors are known.
#include "statistics/jackknife.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numeric>
#include <random>

#include "statistics/decision.h"

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

// θ = Σ w x / W; what is left is Σ w² (x - θ)² / (W (W - w)).
TEST(Jackknife, OfAWeightedMeanIsItsError) {
  const std::vector<double> x{3, 1, 4, 1, 5}, w{1, 2, 7, 2, 4};
  double total = 0, sum = 0, variance = 0;
  for (std::size_t g = 0; g < x.size(); ++g) {
    total += w[g];
    sum += w[g] * x[g];
  }
  std::vector<double> without;
  for (std::size_t g = 0; g < x.size(); ++g) {
    without.push_back((sum - w[g] * x[g]) / (total - w[g]));
    variance += std::pow(w[g] * (x[g] - sum / total), 2) / (total * (total - w[g]));
  }
  EXPECT_DOUBLE_EQ(jackknife_error(without, w), std::sqrt(variance));
  const std::vector<double> equal(x.size(), 0.3);
  EXPECT_DOUBLE_EQ(jackknife_error(without, equal), jackknife_error(without));
}

// Means of w independent numbers: the expectation of the square is the variance.  False alarm 1e-6;
// control: without the weights it is far from it.
TEST(Jackknife, OfGroupsOfUnequalSizesIsUnbiased) {
  const std::vector<double> w{1, 1, 2, 3, 5, 8, 13, 21};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Moments weighted, unweighted;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::vector<double> x, without;
    double total = 0, sum = 0;
    for (const double each : w) {
      x.push_back(normal(random) / std::sqrt(each));
      total += each;
      sum += each * x.back();
    }
    for (std::size_t g = 0; g < w.size(); ++g)
      without.push_back((sum - w[g] * x[g]) / (total - w[g]));
    weighted.add(total * std::pow(jackknife_error(without, w), 2));
    unweighted.add(total * std::pow(jackknife_error(without), 2));
  }
  EXPECT_NEAR(weighted.mean(), 1, 5 * weighted.standard_error());
  EXPECT_GT(std::abs(unweighted.mean() - 1), 20 * unweighted.standard_error());
}

// θ = (x̄ + c) (ȳ + c) of independent normal numbers of variance σ² and mean 0: Var θ = 2 c² σ²/G + σ⁴/G².
struct ProductOfMeans {
  double c;
  std::vector<double> x, y;

  double without(std::initializer_list<std::size_t> groups) const {
    double n = static_cast<double>(x.size());
    double a = std::accumulate(x.begin(), x.end(), 0.0),
           b = std::accumulate(y.begin(), y.end(), 0.0);
    for (const std::size_t g : groups) {
      a -= x[g];
      b -= y[g];
      --n;
    }
    return (a / n + c) * (b / n + c);
  }
};

// The claimed over the true variance of 1500 of them, known to 3 % or better.  False alarm 1e-6 each; what the
// jackknife claims alone is as far off as the theory says.
TEST(Jackknife, CountsProductsOfTwoGroupsOnce) {
  constexpr std::size_t groups = 64;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (const double c : {0.2, 0.3, 1.0}) {
    Moments once, twice;
    const double n = groups, truth = 2 * c * c / n + 1 / (n * n);
    for (int trial = 0; trial < 1500; ++trial) {
      ProductOfMeans theta{c, {}, {}};
      for (std::size_t g = 0; g < groups; ++g) {
        theta.x.push_back(normal(random));
        theta.y.push_back(normal(random));
      }
      std::vector<double> without;
      std::vector<LeftOutPair> pairs;
      for (std::size_t g = 0; g < groups; ++g) without.push_back(theta.without({g}));
      for (std::size_t g = 0; g < groups; ++g)
        for (const std::size_t apart : {1u, 3u, 5u, 7u}) {
          const std::size_t h = (g + apart) % groups;
          pairs.push_back({g, h, theta.without({g, h})});
        }
      twice.add(std::pow(jackknife_error(without), 2) / truth);
      count_products_once(without, theta.without({}), pairs);
      once.add(std::pow(jackknife_error(without), 2) / truth);
    }
    std::printf("  c %.1f: %.3f ± %.3f, alone %.3f\n", c, once.mean(), once.standard_error(),
                twice.mean());
    EXPECT_NEAR(once.mean(), 1, 0.02 + 5 * once.standard_error());
    EXPECT_NEAR(twice.mean(), 1 + 1 / (n * n) / truth, 0.03 + 5 * twice.standard_error());
  }
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

// A group of weight 2 whose numbers are twice as large as if it weighed 1.
TEST(RatioJackknife, WeighsItsErrorAsTheGroups) {
  const std::vector<std::vector<double>> groups{{1, 3}, {4, 4}, {3, 1}};
  const std::vector<double> weights{1, 2, 1}, b{1, 1, 1};
  const RatioJackknife jackknife(groups, weights);
  const std::vector<double> without{7.0 / 12, 4.0 / 8, 5.0 / 12};
  EXPECT_DOUBLE_EQ(jackknife.error(0, b), jackknife_error(without, weights));
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

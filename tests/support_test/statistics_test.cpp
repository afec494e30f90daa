// The decisions of statistics.h: published thresholds, calibration under a true hypothesis, and
// wrong twins that they must catch.  False-alarm rate of each calibration: 1e-7, seeds fixed.
#include "tests/support/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/expect.h"
#include "tests/support/generator.h"

namespace wander::test {
namespace {

constexpr double never = 1e-7;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Moments normal_sample(Generator& g, std::size_t n, double mean, double deviation) {
  Moments m;
  for (std::size_t i = 0; i < n; ++i) m.add(mean + deviation * g.normal());
  return m;
}

std::vector<double> counts_of_die(Generator& g, std::span<const double> pmf, std::size_t throws) {
  std::vector<double> counts(pmf.size(), 0.0);
  for (std::size_t i = 0; i < throws; ++i) {
    double u = g.uniform();
    std::size_t face = 0;
    while (face + 1 < pmf.size() && u >= pmf[face]) u -= pmf[face++];
    ++counts[face];
  }
  return counts;
}

// Of many decisions at a rate of 5 % under a true hypothesis, 5 % reject, and p is uniform.
void expect_calibrated(std::uint64_t seed, const std::function<Decision(Generator&)>& decide) {
  constexpr std::uint64_t repetitions = 2000;
  Generator g(seed);
  std::uint64_t rejections = 0;
  std::vector<double> p;
  for (std::uint64_t r = 0; r < repetitions; ++r) {
    const Decision d = decide(g);
    rejections += d.passed ? 0 : 1;
    p.push_back(d.p_value);
  }
  EXPECT_TRUE(passes(binomial_test(rejections, repetitions, 0.05, never)));
  EXPECT_TRUE(passes(uniformity_test(p, never)));
}

TEST(Statistics, SidakThresholdsAreThePublishedOnes) {
  EXPECT_NEAR(sidak_threshold(1e-6, 1), 4.89, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-6, 54), 5.63, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-6, 1000), 6.11, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-6, 100'000), 6.81, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-2, 1), 2.58, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-2, 54), 3.74, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-2, 1000), 4.42, 0.005);
  EXPECT_NEAR(sidak_threshold(1e-2, 100'000), 5.33, 0.005);
  EXPECT_GT(bonferroni_threshold(0.1, 10), sidak_threshold(0.1, 10));
}

TEST(Statistics, MergedMomentsAreThoseOfOneStream) {
  Generator g(1);
  Moments whole, first, second;
  for (int i = 0; i < 1000; ++i) {
    const double x = 1e6 + g.normal();
    whole.add(x);
    (i < 300 ? first : second).add(x);
  }
  first.merge(second);
  first.merge(Moments{});
  EXPECT_EQ(first.count(), 1000u);
  EXPECT_NEAR(first.mean(), whole.mean(), 1e-9);
  EXPECT_NEAR(first.variance() / whole.variance(), 1, 1e-9);
  const std::vector<double> few{1, 2, 4, 5};
  EXPECT_DOUBLE_EQ(Moments(few).mean(), 3);
  EXPECT_DOUBLE_EQ(Moments(few).variance(), 10.0 / 3);
}

TEST(Statistics, TheZTestRejectsAtItsRate) {
  expect_calibrated(2, [](Generator& g) { return z_test(3 + 0.1 * g.normal(), 0.1, 3, 0.05); });
}

TEST(Statistics, TheTTestRejectsAtItsRateWithFiveValues) {
  expect_calibrated(3, [](Generator& g) { return t_test(normal_sample(g, 5, 3, 2), 3, 0.05); });
}

TEST(Statistics, ThePairedTestRejectsAtItsRateThoughThePairsShareTheirNoise) {
  expect_calibrated(4, [](Generator& g) {
    std::vector<double> a, b;
    for (int i = 0; i < 8; ++i) {
      const double shared = 100 * g.normal();
      a.push_back(shared + g.normal());
      b.push_back(shared + g.normal());
    }
    return paired_t_test(a, b, 0.05);
  });
}

TEST(Statistics, AnErrorWithHardlyADegreeOfFreedomIsNoEvidence) {
  for (const double degrees : {0.0, 1e-300, 0.003, 0.05}) {
    EXPECT_GT(student_threshold(1e-9, degrees), 1e100) << degrees;
    const std::vector<Measurement> a{{1, 0.01, degrees}}, b{{2, 0.001, degrees}};
    EXPECT_TRUE(passes(welch_tests(a, b, 1e-9))) << degrees;
  }
  EXPECT_NEAR(student_threshold(0.05, 1), 12.706, 1e-3);
  EXPECT_EQ(student_two_sided_p(10, 0), 1);
  EXPECT_EQ(student_two_sided_p(nan, 5), 0);
}

TEST(Statistics, TheWelchTestRejectsAtItsRateWithUnequalVariances) {
  expect_calibrated(5, [](Generator& g) {
    const Moments a = normal_sample(g, 30, 1, 1), b = normal_sample(g, 20, 1, 5);
    return welch_test(a, b, 0.05);
  });
}

TEST(Statistics, ChiSquareRejectsAtItsRateWithThinCells) {
  std::vector<double> pmf(30), expected(30);
  double total = 0;
  for (std::size_t i = 0; i < pmf.size(); ++i)
    total += pmf[i] = std::exp(-0.3 * static_cast<double>(i));
  for (std::size_t i = 0; i < pmf.size(); ++i) expected[i] = 2000 * (pmf[i] /= total);
  expect_calibrated(6, [&](Generator& g) {
    return chi_square_test(counts_of_die(g, pmf, 2000), expected, 0.05);
  });
}

TEST(Statistics, FamiliesRejectAtTheirFamilyRate) {
  Generator g(7);
  constexpr std::uint64_t repetitions = 1000;
  std::uint64_t z_rejections = 0, bin_rejections = 0, welch_rejections = 0;
  const std::vector<double> exact(40, 2.0);
  for (std::uint64_t r = 0; r < repetitions; ++r) {
    std::vector<double> z;
    std::vector<Moments> a, b;
    for (int i = 0; i < 40; ++i) {
      z.push_back(g.normal());
      a.push_back(normal_sample(g, 12, 2, 1));
      b.push_back(normal_sample(g, 12, 2, 1));
    }
    z_rejections += largest_z_test(z, 0.05) ? 0 : 1;
    welch_rejections += bins_welch_test(a, b, 0.05) ? 0 : 1;
    // z from few values has heavier tails than normal: the bins test needs many values per bin.
    std::vector<Moments> thick;
    for (int i = 0; i < 40; ++i) thick.push_back(normal_sample(g, 400, 2, 1));
    bin_rejections += bins_z_test(thick, exact, 0.05) ? 0 : 1;
  }
  EXPECT_TRUE(passes(binomial_test(z_rejections, repetitions, 0.05, never)));
  EXPECT_TRUE(passes(binomial_test(welch_rejections, repetitions, 0.05, never)));
  EXPECT_TRUE(passes(binomial_test(bin_rejections, repetitions, 0.05, never)));
}

TEST(Statistics, AShiftedMeanIsCaught) {
  Generator g(8);
  const Moments shifted = normal_sample(g, 10'000, 3.08, 1), right = normal_sample(g, 10'000, 3, 1);
  EXPECT_TRUE(passes(z_test(right, 3, never)));
  EXPECT_TRUE(rejects(z_test(shifted, 3, never)));
  EXPECT_TRUE(rejects(t_test(shifted, 3, never)));
  EXPECT_TRUE(rejects(welch_test(shifted, right, never)));
}

TEST(Statistics, OneShiftedBinOfManyIsCaughtAndNamed) {
  Generator g(9);
  std::vector<Moments> bins, others;
  for (int i = 0; i < 100; ++i) {
    bins.push_back(normal_sample(g, 1000, i == 37 ? 2.3 : 2, 1));
    others.push_back(normal_sample(g, 1000, 2, 1));
  }
  const std::vector<double> exact(100, 2.0);
  EXPECT_TRUE(passes(bins_z_test(others, exact, never)));
  const Decision z = bins_z_test(bins, exact, never), welch = bins_welch_test(bins, others, never);
  EXPECT_TRUE(rejects(z));
  EXPECT_TRUE(rejects(welch));
  EXPECT_EQ(z.worst, 37u);
  EXPECT_EQ(welch.worst, 37u);
}

TEST(Statistics, ALoadedDieIsCaught) {
  Generator g(10);
  const std::vector<double> loaded{0.18, 0.164, 0.164, 0.164, 0.164, 0.164}, fair(6, 10'000.0);
  const Decision d = chi_square_test(counts_of_die(g, loaded, 60'000), fair, never);
  EXPECT_TRUE(rejects(d));
  EXPECT_EQ(d.worst, 0u);
}

TEST(Statistics, NonUniformValuesAreCaught) {
  Generator g(11);
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(std::pow(g.uniform(), 1.25));
  EXPECT_TRUE(rejects(uniformity_test(values, never)));
}

TEST(Statistics, ACoverageOfNinetyPercentIsNotTakenForNinetyFive) {
  EXPECT_TRUE(passes(binomial_test(952, 1000, 0.95, never)));
  EXPECT_TRUE(rejects(binomial_test(900, 1000, 0.95, never)));
}

TEST(Statistics, TheBinomialIntervalIsThatOfClopperAndPearson) {
  const ConfidenceInterval none = binomial_interval(0, 20, 0.95);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 1 - std::pow(0.025, 1.0 / 20), 1e-12);
  const ConfidenceInterval half = binomial_interval(5, 10, 0.95);
  EXPECT_NEAR(half.low, 0.1870860284, 1e-9);
  EXPECT_NEAR(half.high, 0.8129139716, 1e-9);
  EXPECT_EQ(binomial_interval(7, 7, 0.95).high, 1);
}

TEST(Statistics, WhatIsNotFiniteNeverPasses) {
  EXPECT_FALSE(z_test(nan, 1, 0, never));
  EXPECT_FALSE(z_test(1, std::numeric_limits<double>::infinity(), 0, never));
  EXPECT_FALSE(z_test(1, nan, 1, never));
  EXPECT_FALSE(largest_z_test(std::vector<double>{0, nan, 9}, never));
  EXPECT_FALSE(
      largest_z_test(std::vector<double>{0, std::numeric_limits<double>::infinity()}, never));
  Moments broken;
  for (const double x : {1.0, nan, 2.0}) broken.add(x);
  EXPECT_FALSE(t_test(broken, 1, never));
  EXPECT_FALSE(welch_test(broken, broken, never));
  EXPECT_FALSE(bins_z_test(std::vector<Moments>{broken}, std::vector<double>{1}, never));
  EXPECT_FALSE(bins_welch_test(std::vector<Moments>{broken}, std::vector<Moments>{broken}, never));
}

TEST(Statistics, WithoutSpreadOnlyTheExactValuePasses) {
  const std::vector<double> zeros(5, 0.0);
  EXPECT_TRUE(z_test(Moments(zeros), 0, never));
  EXPECT_FALSE(z_test(Moments(zeros), 1e-300, never));
  const std::vector<Moments> one_value{Moments(std::vector<double>{1})};
  EXPECT_FALSE(bins_z_test(one_value, std::vector<double>{1}, never));
}

TEST(Statistics, ACountWhereNoneIsExpectedFailsAtOnce) {
  const std::vector<double> expected{50, 0, 50};
  EXPECT_TRUE(chi_square_test(std::vector<double>{50, 0, 50}, expected, never));
  EXPECT_FALSE(chi_square_test(std::vector<double>{49, 1, 50}, expected, never));
  EXPECT_FALSE(
      chi_square_test(std::vector<double>{50, 0, 50}, std::vector<double>{50, nan, 50}, never));
  EXPECT_FALSE(chi_square_test(std::vector<double>{1, 1}, std::vector<double>{1, 1}, never));
}

TEST(Statistics, AFailureSaysWhichComparisonAndByHowMuch) {
  const std::string text = describe(largest_z_test(std::vector<double>{0.5, -9, 1}, 1e-6));
  EXPECT_NE(text.find("FAILED"), std::string::npos) << text;
  EXPECT_NE(text.find("statistic -9"), std::string::npos) << text;
  EXPECT_NE(text.find("worst of 3: number 1"), std::string::npos) << text;
}

}  // namespace
}  // namespace wander::test

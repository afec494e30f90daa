// The intervals of a mean square error cover it, whatever the errors of the bins have in common.
//
// Coverage is rejected where so few hits have a chance below the false-alarm rate if an interval
// holds the truth with `promised`: the laws are not the models of plausible.h, and the least that
// was measured is 0.94 (plausible.h has the table; plausible_long_test.cpp measures it).
#include "lab/compare/plausible.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/lab/compare/coverage.h"
#include "tests/support/statistics.h"

namespace wander::test::plausible_test {
namespace {

using compare::Draws;
using compare::Interval;

constexpr double promised = 0.93;

// Hits so few that they cannot be of intervals that keep the promise.
bool breaks_the_promise(const Coverage& coverage) {
  return binomial_interval(coverage.hits, coverage.trials, 1 - 2 * usual_false_alarm).high <
         promised;
}

TEST(Plausible, IntervalsOfAMeanSquareErrorCoverIt) {
  for (const ErrorLaw& law : error_laws())
    for (const std::size_t replicates : {4, 8}) {
      const Coverage coverage =
          coverage_of(interval_by_draws, law, {.replicates = replicates, .trials = 120});
      EXPECT_FALSE(breaks_the_promise(coverage))
          << law.name << ", " << replicates << " replicates: " << coverage.share();
    }
}

// A percentile bootstrap of few replicates does not, and the test sees it.
TEST(Plausible, APercentileBootstrapIsCaught) {
  const ErrorLaw& common = error_laws()[1];
  for (const std::size_t replicates : {4, 8})
    EXPECT_TRUE(breaks_the_promise(
        coverage_of(interval_by_bootstrap, common, {.replicates = replicates, .trials = 400})))
        << replicates;
}

TEST(Plausible, TwoAndThreeReplicatesAreHonest) {
  for (const std::size_t replicates : {2, 3}) {
    const Coverage coverage =
        coverage_of(interval_by_draws, error_laws()[1], {.replicates = replicates, .trials = 300});
    EXPECT_FALSE(breaks_the_promise(coverage)) << replicates << ": " << coverage.share();
  }
}

TEST(Plausible, OneReplicateHasNoInterval) {
  EXPECT_TRUE(compare::draws_of_mean(std::vector{1.0}, 0).empty());
  EXPECT_TRUE(std::isnan(compare::interval_of({}, 1).low));
}

TEST(Plausible, NothingOrTheSameIsCertain) {
  const Interval dark = compare::interval_of(compare::draws_of_mean(std::vector(4, 0.0), 0), 0);
  EXPECT_EQ(dark.low, 0);
  EXPECT_EQ(dark.high, 0);
  const Interval same = compare::interval_of(compare::draws_of_mean(std::vector(4, 2.0), 0), 2);
  EXPECT_NEAR(same.low, 2, 0.01);
  EXPECT_NEAR(same.high, 2, 0.01);
}

TEST(Plausible, SomeZerosGiveAFiniteInterval) {
  const Interval interval =
      compare::interval_of(compare::draws_of_mean(std::vector{0.0, 0.0, 0.0, 1.0}, 0), 0.25);
  EXPECT_GE(interval.low, 0);
  EXPECT_GT(interval.high, 1);
  EXPECT_TRUE(std::isfinite(interval.high));
}

// Draws do not depend on the unit.
TEST(Plausible, DrawsScaleWithTheirReplicates) {
  const Draws one = compare::draws_of_mean(std::vector{1.0, 2.0, 4.0}, 3);
  const Draws thousand = compare::draws_of_mean(std::vector{1000.0, 2000.0, 4000.0}, 3);
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_NEAR(thousand[i] / one[i], 1000, 1e-6 * 1000);
  EXPECT_NE(one, compare::draws_of_mean(std::vector{1.0, 2.0, 4.0}, 4));
}

TEST(Plausible, AnIntervalHoldsItsValueAndNamesNoInfinity) {
  const Draws draws = [] {
    Draws d(1000);
    for (std::size_t i = 0; i < d.size(); ++i) d[i] = static_cast<double>(i);
    return d;
  }();
  const Interval plain = compare::interval_of(draws, 500);
  EXPECT_EQ(plain.low, 25);
  EXPECT_EQ(plain.high, 975);
  EXPECT_EQ(compare::interval_of(draws, -3).low, -3);
  Draws open = draws;
  std::fill(open.begin(), open.begin() + 100, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(compare::interval_of(open, 500).high));
  std::fill(open.begin(), open.begin() + 100, not_known);
  EXPECT_TRUE(std::isnan(compare::interval_of(open, 500).low));
}

}  // namespace
}  // namespace wander::test::plausible_test

// What a report finds itself: the spread of seeds over their claims, light by path length, and
// numbers in few digits.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/film_statistics.h"
#include "core/rng.h"
#include "draw/report/energy.h"
#include "draw/report/numbers.h"
#include "draw/report/spread.h"
#include "draw/report/table.h"
#include "tests/support/statistics.h"

namespace wander::report {
namespace {

constexpr std::size_t replicates = 8, bins = 400;

// Films whose bins are normal with mean 5 and deviation 0.1, and claim `claimed` with ν degrees.
std::vector<compare::Run> normal_runs(double claimed, std::uint64_t seed) {
  std::vector<compare::Run> runs(replicates);
  for (std::size_t r = 0; r < replicates; ++r) {
    Rng rng(seed, Purpose::test, static_cast<std::uint32_t>(r));
    rng.start(0);
    FilmEstimate& film = runs[r].film;
    film.degrees_of_freedom = 1e6;
    for (std::size_t k = 0; k < bins; ++k) {
      const double u = 1 - rng.uniform();
      const double v = rng.uniform();
      film.value.push_back(5 +
                           0.1 * std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v));
      film.standard_error.push_back(claimed);
    }
  }
  return runs;
}

SeedSpread spread_of_films(const std::vector<compare::Run>& runs) {
  std::vector<const compare::Run*> pointers;
  for (const compare::Run& run : runs) pointers.push_back(&run);
  return spread_of(pointers);
}

// False alarms: 1e-9 of the exact binomial test, which allows for 95 % of independent bins.
TEST(SeedSpread, HoldsNineteenOfTwentyBinsWhereClaimsAreTrue) {
  const SeedSpread spread = spread_of_films(normal_runs(0.1, 11));
  ASSERT_EQ(spread.bins, bins);
  const Decision decision =
      test::binomial_test(spread.beyond, spread.bins, 0.05, test::usual_false_alarm);
  EXPECT_TRUE(decision) << test::describe(decision);
  EXPECT_FALSE(spread.is_wide());
  // Σ s² / σ² of 400 bins is χ² with 2800 degrees: seven deviations.
  EXPECT_NEAR(spread.pooled * spread.pooled, 1, 7 * std::sqrt(2.0 / 2800));
}

TEST(SeedSpread, FindsClaimsThatAreTooSmall) {
  const SeedSpread spread = spread_of_films(normal_runs(0.04, 12));
  EXPECT_TRUE(spread.is_wide());
  EXPECT_FALSE(test::binomial_test(spread.beyond, spread.bins, 0.05, test::usual_false_alarm));
}

TEST(SeedSpread, DoesNotDependOnTheUnitOfLight) {
  std::vector<compare::Run> runs = normal_runs(0.1, 13);
  const double pooled = spread_of_films(runs).pooled;
  for (compare::Run& run : runs)
    for (std::size_t k = 0; k < bins; ++k) {
      run.film.value[k] = std::ldexp(run.film.value[k], 900);
      run.film.standard_error[k] = std::ldexp(run.film.standard_error[k], 900);
    }
  EXPECT_DOUBLE_EQ(spread_of_films(runs).pooled, pooled);
}

TEST(SeedSpread, IsNotKnownOfOneReplicateNorWithoutClaims) {
  std::vector<compare::Run> runs = normal_runs(not_known, 14);
  EXPECT_FALSE(spread_of_films(runs).is_known());
  EXPECT_FALSE(spread_of_films(runs).is_wide());
  runs = normal_runs(0.1, 15);
  runs.resize(1);
  EXPECT_FALSE(spread_of_films(runs).is_known());
}

TEST(EnergyByLength, IsTheMeanOverBinsAndReplicatesWithItsTInterval) {
  std::vector<compare::Run> runs(2);
  runs[0].film.by_length = {{2, {1, 3}}, {3, {4, 4}}};
  runs[1].film.by_length = {{2, {2, 6}}};
  const auto energy = energy_by_length({&runs[0], &runs[1]});
  ASSERT_EQ(energy.size(), 2u);
  EXPECT_DOUBLE_EQ(energy.at(2).value, 3);
  // Means 2 and 4: standard error 1, and t of one degree is 12.706.
  EXPECT_NEAR(energy.at(2).interval.high, 3 + 12.706, 1e-3);
  EXPECT_DOUBLE_EQ(energy.at(3).value, 2) << "a run that misses a length has none of its light";
  EXPECT_TRUE(std::isnan(energy_by_length({&runs[0]}).at(2).interval.low));
}

// So that the lengths of an image in colour sum to b.
TEST(EnergyByLength, IsOfTheLuminanceInColour) {
  std::vector<compare::Run> runs(1);
  FilmEstimate& film = runs[0].film;
  film = {.shape = {1, 2, 3}, .value = {1, 2, 3, 4, 5, 6}, .by_length = {{2, {1, 2, 3, 4, 5, 6}}}};
  EXPECT_DOUBLE_EQ(energy_by_length({&runs[0]}).at(2).value, mean_value(film));
  EXPECT_NEAR(mean_value(film), 2.5 * 0.2126 + 3.5 * 0.7152 + 4.5 * 0.0722, 1e-12);
}

TEST(ReportNumbers, HaveFewDigitsAndNoWordsForWhatIsNoNumber) {
  EXPECT_EQ(rounded(0.012345), "0.0123");
  EXPECT_EQ(rounded(-412.3), "−412");
  EXPECT_EQ(rounded(43756.4), "43800");
  EXPECT_EQ(rounded(1.234e-7), "1.23·10⁻⁷");
  EXPECT_EQ(rounded(5e-320), "5.00·10⁻³²⁰");
  EXPECT_EQ(rounded(0.0), "0");
  EXPECT_EQ(rounded(not_known), unknown_number);
  EXPECT_EQ(rounded(INFINITY), unknown_number);
  EXPECT_EQ(rounded(compare::Interval{}), unknown_number);
}

TEST(ReportNumbers, IntervalsHaveTheDigitsThatTheirWidthNeeds) {
  EXPECT_EQ(with_interval({2, {1.6, 2.5}}), "2.00 [1.60, 2.50]");
  EXPECT_EQ(with_interval({0.65612, {0.65487, 0.65737}}), "0.6561 [0.6549, 0.6574]");
  EXPECT_EQ(with_interval({2, {1.6, not_known}}), "2.00 [1.60, ?]");
  EXPECT_EQ(with_interval({2, {}}), "2.00");
  EXPECT_EQ(with_interval({not_known, {1, 2}}), unknown_number);
}

TEST(ReportNumbers, AnIntervalThatIsNotKnownIsMarked) {
  Table table = named_rows("caption", "contender", {"a", "b"});
  table.add_measured("error", {{2, {1.6, 2.5}}, {3, {}}});
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].at(2), "[1.60, 2.50]");
  EXPECT_EQ(table.rows[1].at(2), unknown_number);
  Table without = named_rows("caption", "contender", {"a"});
  without.add_measured("error", {{3, {}}});
  EXPECT_EQ(without.rows[0].size(), 2u);  // no column of intervals where none is known
}

TEST(ReportNumbers, ColumnsShareTheirDecimals) {
  const std::vector<double> values{0.5, 12.25, not_known, 3};
  EXPECT_EQ(aligned(values), (std::vector<std::string>{"0.50", "12.25", unknown_number, "3.00"}));
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(counted(1, "run"), "1 run");
}

}  // namespace
}  // namespace wander::report

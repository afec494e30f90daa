// Degrees of freedom of the error of a film and of the intervals of its bins, of deviations that are known.
#include "mlt/run/film_degrees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wander::test::film_degrees_test {
namespace {

constexpr std::size_t groups = 20;

FilmEstimate told(const FilmDegrees& degrees) {
  FilmEstimate film;
  degrees.tell(film);
  return film;
}
// A bin of value 1, of whose variance each group has the same part.
void add_even(FilmDegrees& degrees, double variance, double of_samples = 0) {
  const double weight = degrees.add(1, variance, of_samples);
  for (std::size_t g = 0; g < groups; ++g)
    degrees.move_bin(g, std::sqrt(variance / groups), weight);
}
// And one that a group alone moves.
void add_of_one(FilmDegrees& degrees, double variance) {
  degrees.move_bin(7, std::sqrt(variance), degrees.add(1, variance));
}

TEST(FilmDegrees, AreOneFewerThanGroupsThatMoveAllAlike) {
  FilmDegrees degrees(groups);
  add_even(degrees, 1e-3);
  EXPECT_NEAR(told(degrees).degrees_of_freedom, groups - 1, 1e-9);
  EXPECT_NEAR(told(degrees).degrees_of_error, groups - 1, 1e-9);
}

// (Σ v)² / Σ v² - 1 with v of 1/20 each, and 100 more of one.
TEST(FilmDegrees, OfTheErrorAreFewWhereABinOfOneGroupHasMostOfItAndOfIntervalsAreNot) {
  FilmDegrees degrees(groups);
  add_even(degrees, 1e-3);
  add_of_one(degrees, 0.1);  // known by 10 events: no interval that may be reliable
  EXPECT_NEAR(told(degrees).degrees_of_freedom, groups - 1, 1e-9);
  const double v = 1e-3 / groups, most = v + 0.1;
  EXPECT_NEAR(told(degrees).degrees_of_error, 1.0201e-2 / (most * most + (groups - 1) * v * v) - 1,
              1e-9);
}

// In its own units a bin counts as much as any other: v of 2/20 + 1 of the one group, of 2/20 of the others.
TEST(FilmDegrees, OfIntervalsCountBinsAlike) {
  FilmDegrees degrees(groups);
  add_even(degrees, 1e-2);
  add_even(degrees, 1e-4);
  add_of_one(degrees, 1e-5);
  const double v = 2.0 / groups, most = v + 1;
  EXPECT_NEAR(told(degrees).degrees_of_freedom, 9 / (most * most + (groups - 1) * v * v) - 1, 1e-9);
}

// Of which half is known of samples: four times as many.
TEST(FilmDegrees, AreMoreWhereSamplesHaveAPartOfTheError) {
  FilmDegrees degrees(groups);
  add_even(degrees, 1e-3, 1e-3);
  EXPECT_NEAR(told(degrees).degrees_of_freedom, 4 * (groups - 1), 1e-9);
  EXPECT_NEAR(told(degrees).degrees_of_error, 4 * (groups - 1), 1e-9);
}

TEST(FilmDegrees, AreThoseOfTheErrorWhereNoIntervalMayBeReliable) {
  FilmDegrees degrees(groups);
  add_of_one(degrees, 0.1);
  EXPECT_NEAR(told(degrees).degrees_of_freedom, 0, 1e-9);
}
TEST(FilmDegrees, AreNoneWhereAnErrorIsNotKnown) {
  FilmDegrees degrees(groups);
  degrees.move_bin(0, std::numeric_limits<double>::quiet_NaN(),
                   degrees.add(1, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(told(degrees).degrees_of_freedom, 0);
}

}  // namespace
}  // namespace wander::test::film_degrees_test

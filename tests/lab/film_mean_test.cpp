// The mean of independent films by weights.
#include "lab/film_mean.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wander::test {
namespace {

FilmEstimate film_of(double value, double error, double degrees, bool reliable = true) {
  return {.shape = {1},
          .value = {value},
          .standard_error = {error},
          .reliable = {reliable},
          .degrees_of_freedom = degrees,
          .by_length = {{2, {value / 2}}}};
}

TEST(MeanFilm, CountsByWeights) {
  const std::vector<WeightedFilm> films{{film_of(1, 0.4, 10), 1}, {film_of(5, 0.1, 10), 3}};
  const FilmEstimate mean = mean_film(films);
  EXPECT_DOUBLE_EQ(mean.value[0], 4);
  EXPECT_DOUBLE_EQ(mean.standard_error[0], std::hypot(0.1, 0.075));
  EXPECT_DOUBLE_EQ(mean.by_length.at(2)[0], 2);
  EXPECT_TRUE(mean.reliable[0]);
}

// Two equal variances have the degrees of both; where one carries all, its own.
TEST(MeanFilm, HasTheDegreesOfWhatCarriesItsError) {
  const std::vector<WeightedFilm> equal{{film_of(1, 1, 10), 1}, {film_of(1, 1, 10), 1}};
  EXPECT_DOUBLE_EQ(mean_film(equal).degrees_of_freedom, 20);
  const std::vector<WeightedFilm> one{{film_of(1, 1, 10), 1}, {film_of(1, 0, 10), 1}};
  EXPECT_DOUBLE_EQ(mean_film(one).degrees_of_freedom, 10);
  const std::vector<WeightedFilm> none{{film_of(1, 0, 10), 1}, {film_of(1, 0, 10), 1}};
  EXPECT_DOUBLE_EQ(mean_film(none).degrees_of_freedom, 20);
}

TEST(MeanFilm, IsAsReliableAsTheLeastOfThem) {
  const std::vector<WeightedFilm> films{{film_of(1, 1, 10), 1}, {film_of(1, 1, 10, false), 1}};
  EXPECT_FALSE(mean_film(films).reliable[0]);
}

}  // namespace
}  // namespace wander::test

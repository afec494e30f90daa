// What is told of a film beside its values: where its bins lie, how good it is, how near another
// one.
#include "core/film_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>

#include "records/csv.h"

namespace wander {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

description::Scene scene_with_sensor(description::ShapeKind kind, int bins) {
  description::Scene scene;
  description::Shape shape;
  shape.kind = std::move(kind);
  shape.sensor = description::Sensor{{bins}};
  scene.shapes = {description::Shape{}, shape};
  return scene;
}

TEST(Csv, CentersOfBinsAreMetresAlongTheSensor) {
  const description::Segment segment{{1, 1, 0}, {4, 5, 0}};
  EXPECT_EQ(bin_centers(scene_with_sensor(segment, 2)), (std::vector{1.25, 3.75}));
  const description::Circle circle{{}, 2, false};
  EXPECT_DOUBLE_EQ(bin_centers(scene_with_sensor(circle, 1))[0], 2 * M_PI);
  const description::Arc arc{{}, 2, 350, 80, false};
  EXPECT_DOUBLE_EQ(bin_centers(scene_with_sensor(arc, 1))[0], M_PI / 2);
}

TEST(Csv, CentersOfPixelsAreFractionsOfTheFilm) {
  description::Scene scene;
  scene.camera.emplace().resolution = {4};
  EXPECT_EQ(bin_centers(scene), (std::vector{0.125, 0.375, 0.625, 0.875}));
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Csv, NumbersReadBackExactlyInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  FilmEstimate film;
  film.value = {1 / 3.0, 1e-300};
  film.standard_error = {0.1, -unknown};
  film.reliable = {true, false};
  const std::string text = to_csv(film, {0.25, 0.75});
  std::locale::global(before);
  EXPECT_EQ(text,
            "bin,center,value,standard_error,reliable\n"
            "0,0.25,0.3333333333333333,0.1,1\n"
            "1,0.75,1e-300,nan,0\n");
}

FilmEstimate film_of(std::vector<double> value, double error) {
  FilmEstimate film;
  film.shape = {static_cast<int>(value.size())};
  film.standard_error = std::vector<double>(value.size(), error);
  film.reliable = std::vector<bool>(value.size(), true);
  film.degrees_of_freedom = 31;
  film.value = std::move(value);
  return film;
}

TEST(FilmStatistics, TheRelativeErrorIsTheRatioOfTheNorms) {
  EXPECT_DOUBLE_EQ(relative_error(film_of({3, 4}, 0.5)), std::sqrt(0.5) / 5);
  EXPECT_DOUBLE_EQ(relative_error(film_of({3e200, 4e200}, 0.5e200)), std::sqrt(0.5) / 5);
  EXPECT_TRUE(std::isnan(relative_error(film_of({0, 0}, 0))));
}

TEST(FilmStatistics, StudentsQuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(student_t_95(1), 12.7062, 1e-4);
  EXPECT_NEAR(student_t_95(5), 2.57058, 1e-5);
  EXPECT_NEAR(student_t_95(31), 2.03951, 1e-5);
  EXPECT_NEAR(student_t_95(std::numeric_limits<double>::infinity()), 1.95996, 1e-5);
  EXPECT_TRUE(std::isinf(student_t_95(0)));
}

TEST(FilmStatistics, AComparisonCountsTheErrorsOfBothFilms) {
  // Each difference is 5 combined errors of 0.05, or none.
  const FilmComparison comparison =
      film_comparison(film_of({1.25, 1, 1, 1}, 0.03), film_of({1, 1, 1, 1}, 0.04));
  EXPECT_EQ(comparison.bins, 4U);
  EXPECT_DOUBLE_EQ(comparison.relative_rmse, 0.125);
  EXPECT_NEAR(comparison.chi2_per_degree, 25.0 / 4, 1e-12);
  EXPECT_NEAR(comparison.largest_z, 5, 1e-12);
  EXPECT_DOUBLE_EQ(comparison.covered_share, 0.75);
}

// 2 and 100 degrees of freedom of unequal errors are 14.5 together [Welch 1947], whose 95 %
// interval reaches 2.14 errors; that of 2 degrees would reach 4.30.
TEST(FilmStatistics, AComparisonCombinesTheDegreesOfFreedomOfBothFilms) {
  FilmEstimate film = film_of({1.105, 1.109}, 0.03), reference = film_of({1, 1}, 0.04);
  film.degrees_of_freedom = 2;
  reference.degrees_of_freedom = 100;
  EXPECT_DOUBLE_EQ(film_comparison(film, reference).covered_share, 0.5);
}

TEST(FilmStatistics, ABinIsComparedOnlyWhereBothFilmsAreReliable) {
  FilmEstimate film = film_of({1, 9, 9}, 0.1);
  FilmEstimate reference = film_of({1, 1, 1}, 0.1);
  film.reliable[1] = false;
  reference.standard_error[2] = unknown;
  const FilmComparison comparison = film_comparison(film, reference);
  EXPECT_EQ(comparison.bins, 1U);
  EXPECT_EQ(comparison.chi2_per_degree, 0);
}

}  // namespace
}  // namespace wander

// The factor between two films, each with noise of its own: b is known, for the films are made of
// it.
#include "mlt/run/film_fit.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "core/rng.h"
#include "statistics/jackknife.h"
#include "tests/support/expect.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

constexpr std::size_t groups = 32, bins = 24;
constexpr double b = 3;

// A film of mean one.
double shape(std::size_t j) { return 1 + 0.5 * std::sin(0.3 * static_cast<double>(j)); }

double shape_mean() {
  double mean = 0;
  for (std::size_t j = 0; j < bins; ++j) mean += shape(j) / bins;
  return mean;
}

double normal(Rng& random) {
  const double u = random.uniform();
  return boost::math::quantile(boost::math::normal(), 0x1p-54 + u * (1 - 0x1p-53));
}

// A group's Σ over 100 samples has the relative error `seeds` in each bin; its chains deposit with
// the relative error `chains`, a part of which all bins share.
std::vector<FilmFitGroup> simulate(double seeds, double chains, std::uint64_t seed) {
  Rng random(seed, Purpose::test, 72);
  std::vector<FilmFitGroup> data;
  for (std::size_t g = 0; g < groups; ++g) {
    FilmFitGroup group{{}, 100, {}};
    const double common = chains * normal(random);
    for (std::size_t j = 0; j < bins; ++j) {
      const double value = b * shape(j) / shape_mean() * 100 / bins;
      group.found.push_back(value * std::exp(seeds * normal(random) - seeds * seeds / 2));
      const double own = chains * normal(random);
      group.deposits.push_back(shape(j) * std::max(0.0, 1 + common + own));
    }
    data.push_back(group);
  }
  return data;
}

TEST(FilmFit, OfFilmsWithoutNoiseIsTheirFactor) {
  const FilmFit fit = fit_films(simulate(1e-9, 0, 1));
  ASSERT_TRUE(fit.failure.empty()) << fit.failure;
  EXPECT_NEAR(fit.b, b, 1e-8);
  for (const double without : fit.without) EXPECT_NEAR(without, b, 1e-8);
}

TEST(FilmFit, OfAMultipleByAPowerOfTwoIsThatMultiple) {
  std::vector<FilmFitGroup> data = simulate(0.3, 0.1, 2);
  const FilmFit fit = fit_films(data);
  for (FilmFitGroup& group : data)
    for (double& value : group.found) value = std::ldexp(value, 90);
  EXPECT_EQ(fit_films(data).b, std::ldexp(fit.b, 90));
}

TEST(FilmFit, SaysWhyThereIsNoFactor) {
  std::vector<FilmFitGroup> few = simulate(0.3, 0.1, 3), dark = few, narrow = few;
  few.resize(3);
  for (std::size_t g = 0; g < groups; g += 2)
    for (double& value : dark[g].found) value = 0;
  for (FilmFitGroup& group : narrow) group.found.resize(1), group.deposits.resize(1);
  for (const auto& data : {few, dark, narrow}) EXPECT_FALSE(fit_films(data).failure.empty());
}

// What a fit may not do: weights from the data that they weigh [Neyman's χ²].
double same_data_fit(std::span<const FilmFitGroup> data) {
  double above = 0, below = 0;
  for (std::size_t j = 0; j < bins; ++j) {
    double mean = 0, deposits = 0, mass = 0, variance = 0;
    for (const FilmFitGroup& group : data) {
      mean += bins * group.found[j] / group.samples / groups;
      deposits += group.deposits[j];
      for (const double value : group.deposits) mass += value / bins;
    }
    for (const FilmFitGroup& group : data)
      variance +=
          std::pow(bins * group.found[j] / group.samples - mean, 2) / (groups * (groups - 1));
    const double p = deposits / mass;
    above += mean * p / variance;
    below += p * p / variance;
  }
  return above / below;
}

// 300 pairs of films.  False alarms: 1e-9 by the binomial law of a coverage of 0.93.
TEST(FilmFit, ItsIntervalCoversAndThatOfSameDataIsBiased) {
  constexpr int runs = 300;
  double covered = 0, bias = 0, squares = 0, twin_bias = 0;
  for (int run = 0; run < runs; ++run) {
    const auto data = simulate(1.2, 0.2, static_cast<std::uint64_t>(100 + run));
    const FilmFit fit = fit_films(data);
    ASSERT_TRUE(fit.failure.empty());
    const double error = jackknife_error(fit.without);
    covered += std::abs(fit.b - b) <= 2.04 * error ? 1 : 0;
    bias += (fit.b - b) / runs;
    squares += (fit.b - b) * (fit.b - b) / runs;
    twin_bias += (same_data_fit(data) - b) / runs;
  }
  EXPECT_GT(covered / runs, 0.84);
  EXPECT_LT(std::abs(bias), 0.3 * std::sqrt(squares));
  EXPECT_LT(twin_bias, -1.0 * std::sqrt(squares)) << "a low film seems to be a sure one";
}

}  // namespace
}  // namespace wander::test

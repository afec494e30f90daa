// The mean of independent runs, and what it knows of its own error.
#include "lab/film_pool.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/generator.h"

namespace wander::test::film_pool_test {
namespace {

Rendering run_of(std::vector<double> value, double standard_error, std::uint64_t samples) {
  Rendering run;
  run.samples = samples;
  run.film.shape = {static_cast<int>(value.size())};
  run.film.standard_error.assign(value.size(), standard_error);
  run.film.reliable.assign(value.size(), true);
  run.film.degrees_of_freedom = 63;
  run.film.value = std::move(value);
  return run;
}

TEST(PooledFilm, OfOneRunIsThatRun) {
  const std::vector<Rendering> runs{run_of({1, 2}, 0.1, 10)};
  const FilmEstimate pool = pooled_film(runs);
  EXPECT_EQ(pool.value, runs[0].film.value);
  EXPECT_EQ(pool.standard_error, runs[0].film.standard_error);
}

TEST(PooledFilm, WeighsRunsByTheirSamples) {
  const std::vector<Rendering> runs{run_of({1, 5}, 2, 100), run_of({2, 5}, 2, 300)};
  const FilmEstimate pool = pooled_film(runs);
  EXPECT_DOUBLE_EQ(pool.value[0], 1.75);
  EXPECT_DOUBLE_EQ(pool.value[1], 5);
  // They agree better than they claim to know: the claims stand.
  EXPECT_DOUBLE_EQ(pool.standard_error[0], 2 * std::hypot(0.25, 0.75));
  EXPECT_EQ(pool.degrees_of_freedom, 126);
}

TEST(PooledFilm, RaisesClaimsByADisagreementThatTheFilmShows) {
  // D = ((1 - 2)² + (3 - 2)²) / 2 = 1 in the first bin, 0 in the second; ΣC = 2 · 2 · (0.1 / 2)².
  const std::vector<Rendering> runs{run_of({1, 5}, 0.1, 1), run_of({3, 5}, 0.1, 1)};
  const FilmEstimate pool = pooled_film(runs);
  for (const double error : pool.standard_error) EXPECT_DOUBLE_EQ(error, std::sqrt(0.5));
}

TEST(PooledFilm, KnowsABinByItsDisagreementWhereNoRunClaimsToKnow) {
  std::vector<Rendering> runs{run_of({1, 5}, 10, 1), run_of({3, 5}, 10, 1)};
  for (Rendering& run : runs) run.film.standard_error[1] = not_known;
  runs[1].film.reliable[1] = false;
  const FilmEstimate pool = pooled_film(runs);
  EXPECT_DOUBLE_EQ(pool.standard_error[0], std::sqrt(50));
  EXPECT_DOUBLE_EQ(pool.standard_error[1], std::sqrt(0.5));
  EXPECT_EQ(pool.reliable, (std::vector<bool>{true, false}));
}

// Mean of ((pooled value - truth) / standard error)² over 400 pools of two runs of 50 normal bins,
// whose error is 1 and who claim `claim`.
double mean_square_z(double claim,
                     const std::function<FilmEstimate(std::span<const Rendering>)>& pool) {
  Generator generator(5);
  double sum = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<Rendering> runs;
    for (int i = 0; i < 2; ++i) {
      std::vector<double> value;
      for (int b = 0; b < 50; ++b) value.push_back(generator.normal());
      runs.push_back(run_of(value, claim, 1));
    }
    const FilmEstimate film = pool(runs);
    for (std::size_t b = 0; b < 50; ++b)
      sum += std::pow(film.value[b] / film.standard_error[b], 2) / (400 * 50);
  }
  return sum;
}

FilmEstimate honest(std::span<const Rendering> runs) { return pooled_film(runs); }

FilmEstimate believing(
    std::span<const Rendering> runs) {  // control: takes claims for what they are
  FilmEstimate film = pooled_film(runs);
  film.standard_error.assign(50, runs[0].film.standard_error[0] / std::sqrt(2));
  return film;
}

// The mean of 20000 squares has a standard deviation of 0.01, so 0.15 off is no chance.  Raising by
// the greater of 1 and a noisy factor makes errors a little too large, never much too small.
TEST(PooledFilm, HasAnHonestErrorEvenIfItsRunsHaveNot) {
  EXPECT_NEAR(mean_square_z(1, honest), 0.92, 0.15);
  EXPECT_NEAR(mean_square_z(1.0 / 3, honest), 1.04, 0.15);
  EXPECT_NEAR(mean_square_z(1.0 / 3, believing), 9, 1);
}

}  // namespace
}  // namespace wander::test::film_pool_test

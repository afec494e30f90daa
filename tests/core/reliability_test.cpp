// Which bins of a film of independent samples are reliable.  The rule for what lies around a bin is recounted, bin by
// bin, with films of chains (mlt/run/reliability_test.cpp); here, that it is asked with what a sample weighs.
#include "core/reliability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace wander::test::core_reliability_test {
namespace {

// Bins of so many equal samples among `all` of them, of the value one: v = hits / n, σ² = v (1 - v) / (n - 1).
FilmEstimate hit(const std::vector<double>& hits, double all) {
  FilmEstimate film{.shape = {static_cast<int>(hits.size())}};
  for (const double count : hits) {
    const double v = count / all;
    film.value.push_back(v);
    film.standard_error.push_back(std::sqrt(v * (1 - v) / (all - 1)));
  }
  return film;
}

std::vector<bool> told(const FilmEstimate& film, std::uint64_t samples) {
  return reliability(film, EventWeight::of_samples(samples));
}

TEST(ReliableSamples, AreCountedWhereTheyReachedABin) {
  constexpr std::uint64_t all = 1000;
  EXPECT_EQ(told(hit(std::vector<double>(9, 75.01), all), all), std::vector<bool>(9, true));
  EXPECT_EQ(told(hit(std::vector<double>(9, 74.99), all), all), std::vector<bool>(9, false));
}

// Samples that all bring the same have no error; so few are no evidence for all that.
TEST(ReliableSamples, AreNotMoreThanThereAre) {
  const FilmEstimate film{.shape = {1}, .value = {3}, .standard_error = {0}};
  for (const std::uint64_t n : {2, 74, 76})
    EXPECT_EQ(told(film, n), std::vector<bool>(1, n > 75)) << n;
}

TEST(ReliableSamples, WithoutAnErrorThatCanBeToldAreNone) {
  const FilmEstimate film{.shape = {1}, .value = {3}, .standard_error = {not_known}};
  EXPECT_EQ(told(film, 1000), std::vector<bool>(1, false));
}

}  // namespace
}  // namespace wander::test::core_reliability_test

// What the pilot decides must not be decided by the samples that the film is made of.  Shown exactly, by
// enumeration: of n samples each finds an easy path, l = 1, or with probability q a hard one, so that
// the film, of one bin, is a function of how many hard ones there are.  The chains' part is known.
//
// Chosen by a pilot, border and number of samples leave the expected film at b; wrong twins, which
// choose by their own samples, do not.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mlt/run/partition.h"

namespace wander::test::pooling_twins_test {
namespace {

constexpr double hard = 64, q = 0x5p-12;  // five of them are
constexpr int samples = 4096;
constexpr int most = 60;  // hard ones: of more the probability is below 1e-35
constexpr double b = (1 - q) + q * hard;

// P(k of n samples are hard)
double probability(int k, int n) {
  return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                  k * std::log(q) + (n - k) * std::log1p(-q));
}
// What a pilot of so many samples chooses, of which k were hard.
Pooling chosen(int k) {
  Pilot pilot{.samples = samples, .rays = rays_per_step * samples};
  for (int i = 0; i < samples; ++i) pilot.found.add(i < k ? hard : 1);
  return best_pooling(pilot, 1);
}
// E + b S, of n samples among which k are hard.
double film(int k, int n, Partition side) {
  const double of_samples = ((n - k) * side.of_samples(1) + k * hard * side.of_samples(hard)) / n;
  const double of_chains = (1 - q) * side.of_chains(1) + q * hard * side.of_chains(hard);
  return of_samples + of_chains;
}

class ChoicesOfThePilot : public ::testing::Test {
 protected:
  ChoicesOfThePilot() {
    for (int k = 0; k <= most; ++k) {
      weights.push_back(probability(k, samples));
      choices.push_back(chosen(k));
    }
  }
  std::vector<double> weights;   // by k
  std::vector<Pooling> choices;  // of a pilot with so many
};

TEST_F(ChoicesOfThePilot, OfABorderLeaveTheFilmUnbiased) {
  double independent = 0, twin = 0;
  for (std::size_t pilot = 0; pilot < weights.size(); ++pilot)
    for (std::size_t k = 0; k < weights.size(); ++k)
      independent += weights[pilot] * weights[k] *
                     film(static_cast<int>(k), samples, choices[pilot].partition);
  for (std::size_t k = 0; k < weights.size(); ++k)
    twin += weights[k] * film(static_cast<int>(k), samples, choices[k].partition);
  EXPECT_NEAR(independent, b, 1e-10);
  EXPECT_GT(std::abs(twin - b), 1e-4 * b) << "c that is chosen by the samples that it weighs";
}

// Samples beside the chains: as many again where the choice is that there be many.
TEST_F(ChoicesOfThePilot, OfANumberOfSamplesLeaveTheFilmUnbiased) {
  const Partition side{16 * b};
  const auto expected = [&](std::size_t k, const Pooling& choice) {
    const int hard_ones = static_cast<int>(k);
    if (choice.samples_per_step < 4) return film(hard_ones, samples, side);
    double mean = 0;
    for (std::size_t more = 0; more < weights.size(); ++more)
      mean += weights[more] * film(hard_ones + static_cast<int>(more), 2 * samples, side);
    return mean;
  };
  double independent = 0, twin = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    for (std::size_t pilot = 0; pilot < weights.size(); ++pilot)
      independent += weights[pilot] * weights[k] * expected(k, choices[pilot]);
    twin += weights[k] * expected(k, choices[k]);
  }
  EXPECT_NEAR(independent, b, 1e-10);
  EXPECT_GT(std::abs(twin - b), 1e-4 * b) << "a share chosen by the film that it makes";
}

}  // namespace
}  // namespace wander::test::pooling_twins_test

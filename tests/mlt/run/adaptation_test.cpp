// How far small moves go, from what windows of chains deposit.
#include "mlt/run/adaptation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/rng.h"
#include "mlt/run/pilot.h"

namespace wander::test {
namespace {

// ---- spread

TEST(WindowSpread, IsTheVarianceOfWindowsAddedOverBins) {
  WindowSpread spread(3);
  for (const std::array<double, 3> window :
       {std::array{1.0, 0.0, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.25, 0.25}, {0.5, 0.25, 0.25}})
    spread.add(window);
  // Deviations from the mean (1/2, 1/4, 1/4): ±(1/2, 1/4, 1/4) twice, of three degrees of freedom.
  EXPECT_DOUBLE_EQ(spread.value(), 2 * (0.25 + 0.0625 + 0.0625) / 3);
}

TEST(WindowSpread, IsNotKnownOfOneWindow) {
  WindowSpread spread(1);
  EXPECT_EQ(spread.value(), std::numeric_limits<double>::infinity());
  spread.add(std::array{1.0});
  EXPECT_EQ(spread.value(), std::numeric_limits<double>::infinity());
}

// Draws of one of four bins, each kept for so many steps.  Their variance is 3/4; of 4000 windows the
// spread is known to 2 %.
double spread_of_kept(std::uint64_t kept) {
  constexpr std::size_t bins = 4;
  WindowSpread spread(bins);
  Rng random(1, Purpose::test, 0);
  random.start(kept);
  std::size_t bin = 0;
  for (std::uint64_t w = 0, i = 0; w < 4000; ++w) {
    std::array<double, bins> shares{};
    for (std::uint64_t k = 0; k < steps_of_window; ++k, ++i) {
      if (i % kept == 0) bin = static_cast<std::size_t>(bins * random.uniform());
      shares[bin] += 1.0 / static_cast<double>(steps_of_window);
    }
    spread.add(shares);
  }
  return spread.value();
}

TEST(WindowSpread, IsThatOfAsManyDrawsAsAWindowHolds) {
  for (const std::uint64_t kept : {1, 4, 16, 64}) {
    const double draws = static_cast<double>(steps_of_window) / static_cast<double>(kept);
    EXPECT_NEAR(spread_of_kept(kept) * draws / 0.75, 1, 0.1) << kept;
  }
}

// R_L = E|e - E e|² - 1/L² Σ_{i<k} E|e_i - e_k|², here for a window of given states.
TEST(WindowSpread, FallsByTheSquaredJumpsOfAllLags) {
  const std::array states{0, 0, 2, 1, 2, 2, 0, 1};
  std::array<double, 3> mean{};
  double jumps = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    mean[static_cast<std::size_t>(states[i])] += 1.0 / states.size();
    for (std::size_t k = i + 1; k < states.size(); ++k) jumps += states[i] != states[k] ? 2 : 0;
  }
  double square = 0;
  for (const double share : mean) square += share * share;
  EXPECT_DOUBLE_EQ(square, 1 - jumps / (states.size() * states.size()));
}

// ---- search

Adaptation found_in(const std::function<double(double)>& spread) {
  KernelSearch search;
  while (const auto factor = search.next()) search.tell(spread(*factor));
  return search.found();
}
std::vector<double> factors(const Adaptation& found) {
  std::vector<double> factors;
  for (const TriedKernel& each : found.tried) factors.push_back(each.factor);
  return factors;
}
using Factors = std::vector<double>;

TEST(KernelSearch, ClimbsAsLongAsItGetsBetter) {
  const Adaptation found = found_in([](double f) { return 1 + std::abs(std::log(f / 16)); });
  EXPECT_EQ(found.kernel, 16);
  EXPECT_EQ(factors(found), (Factors{1, 4, 16, 64}));
}

TEST(KernelSearch, GoesDownWhereLargerIsNoBetter) {
  const Adaptation found = found_in([](double f) { return 1 + std::abs(std::log(f * 4)); });
  EXPECT_EQ(found.kernel, 0.25);
  EXPECT_EQ(factors(found), (Factors{1, 4, 0.25, 1.0 / 16}));
}

TEST(KernelSearch, EndsAtTheEnds) {
  EXPECT_EQ(found_in([](double f) { return 1 / f; }).kernel, largest_kernel);
  EXPECT_EQ(found_in([](double f) { return f; }).kernel, smallest_kernel);
}

TEST(KernelSearch, KeepsTheUsualFactorWhereNothingIsClearlyBetter) {
  for (const double gain : {1.0, 1.05, 0.9}) {
    const Adaptation found = found_in([gain](double f) { return f == 1 ? gain : 1; });
    EXPECT_EQ(found.kernel, 1) << gain;
    EXPECT_EQ(factors(found), (Factors{1, 4, 0.25})) << gain;
  }
  EXPECT_EQ(found_in([](double f) { return f == 1 ? 1.2 : 1; }).kernel, 4);
  EXPECT_EQ(found_in([](double) { return INFINITY; }).kernel, 1) << "nothing known";
  EXPECT_EQ(found_in([](double) { return NAN; }).kernel, 1) << "nothing known";
  EXPECT_EQ(found_in([](double) { return 0; }).kernel, 1) << "a film of one bin";
}

TEST(KernelSearch, RemembersWhatItSaw) {
  const Adaptation found = found_in([](double f) { return 10 + f; });
  EXPECT_EQ(found.tried, (std::vector<TriedKernel>{{1, 11}, {4, 14}, {0.25, 10.25}}));
}

TEST(KernelSearch, ThatIsBrokenOffHasTheBestSoFar) {
  KernelSearch search;
  EXPECT_EQ(search.found(), Adaptation{});
  search.tell(1);
  search.tell(0.5);
  EXPECT_EQ(search.found().kernel, 4);
}

TEST(Adaptations, HaveSeedsOfTheirOwn) {
  for (const std::uint64_t seed : {0ull, 1ull, 2ull, 77ull, ~0ull}) {
    EXPECT_NE(seed_of_adaptation(seed), seed);
    EXPECT_NE(seed_of_adaptation(seed), seed_of_pilot(seed));
    EXPECT_NE(seed_of_adaptation(seed), seed_of_adaptation(seed + 1));
  }
}

}  // namespace
}  // namespace wander::test

// In the Kirchhoff furnace the target can be sampled exactly, so a chain can be started in
// equilibrium, and must stay there: no weights, no normalization, no converged chain.
//
// False alarms: 1e-9 per test, each over all kernels of the catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mlt/seeds/seed_pass.h"
#include "tests/support/catalogue_kernels.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/kirchhoff.h"
#include "tests/support/wrong_twins.h"

namespace wander::test::kirchhoff_test {
namespace {

using W = Flatland;
constexpr int longest = 12;

Furnace furnace_of(int mixed) {
  return mixed == 1 ? mixed_furnace(longest) : diffuse_furnace(longest);
}

class KirchhoffFurnace : public ::testing::TestWithParam<int> {
 protected:
  Furnace furnace_ = furnace_of(GetParam());
  const Kirchhoff& space_ = furnace_.space;
};
INSTANTIATE_TEST_SUITE_P(Rooms, KirchhoffFurnace, ::testing::Values(0, 1),
                         [](const auto& test) { return test.param == 1 ? "Mixed" : "Diffuse"; });

// f(x) = b p(x), with p the density of the exact sampler: what it samples from the sensor, times
// the probability f/p of going on at each vertex that could absorb, and of ending at the emitter.
TEST_P(KirchhoffFurnace, ContributionIsTwiceTheDensityOfTheExactSampler) {
  Rng random(1, Purpose::test, 60);
  Path<W> x(longest);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    random.start(i);
    space_.sample_short(x, random);
    const int n = x.size();
    double density = 1 - space_.albedo(x[0], x[0].place.to_sensor);
    for (int k = 1; k + 1 < n; ++k)
      density *= x[k].value * x[k - 1].geometry / x[k - 1].from_sensor;
    const Scaled exact = technique_density(x, 0) * Scaled(2 * density);
    ASSERT_NEAR((contribution(x) / exact).value(), 1, 1e-12) << path_class(x);
  }
}

// b_n = 2 P(n vertices), by the seed pass and by the exact sampler.
TEST_P(KirchhoffFurnace, NormalizationOfTheSeedPassIsExactByLength) {
  constexpr std::uint64_t samples = 40'000;
  SeedSlice<Kirchhoff> slice(space_, 1, 0, 1);
  slice.run(samples);
  std::vector<double> count(longest - 1);
  Rng random(1, Purpose::test, 61);
  Path<W> x(longest);
  for (std::uint64_t i = 0; i < samples; ++i) {
    random.start(i);
    if (space_.sample(x, random)) ++count[static_cast<std::size_t>(x.size()) - 2];
  }
  std::vector<Compared> lengths;
  const auto n = static_cast<double>(samples);
  for (std::size_t k = 0; k < count.size(); ++k) {
    const double exact = 2 * count[k] / n, p = count[k] / n;
    const double b = slice.tally().sum[k].value() / n;
    const double variance =
        (slice.tally().squares[k].value() / n - b * b) / n + 4 * p * (1 - p) / n;
    const double error = std::sqrt(variance);
    if (count[k] >= 100) lengths.push_back({(b - exact) / error, error, exact});
  }
  EXPECT_GE(lengths.size(), 5u);
  EXPECT_TRUE(passes(largest_z_test(lengths, usual_false_alarm)));
}

// Exact starts, n steps; paired deviations of the functions of the path.
template <class Kernel>
Decision from_exact_start(const Kirchhoff& space, const Kernel& kernel, std::uint64_t samples,
                          double false_alarm) {
  constexpr int steps = 10;
  const PathFunctions functions(space);
  Rng start(2, Purpose::test, 62), random(2, Purpose::test, 63);
  Path<W> x(longest);
  Deviations deviations;
  for (std::uint64_t i = 0; i < samples; ++i) {
    start.start(i);
    random.start(i);
    space.sample_short(x, start);
    deviations.add_level(functions.values(x), 1);
    Chain<Kirchhoff, Kernel> chain(space, kernel, x);
    for (int n = 0; n < steps; ++n) chain.step(random, [](const Step<W>&) {});
    deviations.add(functions.values(x), functions.values(chain.current()), 1);
  }
  return deviations.decide(1, false_alarm);
}

TEST_P(KirchhoffFurnace, EveryMutationLeavesTheExactDistributionAsItIs) {
  const auto kernels = catalogue_kernels(longest);
  for (const auto& [name, kernel] : kernels) {
    SCOPED_TRACE(name);
    const Decision d = from_exact_start(space_, kernel, 8000,
                                        usual_false_alarm / static_cast<double>(kernels.size()));
    if (d.comparisons > 0) {
      EXPECT_TRUE(passes(d));
    }
    if (name == "mixture") {
      EXPECT_GE(d.comparisons, 20u);
    }
  }
}

TEST_P(KirchhoffFurnace, WrongTwinsDoNot) {
  const auto rejected = [&](const auto& twin) {
    return rejects(from_exact_start(space_, alone(twin), 10'000, usual_false_alarm));
  };
  EXPECT_TRUE(rejected(FlawedRatio<Bidirectional>{{}, RatioFlaw::symmetric}));
  EXPECT_TRUE(rejected(FlawedRatio<Bidirectional>{{}, RatioFlaw::inverted}));
  EXPECT_TRUE(rejected(LargeStepWithoutIntensity{PrimaryLarge(longest)}));
}

// ---- ranks [Gandy and Scott 2021]

// State number m of `states`, m uniform, is exact, and a reversible kernel runs from it in both
// directions.  Then the rank of s(x_m) among all is uniform: exactly, for any kernel of the target.
template <class Kernel, class Function>
Decision ranks(const Kirchhoff& space, const Kernel& kernel, Function s, std::uint64_t samples,
               double false_alarm) {
  constexpr int states = 8;
  Rng start(3, Purpose::test, 64), random(3, Purpose::test, 65);
  Path<W> x(longest);
  std::vector<double> counts(states), expected(states, static_cast<double>(samples) / states);
  for (std::uint64_t i = 0; i < samples; ++i) {
    start.start(i);
    random.start(i);
    space.sample_short(x, start);
    const double exact = s(x);
    const int before = random.choose(states);
    int below = 0, ties = 0;
    for (const int count : {before, states - 1 - before}) {
      Chain<Kirchhoff, Kernel> chain(space, kernel, x);
      for (int n = 0; n < count; ++n) {
        chain.step(random, [](const Step<W>&) {});
        const double value = s(chain.current());
        below += value < exact ? 1 : 0;
        ties += value == exact ? 1 : 0;
      }
    }
    ++counts[static_cast<std::size_t>(below + random.choose(ties + 1))];
  }
  return chi_square_test(counts, expected, false_alarm);
}

double light_coordinate(const Path<W>& x) {
  return x[0].place.position[0] + 0.37 * x[0].place.position[1];
}

TEST_P(KirchhoffFurnace, RanksOfTheExactStateAreUniformAmongItsSuccessors) {
  const auto kernels = catalogue_kernels(longest);
  for (const auto& [name, kernel] : kernels) {
    SCOPED_TRACE(name);
    const double rate = usual_false_alarm / static_cast<double>(2 * kernels.size());
    EXPECT_TRUE(passes(ranks(space_, kernel, light_coordinate, 6000, rate)));
    EXPECT_TRUE(passes(
        ranks(space_, kernel, [](const Path<W>& x) { return contribution(x).log(); }, 6000, rate)));
  }
}

TEST_P(KirchhoffFurnace, RanksOfAWrongTwinAreNot) {
  const auto brightness = [](const Path<W>& x) { return contribution(x).log(); };
  const LargeStepWithoutIntensity twin{PrimaryLarge(longest)};
  EXPECT_TRUE(rejects(ranks(space_, alone(twin), brightness, 6000, usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test::kirchhoff_test

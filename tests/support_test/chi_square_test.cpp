// The χ² engine: right samplers pass, each kind of wrong one is caught, and p is uniform under a
// true hypothesis.  False-alarm rate of each decision: 1e-7, seeds fixed.
#include "tests/support/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/expect.h"
#include "tests/support/generator.h"

namespace wander::test {
namespace {

using std::numbers::pi;

// sin θ = 2u - 1 about the y axis, the Lambertian sampler of the plane.
auto lambert_in_the_plane(Generator& g) {
  return [&g]() -> std::optional<CubePoint<1>> {
    const double sine = 2 * g.uniform() - 1;
    return cube_of_direction(sine, std::sqrt(1 - sine * sine));
  };
}

auto lambert_in_space(Generator& g) {
  return [&g]() -> std::optional<CubePoint<2>> {
    const double radius = std::sqrt(g.uniform());
    const double azimuth = 2 * pi * g.uniform();
    return cube_of_direction(radius * std::cos(azimuth), radius * std::sin(azimuth),
                             std::sqrt(1 - radius * radius));
  };
}

TEST(ChiSquare, LambertianSamplersMatchTheirDensities) {
  Generator g(1);
  const auto plane = [](const CubePoint<1>& u) {
    return 2 * pi * std::max(0.0, direction_on_circle(u)[1]) / 2;
  };
  const auto space = [](const CubePoint<2>& u) {
    return 4 * pi * std::max(0.0, direction_on_sphere(u)[2]) / pi;
  };
  EXPECT_TRUE(passes(sampler_matches_density<1>(lambert_in_the_plane(g), plane)));
  EXPECT_TRUE(passes(sampler_matches_density<2>(lambert_in_space(g), space)));
}

TEST(ChiSquare, TheConstantOfTheWrongDimensionIsCaught) {
  Generator g(2);
  const auto pi_in_the_plane = [](const CubePoint<1>& u) {
    return 2 * pi * std::max(0.0, direction_on_circle(u)[1]) / pi;
  };
  EXPECT_TRUE(rejects(sampler_matches_density<1>(lambert_in_the_plane(g), pi_in_the_plane)));
}

TEST(ChiSquare, ADensityOfAnotherShapeIsCaught) {
  Generator g(3);
  const auto uniform_half = [](const CubePoint<1>& u) {
    return direction_on_circle(u)[1] > 0 ? 2.0 : 0.0;
  };
  const auto flatter = [](const CubePoint<2>& u) {
    const double z = direction_on_sphere(u)[2];
    return z > 0 ? 4 * pi * (0.95 * z / pi + 0.05 / (2 * pi)) : 0.0;
  };
  EXPECT_TRUE(rejects(sampler_matches_density<1>(lambert_in_the_plane(g), uniform_half)));
  EXPECT_TRUE(rejects(sampler_matches_density<2>(lambert_in_space(g), flatter)));
}

TEST(ChiSquare, ADensityThatJumpsInsideCellsPasses) {
  Generator g(4);
  const auto step = [](const CubePoint<1>& u) { return u[0] < 0.37 ? 2.0 : 0.26 / 0.63; };
  const auto sample = [&g]() -> std::optional<CubePoint<1>> {
    const double u = g.uniform();
    return CubePoint<1>{u < 0.74 ? u / 2 : 0.37 + (u - 0.74) * 0.63 / 0.26};
  };
  EXPECT_TRUE(passes(sampler_matches_density<1>(sample, step, {.integral = {1e-9, 40}})));
}

// Fails with probability 0.3; else density proportional to 2x.
auto defective(Generator& g) {
  return [&g]() -> std::optional<CubePoint<1>> {
    if (g.uniform() < 0.3) return std::nullopt;
    return CubePoint<1>{std::sqrt(g.uniform())};
  };
}

TEST(ChiSquare, ASamplerThatMayFailIsHeldAgainstItsSubProbability) {
  Generator g(5);
  const auto right = [](const CubePoint<1>& u) { return 0.7 * 2 * u[0]; };
  const auto as_if_never = [](const CubePoint<1>& u) { return 2 * u[0]; };
  const auto as_if_less = [](const CubePoint<1>& u) { return 0.69 * 2 * u[0]; };
  EXPECT_TRUE(passes(sampler_matches_density<1>(defective(g), right)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(defective(g), as_if_never)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(defective(g), as_if_less)));
}

TEST(ChiSquare, ADensityWithMissingMassIsCaughtThoughTheSamplerNeverFails) {
  Generator g(6);
  const auto sample = [&g]() -> std::optional<CubePoint<1>> { return CubePoint<1>{g.uniform()}; };
  const auto short_of_one = [](const CubePoint<1>&) { return 0.99; };
  EXPECT_TRUE(rejects(sampler_matches_density<1>(sample, short_of_one)));
}

TEST(ChiSquare, ImpossibleSamplesAndDensitiesFailAtOnce) {
  Generator g(7);
  const auto uniform = [&g]() -> std::optional<CubePoint<1>> { return CubePoint<1>{g.uniform()}; };
  const auto outside = [&g]() -> std::optional<CubePoint<1>> {
    return CubePoint<1>{1.01 * g.uniform()};
  };
  const auto not_a_number = []() -> std::optional<CubePoint<1>> {
    return CubePoint<1>{std::nan("")};
  };
  const auto one = [](const CubePoint<1>&) { return 1.0; };
  const auto hole = [](const CubePoint<1>& u) { return u[0] > 0.9999 ? 0.0 : 1.0; };
  const auto infinite = [](const CubePoint<1>& u) {
    return u[0] < 0.001 ? std::numeric_limits<double>::infinity() : 1.0;
  };
  const auto too_much = [](const CubePoint<1>&) { return 1.01; };
  EXPECT_TRUE(passes(sampler_matches_density<1>(uniform, one)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(outside, one)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(not_a_number, one)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(uniform, hole)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(uniform, infinite)));
  EXPECT_TRUE(rejects(sampler_matches_density<1>(uniform, too_much)));
}

TEST(ChiSquare, PValuesAreUniformUnderATrueHypothesis) {
  Generator g(8);
  const auto density = [](const CubePoint<1>& u) { return 0.7 * 2 * u[0]; };
  const ChiSquareOptions small{.cells_per_axis = 11, .samples = 2000, .false_alarm = 0.05};
  constexpr std::uint64_t repetitions = 400;
  std::uint64_t rejections = 0;
  std::vector<double> p;
  for (std::uint64_t r = 0; r < repetitions; ++r) {
    const Decision d = sampler_matches_density<1>(defective(g), density, small);
    rejections += d.passed ? 0 : 1;
    p.push_back(d.p_value);
  }
  EXPECT_TRUE(passes(binomial_test(rejections, repetitions, 0.05, usual_false_alarm)));
  EXPECT_TRUE(passes(uniformity_test(p, usual_false_alarm, 10)));
}

TEST(ChiSquare, DirectionsAndCubePointsAreInverse) {
  Generator g(9);
  for (int i = 0; i < 1000; ++i) {
    const CubePoint<2> u{g.uniform(), g.uniform()};
    const auto [x, y] = direction_on_circle({u[0]});
    EXPECT_NEAR(cube_of_direction(x, y)[0], u[0], 1e-14);
    const auto [a, b, c] = direction_on_sphere(u);
    const CubePoint<2> back = cube_of_direction(a, b, c);
    EXPECT_NEAR(back[0], u[0], 1e-14);
    EXPECT_NEAR(back[1], u[1], 1e-14);
  }
}

}  // namespace
}  // namespace wander::test

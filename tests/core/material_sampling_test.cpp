// Every sampler of directions against the densities that evaluate() claims, for walks towards the
// sensor and towards the light.  Densities are with respect to projected angle: times |cos θ| they
// are per unit of angle.  False-alarm rate 1e-9 per χ² test.
#include <gtest/gtest.h>

#include "core/material.h"
#include "tests/core/directions.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

template <class W>
class Sampling : public ::testing::Test {
 public:
  static constexpr int D = W::dimension;
  using Direction = Vec<D, double>;

  // Of sampling w when `known` is known, per unit of angle.
  template <class M>
  static double density(const M& m, Toward toward, Direction known, Direction w) {
    const double projected = toward == Toward::sensor
                                 ? m.evaluate(Event::scattering, known, w).toward_sensor
                                 : m.evaluate(Event::scattering, w, known).toward_light;
    return projected * std::abs(Dimension<D>::cosine(w));
  }

  // `claimed` is the material whose density is held against the samples of `m`.
  template <class M>
  static Decision compare(const M& m, const M& claimed, Toward toward, Direction known,
                          std::uint64_t seed) {
    Generator generator(seed);
    const auto sample = [&]() -> std::optional<CubePoint<D - 1>> {
      const auto s = m.sample(known, {random_square<D>(generator), generator.uniform()});
      if (!s) return {};
      return cube_of<D>(s->direction);
    };
    const auto on_cube = [&](const CubePoint<D - 1>& u) {
      return all_directions<D> * density(claimed, toward, known, direction_of<D>(u));
    };
    ChiSquareOptions options = direction_options<D>();
    options.samples = 60'000;
    return sampler_matches_density<D - 1>(sample, on_cube, options);
  }

  template <class M>
  static void expect_match(const M& m, std::initializer_list<double> angles) {
    std::uint64_t seed = 1;
    for (const double angle : angles)
      for (const Toward toward : {Toward::sensor, Toward::light})
        EXPECT_TRUE(passes(compare(m, m, toward, local_at<D>(angle), ++seed)))
            << "known direction at " << angle << (toward == Toward::light ? ", to the light" : "");
  }
};
using Worlds = ::testing::Types<Flatland, Spaceland>;
TYPED_TEST_SUITE(Sampling, Worlds);

// Angles beyond π/2 are below the surface: inside, for glass.
TYPED_TEST(Sampling, OfDiffuseSurfacesMatchesTheirDensity) {
  TestFixture::expect_match(Diffuse<TypeParam>{0.7}, {0.0, 1.3, 2.0});
}

TYPED_TEST(Sampling, OfRoughConductorsMatchesTheirDensity) {
  for (const double roughness : {0.05, 0.2, 1.0}) {
    SCOPED_TRACE(roughness);
    TestFixture::expect_match(RoughConductor<TypeParam>{roughness, 0.9}, {0.1, -0.8, 1.4, 2.2});
  }
}

TYPED_TEST(Sampling, OfRoughMetalsMatchesTheirDensity) {
  const ComplexIndex<TypeParam> copper({0.2}, {3.9});
  TestFixture::expect_match(RoughMetal<TypeParam>{0.3, copper}, {0.1, -0.8, 1.4, 2.2});
}

TYPED_TEST(Sampling, OfRoughGlassMatchesItsDensity) {
  for (const double roughness : {0.05, 0.2, 1.0}) {
    SCOPED_TRACE(roughness);
    TestFixture::expect_match(RoughDielectric<TypeParam>{roughness, 1.5, 1},
                              {0.1, -0.8, 1.4, 3.0, 2.3, 1.8});
  }
}

TYPED_TEST(Sampling, OfRoughBubblesMatchesTheirDensity) {
  TestFixture::expect_match(RoughDielectric<TypeParam>{0.3, 1, 1.33}, {0.2, 1.2, 2.6});
}

TYPED_TEST(Sampling, OfAnotherMaterialIsToldApart) {
  using Conductor = RoughConductor<TypeParam>;
  using Glass = RoughDielectric<TypeParam>;
  const auto known = local_at<TypeParam::dimension>(0.8),
             inside = local_at<TypeParam::dimension>(2.3);
  EXPECT_TRUE(rejects(
      TestFixture::compare(Conductor{0.2, 1}, Conductor{0.21, 1}, Toward::sensor, known, 3)));
  EXPECT_TRUE(rejects(
      TestFixture::compare(Glass{0.2, 1.5, 1}, Glass{0.2, 1.45, 1}, Toward::light, inside, 3)));
}

// In the plane the grid of cells resolves a roughness of 0.02.
TEST(SharpSampling, OfTheSharpestRoughMaterialsMatchesTheirDensity) {
  using Plane = Sampling<Flatland>;
  Plane::expect_match(RoughConductor<Flatland>{0.02, 0.9}, {0.0, 0.7, -1.5});
  Plane::expect_match(RoughDielectric<Flatland>{0.02, 1.5, 1}, {0.0, 0.7, 1.5, 3.1, 2.4, 1.7});
}

// Much finer lobes than any grid: the slopes of the half vectors, seen head on, follow the law
// P(|m| < k α) = k / √(1 + k²) in the plane and k² / (1 + k²) in space.
TYPED_TEST(Sampling, OfAlmostSmoothConductorsHasTheSlopesOfItsRoughness) {
  constexpr int D = TypeParam::dimension;
  constexpr double alpha = 1e-5;
  const RoughConductor<TypeParam> conductor{alpha, 1};
  Generator generator(9);
  std::vector<double> quantiles;
  const auto up = local_at<D>(0);
  for (int i = 0; i < 50'000; ++i) {
    const auto s = conductor.sample(up, {random_square<D>(generator), 0});
    ASSERT_TRUE(s);
    const auto h = glm::normalize(s->direction + up);
    const double k = std::sqrt(Dimension<D>::squared_sine(h)) / Dimension<D>::cosine(h) / alpha;
    quantiles.push_back(D == 2 ? k / std::sqrt(1 + k * k) : k * k / (1 + k * k));
  }
  EXPECT_TRUE(passes(uniformity_test(quantiles, usual_false_alarm)));
  for (double& q : quantiles) q = std::pow(q, 1.05);  // control
  EXPECT_TRUE(rejects(uniformity_test(quantiles, usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test

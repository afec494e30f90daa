// Offsets of a given length, and directions at a given angle from another: they are that long or
// that far away, even all around, and as many as their measure says.  False-alarm rate 1e-9 per χ².
#include <gtest/gtest.h>

#include "tests/core/directions.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

template <class W>
class RingAndCone : public ::testing::Test {
 public:
  static constexpr int D = W::dimension;
};
using Worlds = ::testing::Types<Flatland, Spaceland>;
TYPED_TEST_SUITE(RingAndCone, Worlds);

TYPED_TEST(RingAndCone, RingsFillABallAndConesAllDirections) {
  constexpr int D = TestFixture::D;
  using Dim = Dimension<D>;
  const auto ring = [](double r) { return Dim::ring_measure(r); };
  EXPECT_NEAR(integral(ring, 0, 0.3), Dim::template ball_measure<double> * std::pow(0.3, D - 1),
              1e-12);
  const auto cone = [](double theta) { return Dim::cone_measure(theta); };
  EXPECT_NEAR(integral(cone, 0, std::numbers::pi), all_directions<D>, 1e-10);
}

TYPED_TEST(RingAndCone, OffsetsAreAsLongAsTheyShould) {
  constexpr int D = TestFixture::D;
  Generator generator(1);
  for (int i = 0; i < 1000; ++i) {
    const double r = std::pow(10, -8 * generator.uniform());
    double squares = 0;
    for (const double x : Dimension<D>::ring_offset(r, generator.uniform())) squares += x * x;
    EXPECT_NEAR(std::sqrt(squares) / r, 1, 1e-14);
  }
}

// Evenly spaced numbers make offsets that balance, and are as long along each axis.
TYPED_TEST(RingAndCone, OffsetsGoAllWaysAlike) {
  constexpr int D = TestFixture::D, count = 1000;
  constexpr double r = 0.3;
  std::array<double, D - 1> sum{}, squares{};
  for (int i = 0; i < count; ++i) {
    const auto offset = Dimension<D>::ring_offset(r, (i + 0.5) / count);
    for (std::size_t k = 0; k < offset.size(); ++k) {
      sum[k] += offset[k];
      squares[k] += offset[k] * offset[k];
    }
  }
  for (std::size_t k = 0; k < sum.size(); ++k) {
    EXPECT_NEAR(sum[k], 0, 1e-11);
    EXPECT_NEAR(squares[k], count * r * r / (D - 1), 1e-11);
  }
}

TYPED_TEST(RingAndCone, DirectionsAreAsFarAsTheyShould) {
  constexpr int D = TestFixture::D;
  Generator generator(2);
  for (int i = 0; i < 1000; ++i) {
    const double theta = 1.5 * std::pow(10, -6 * generator.uniform());
    const auto axis = random_direction<D>(generator);
    const auto w = Dimension<D>::cone_direction(axis, theta, generator.uniform());
    EXPECT_NEAR(glm::length(w), 1, 1e-14);
    // The chord, which is exact for small angles as the cosine is not.
    EXPECT_NEAR(glm::length(w - axis) / (2 * std::sin(theta / 2)), 1, 1e-9);
  }
}

TYPED_TEST(RingAndCone, BothAreEvenAllAround) {
  constexpr int D = TestFixture::D;
  using Dim = Dimension<D>;
  Generator generator(3);
  const auto even = [](const CubePoint<D - 1>&) { return 1.0; };
  // An angle that fills all directions evenly makes cones that do.
  const auto angle = [&] {
    const double u = generator.uniform();
    return D == 2 ? std::numbers::pi * u : std::acos(1 - 2 * u);
  };
  const auto axis = random_direction<D>(generator);
  const auto around = [&] {
    const double theta = angle();
    return std::optional(cube_of<D>(Dim::cone_direction(axis, theta, generator.uniform())));
  };
  EXPECT_TRUE(passes((sampler_matches_density<D - 1>(around, even, direction_options<D>()))));
  const auto lopsided = [&] {
    const double theta = angle(), u = generator.uniform();
    return std::optional(cube_of<D>(Dim::cone_direction(axis, theta, u * u)));
  };
  EXPECT_TRUE(rejects((sampler_matches_density<D - 1>(lopsided, even, direction_options<D>()))));
}

}  // namespace
}  // namespace wander::test

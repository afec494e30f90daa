// What differs between the plane and space: constants, frames, and the maps of the unit cube onto
// directions.  False-alarm rate 1e-9 per χ² test.
#include "core/dimension.h"

#include <gtest/gtest.h>

#include "tests/core/directions.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

template <class W>
class InDimension : public ::testing::Test {
 public:
  static constexpr int D = W::dimension;
  using Dim = Dimension<D>;
  using Direction = Vec<D, double>;
  using Square = std::array<double, D - 1>;

  // Heitz 2014, eq. 2: |v·h|⁺ G1(v) D(h) / cos θ_v, per unit of angle.
  static double visible_normals(double alpha, Direction v, Direction h) {
    const double cosine = Dim::cosine(v), toward = glm::dot(v, h);
    if (toward <= 0 || Dim::cosine(h) <= 0) return 0;
    const double tangent = std::sqrt(Dim::squared_sine(v)) / cosine;
    const double masking = 2 / (1 + std::sqrt(1 + alpha * alpha * tangent * tangent));
    return toward * masking * Dim::ggx(alpha, h) / cosine;
  }

  template <class Density>
  static auto on_cube(Density density) {
    return [density](const CubePoint<D - 1>& u) {
      return all_directions<D> * density(direction_of<D>(u));
    };
  }
};
using Worlds = ::testing::Types<Flatland, Spaceland>;
TYPED_TEST_SUITE(InDimension, Worlds);

TYPED_TEST(InDimension, TheHalfSpaceConstantIsTheIntegralOfTheCosine) {
  constexpr int D = TestFixture::D;
  const auto cosine = [](const Vec<D, double>& w) {
    return std::max(0.0, Dimension<D>::cosine(w));
  };
  EXPECT_NEAR(integral_over_directions<D>(cosine, {.absolute = 1e-10, .depth = 12}),
              Dimension<D>::template half_space<double>, 1e-8);
}

TYPED_TEST(InDimension, PowersOfDistanceAndIndexAreThoseOfTheDimension) {
  constexpr int D = TestFixture::D;
  using Dim = Dimension<D>;
  EXPECT_DOUBLE_EQ(Dim::spread(1.7), std::pow(1.7, D - 1));
  EXPECT_DOUBLE_EQ(Dim::index_spread(1.5), std::pow(1.5, D - 1));
  EXPECT_DOUBLE_EQ(Dim::film_spread(0.8), std::pow(0.8, D + 1));
  EXPECT_DOUBLE_EQ(Dim::reflection(0.8), 1 / (std::pow(2.0, D - 1) * std::pow(0.8, D - 2)));
  EXPECT_DOUBLE_EQ(Dim::template ball_measure<double>, D == 2 ? 2 : std::numbers::pi);
}

TYPED_TEST(InDimension, FramesAreOrthonormalAndTurnBack) {
  constexpr int D = TestFixture::D;
  Generator generator(1);
  std::vector<Vec<D, double>> normals;
  for (int i = 0; i < 1000; ++i) normals.push_back(random_direction<D>(generator));
  for (int axis = 0; axis < D; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      normals.emplace_back(0);
      normals.back()[axis] = sign;
    }
  for (const auto& normal : normals) {
    const Frame<D, double> frame{normal};
    const auto up = frame.to_local(normal);
    EXPECT_NEAR(Dimension<D>::cosine(up), 1, 1e-14);
    const auto w = random_direction<D>(generator), v = random_direction<D>(generator);
    EXPECT_NEAR(glm::length(frame.to_world(frame.to_local(w)) - w), 0, 2e-15);
    EXPECT_NEAR(glm::dot(frame.to_local(w), frame.to_local(v)), glm::dot(w, v), 2e-15);
  }
}

// However near z a normal is; and at z, along whichever edge.
TEST(FramesOfSpace, AreOrthonormalAndMakeQuarterTurnsWithTheWorld) {
  using Vector = Vec<3, double>;
  Generator g(5);
  const auto turned = [](Vector v) { return Vector(-v.y, v.x, v.z); };
  std::vector<Vector> edges{{1, 0, 0}, {1, 1, 0}, {-3, 3, 0}, {-1, -1, 0}, {2, -2, 0}, {0, -2, 0}};
  for (int i = 0; i < 20; ++i) edges.push_back(random_direction<3>(g));
  for (const double off : {1.0, 1e-3, 1e-8, 1e-100, 1e-160, 0.0})
    for (const double side : {-1.0, 1.0})
      for (const Vector& edge : edges) {
        const Vector n = glm::normalize(Vector(off * g.uniform(), -off, side));
        const Frame<3, double> frame(n, [&] { return edge; });
        const Frame<3, double> other(turned(n), [&] { return turned(edge); });
        const Vector v = random_direction<3>(g);
        EXPECT_NEAR(glm::length(frame.to_local(v)), 1, 1e-15);
        EXPECT_NEAR(glm::length(frame.to_world(frame.to_local(v)) - v), 0, 2e-15);
        EXPECT_GT(glm::dot(glm::cross(frame.tangent, frame.bitangent), n), 1 - 1e-14);
        EXPECT_EQ(other.to_world(v), turned(frame.to_world(v)));
        EXPECT_EQ(other.to_local(turned(v)), frame.to_local(v));
      }
}

TYPED_TEST(InDimension, CosineSamplesHaveTheDensityOfTheCosine) {
  constexpr int D = TestFixture::D;
  using Dim = Dimension<D>;
  Generator generator(2);
  const auto sample = [&] {
    return std::optional(cube_of<D>(Dim::cosine_sample(random_square<D>(generator))));
  };
  const auto density = TestFixture::on_cube([](const Vec<D, double>& w) {
    return std::max(0.0, Dim::cosine(w)) / Dim::template half_space<double>;
  });
  EXPECT_TRUE(passes((sampler_matches_density<D - 1>(sample, density, direction_options<D>()))));
  // Control: uniform directions.
  const auto uniform = [&] {
    auto w = random_direction<D>(generator);
    w[D - 1] = std::abs(w[D - 1]);
    return std::optional(cube_of<D>(w));
  };
  EXPECT_TRUE(rejects((sampler_matches_density<D - 1>(uniform, density, direction_options<D>()))));
}

TYPED_TEST(InDimension, BallSamplesAreUniform) {
  constexpr int D = TestFixture::D;
  Generator generator(3);
  const auto to_cube = [](std::array<double, D - 1> p) {
    for (double& x : p) x = (x + 1) / 2;
    return std::optional(p);
  };
  const auto sample = [&] {
    return to_cube(Dimension<D>::ball_sample(random_square<D>(generator)));
  };
  const auto density = [](const CubePoint<D - 1>& u) {
    double squared = 0;
    for (const double x : u) squared += (2 * x - 1) * (2 * x - 1);
    return squared <= 1 ? std::pow(2, D - 1) / Dimension<D>::template ball_measure<double> : 0;
  };
  EXPECT_TRUE(passes((sampler_matches_density<D - 1>(sample, density, direction_options<D>()))));
  // Control: a radius that is uniform in space, squared in the plane.
  const auto crowded = [&] {
    auto u = random_square<D>(generator);
    u[0] *= u[0];
    return to_cube(Dimension<D>::ball_sample(u));
  };
  EXPECT_TRUE(rejects((sampler_matches_density<D - 1>(crowded, density, direction_options<D>()))));
}

TYPED_TEST(InDimension, VisibleNormalsHaveTheirDensity) {
  constexpr int D = TestFixture::D;
  Generator generator(4);
  for (const double alpha : {0.1, 0.5, 1.0})
    for (const double angle : {0.0, 0.6, -1.2, 1.5}) {
      const auto v = local_at<D>(angle);
      const auto sample = [&] {
        return std::optional(
            cube_of<D>(Dimension<D>::visible_normal_sample(alpha, v, random_square<D>(generator))));
      };
      const auto density = TestFixture::on_cube(
          [&](const Vec<D, double>& h) { return TestFixture::visible_normals(alpha, v, h); });
      EXPECT_TRUE(passes((sampler_matches_density<D - 1>(sample, density, direction_options<D>()))))
          << "roughness " << alpha << ", angle " << angle;
    }
}

TYPED_TEST(InDimension, NormalsOfAnotherRoughnessAreToldApart) {
  constexpr int D = TestFixture::D;
  Generator generator(5);
  const auto v = local_at<D>(0.9);
  const auto sample = [&] {
    return std::optional(
        cube_of<D>(Dimension<D>::visible_normal_sample(0.53, v, random_square<D>(generator))));
  };
  const auto density = TestFixture::on_cube(
      [&](const Vec<D, double>& h) { return TestFixture::visible_normals(0.5, v, h); });
  EXPECT_TRUE(rejects((sampler_matches_density<D - 1>(sample, density, direction_options<D>()))));
}

TYPED_TEST(InDimension, MicrofacetsCoverTheSurfaceOnce) {
  constexpr int D = TestFixture::D;
  for (const double alpha : {0.02, 0.1, 0.3, 1.0}) {
    const auto projected = [&](const Vec<D, double>& h) {
      return Dimension<D>::cosine(h) > 0 ? Dimension<D>::ggx(alpha, h) * Dimension<D>::cosine(h)
                                         : 0;
    };
    EXPECT_NEAR(integral_over_directions<D>(projected, {.absolute = 1e-9, .depth = 14}), 1, 1e-6);
  }
}

TYPED_TEST(InDimension, VisibleMicrofacetsCoverTheViewOnce) {
  constexpr int D = TestFixture::D;
  for (const double alpha : {0.05, 0.3, 1.0})
    for (const double angle : {0.2, 1.2}) {
      const auto seen = [&](const Vec<D, double>& h) {
        return TestFixture::visible_normals(alpha, local_at<D>(angle), h);
      };
      EXPECT_NEAR(integral_over_directions<D>(seen, {.absolute = 1e-7, .depth = 11}), 1, 1e-4);
    }
}

// At α = 1e-5 the tangent component carries the angle: relative error 1e-6 at worst.
TYPED_TEST(InDimension, TinyRoughnessKeepsItsDistribution) {
  constexpr int D = TestFixture::D;
  constexpr double alpha = 1e-5;
  const double top = 1 / (D == 2 ? 2 * alpha : std::numbers::pi * alpha * alpha);
  for (const double slope : {0.0, 0.1, 1.0, 10.0, 1e3}) {
    // P(m)/cos^(D+1), from the slope m = slope · α, in long double.
    const long double m = static_cast<long double>(slope) * alpha,
                      cosine = 1 / std::sqrt(1 + m * m);
    const long double falloff =
        std::pow(1 + static_cast<long double>(slope) * slope, D == 2 ? 1.5L : 2.0L);
    const auto exact =
        static_cast<double>(top / falloff / std::pow(cosine, static_cast<long double>(D + 1)));
    const auto h = local_at<D>(std::atan(slope * alpha));
    EXPECT_NEAR(Dimension<D>::ggx(alpha, h) / exact, 1, 1e-6) << "slope " << slope << " α";
  }
}

TYPED_TEST(InDimension, EveryMapOfTheCubeIsInverted) {
  constexpr int D = TestFixture::D;
  using Dim = Dimension<D>;
  Generator generator(6);
  const auto distance = [](const auto& a, const auto& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const double d = std::abs(a[k] - b[k]);
      most = std::max(most, k == 0 ? d : std::min(d, 1 - d));  // the second number is a turn
    }
    return most;
  };
  for (int i = 0; i < 20'000; ++i) {
    const auto u = random_square<D>(generator);
    ASSERT_LT(distance(Dim::cosine_invert(Dim::cosine_sample(u)), u), 1e-13);
    ASSERT_LT(distance(Dim::ball_invert(Dim::ball_sample(u)), u), 1e-13);
    auto v = random_direction<D>(generator);
    v[D - 1] = std::abs(v[D - 1]) + 1e-3;
    v = glm::normalize(v);
    const double alpha = std::pow(10, -4 * generator.uniform());
    const auto h = Dim::visible_normal_sample(alpha, v, u);
    const auto again =
        Dim::visible_normal_sample(alpha, v, Dim::visible_normal_invert(alpha, v, h));
    ASSERT_LT(glm::length(again - h), 1e-7) << "roughness " << alpha;
  }
}

TYPED_TEST(InDimension, TheEndsOfTheUnitIntervalGiveDirections) {
  constexpr int D = TestFixture::D;
  using Dim = Dimension<D>;
  const double last = std::nextafter(1.0, 0.0);
  std::vector<std::array<double, D - 1>> corners;
  for (const double a : {0.0, 0.5, last})
    for (const double b : {0.0, 0.25, last}) {
      std::array<double, D - 1> u{};
      u[0] = a;
      if constexpr (D == 3) u[1] = b;
      corners.push_back(u);
    }
  for (const auto& u : corners) {
    const auto w = Dim::cosine_sample(u);
    EXPECT_NEAR(glm::length(w), 1, 1e-14);
    EXPECT_GE(Dim::cosine(w), 0);
    for (const double alpha : {1e-5, 0.1, 1.0})
      for (const double angle : {0.0, 1.0, 1.57079}) {
        const auto h = Dim::visible_normal_sample(alpha, local_at<D>(angle), u);
        EXPECT_NEAR(glm::length(h), 1, 1e-14);
        EXPECT_GE(Dim::cosine(h), 0);
      }
  }
}

}  // namespace
}  // namespace wander::test

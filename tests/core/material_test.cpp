// What holds for every material: reciprocity, roles, energy, inversion, and no surprises at the
// ends of the domain.
#include "core/material.h"

#include <gtest/gtest.h>

#include "tests/core/directions.h"

namespace wander::test {
namespace {

template <class W>
class Materials : public ::testing::Test {
 public:
  static constexpr int D = W::dimension;
  using Direction = Vec<D, double>;
  using Dim = Dimension<D>;

  // Calls f(material, exterior index, interior index) for materials without specular events.
  template <class F>
  static void for_each(F&& f) {
    f(Diffuse<W>{0.75}, 1.0, 1.0);
    for (const double roughness : {1e-3, 0.02, 0.2, 1.0}) {
      f(RoughConductor<W>{roughness, 0.9}, 1.0, 1.0);
      f(RoughMetal<W>{roughness, ComplexIndex<W>({0.2}, {3.9})}, 1.0, 1.0);
      f(RoughDielectric<W>{roughness, 1.5, 1}, 1.0, 1.5);
      f(RoughDielectric<W>{roughness, 1, 1.8}, 1.8, 1.0);
    }
  }
  static double spread(Direction w, double exterior, double interior) {
    return Dim::index_spread(Dim::cosine(w) > 0 ? exterior : interior);
  }
  // A pair that this material can scatter, on either side.
  template <class M>
  static std::optional<std::pair<Direction, Direction>> pair(const M& m, Generator& g) {
    const Direction known = random_direction<D>(g);
    const auto sample = m.sample(known, {random_square<D>(g), g.uniform()});
    if (!sample) return {};
    return std::pair(known, sample->direction);
  }
};
using Worlds = ::testing::Types<Flatland, Spaceland>;
TYPED_TEST_SUITE(Materials, Worlds);

TYPED_TEST(Materials, AreReciprocalUpToTheSpreadOfTheIndex) {
  Generator g(1);
  TestFixture::for_each([&](const auto& m, double exterior, double interior) {
    for (int i = 0; i < 3000; ++i) {
      const auto pair = TestFixture::pair(m, g);
      if (!pair) continue;
      const auto [a, b] = *pair;
      const double there =
          m.evaluate(Event::scattering, a, b).value / TestFixture::spread(b, exterior, interior);
      const double back =
          m.evaluate(Event::scattering, b, a).value / TestFixture::spread(a, exterior, interior);
      ASSERT_NEAR(there / back, 1, 1e-9);
    }
  });
}

TYPED_TEST(Materials, SampleTheSameFromBothEnds) {
  Generator g(2);
  TestFixture::for_each([&](const auto& m, double, double) {
    for (int i = 0; i < 3000; ++i) {
      const auto pair = TestFixture::pair(m, g);
      if (!pair) continue;
      const auto [a, b] = *pair;
      const auto there = m.evaluate(Event::scattering, a, b),
                 back = m.evaluate(Event::scattering, b, a);
      ASSERT_NEAR(there.toward_light / back.toward_sensor, 1, 1e-9);
      ASSERT_NEAR(there.toward_sensor / back.toward_light, 1, 1e-9);
    }
  });
}

// G = 1 / (1 + Λ_i + Λ_o), and G1 = 1 / (1 + Λ) in the density, with Smith's Λ of GGX [Heitz 2014].
TYPED_TEST(Materials, MaskAndShadowWithTheCorrelationOfHeights) {
  using Direction = typename TestFixture::Direction;
  Generator g(11);
  for (const double roughness : {0.02, 0.2, 1.0}) {
    const auto lambda = [&](Direction w) {
      const double cosine = TestFixture::Dim::cosine(w);
      const double tangent2 = TestFixture::Dim::squared_sine(w) / (cosine * cosine);
      return (std::sqrt(1 + roughness * roughness * tangent2) - 1) / 2;
    };
    const RoughConductor<TypeParam> metal{roughness, 0.9};
    for (int i = 0; i < 3000; ++i) {
      const auto pair = TestFixture::pair(metal, g);
      if (!pair) continue;
      const auto& [light, sensor] = *pair;
      const auto s = metal.evaluate(Event::scattering, light, sensor);
      const double a = lambda(light), b = lambda(sensor);
      ASSERT_NEAR(s.value / s.toward_sensor / (0.9 * (1 + a) / (1 + a + b)), 1, 1e-6);
      ASSERT_NEAR(s.value / s.toward_light / (0.9 * (1 + b) / (1 + a + b)), 1, 1e-6);
    }
  }
}

// f |cos| / p of a sampled direction: flux never grows, radiance by no more than the index allows.
TYPED_TEST(Materials, GiveSampledDirectionsABoundedWeight) {
  Generator g(3);
  TestFixture::for_each([&](const auto& m, double exterior, double interior) {
    for (int i = 0; i < 3000; ++i) {
      const auto pair = TestFixture::pair(m, g);
      if (!pair) continue;
      const auto [known, w] = *pair;
      const auto from_light = m.evaluate(Event::scattering, known, w);
      ASSERT_GT(from_light.toward_sensor, 0);
      ASSERT_LE(from_light.value / from_light.toward_sensor, 1 + 1e-12);
      const auto from_sensor = m.evaluate(Event::scattering, w, known);
      const double squeeze = TestFixture::spread(known, exterior, interior) /
                             TestFixture::spread(w, exterior, interior);
      ASSERT_GT(from_sensor.toward_light, 0);
      ASSERT_LE(from_sensor.value / from_sensor.toward_light, squeeze * (1 + 1e-9));
    }
  });
}

TYPED_TEST(Materials, ScatterNoMoreLightThanTheyReceive) {
  constexpr int D = TestFixture::D;
  const auto albedo = [&](const auto& m, double angle) {
    const auto outgoing = [&](const Vec<D, double>& w) {
      return m.evaluate(Event::scattering, local_at<D>(angle), w).value *
             std::abs(Dimension<D>::cosine(w));
    };
    return integral_over_directions<D>(outgoing, {.absolute = 1e-6, .depth = 9});
  };
  for (const double angle : {0.1, 1.0, 1.5, 2.0, 3.0}) {
    EXPECT_NEAR(albedo(Diffuse<TypeParam>{0.75}, angle), 0.75, 1e-6);
    for (const double roughness : {0.1, 0.3, 1.0}) {
      const double conductor = albedo(RoughConductor<TypeParam>{roughness, 1}, angle);
      const double glass = albedo(RoughDielectric<TypeParam>{roughness, 1.5, 1}, angle);
      EXPECT_LE(conductor, 1 + 1e-4);
      EXPECT_LE(glass, 1 + 1e-4);
      // Single scattering loses little where the surface is almost smooth and seen from above.
      if (roughness == 0.1 && (angle == 0.1 || angle == 3.0)) {
        EXPECT_GT(conductor, 0.98);
        EXPECT_GT(glass, 0.98);
      }
    }
  }
}

TYPED_TEST(Materials, SampleAgainFromTheNumbersOfADirection) {
  constexpr int D = TestFixture::D;
  Generator g(4);
  TestFixture::for_each([&](const auto& m, double, double) {
    for (int i = 0; i < 3000; ++i) {
      const auto known = random_direction<D>(g);
      const ScatterNumbers<TypeParam> u{random_square<D>(g), g.uniform()};
      const auto sample = m.sample(known, u);
      if (!sample) continue;
      const auto numbers = m.invert(known, sample->direction, sample->event);
      ASSERT_FALSE(numbers.direction_is_free);
      ASSERT_LE(numbers.lobe_low, u.lobe);
      ASSERT_LT(u.lobe, numbers.lobe_high);
      const auto again = m.sample(known, {numbers.direction, u.lobe});
      ASSERT_TRUE(again);
      // The projection of the facet on the plane is what the numbers hold: grazing costs half the
      // bits.
      ASSERT_LT(glm::length(again->direction - sample->direction), 1e-6);
    }
  });
}

TYPED_TEST(Materials, TurnNumbersIntoDirectionsAndBack) {
  constexpr int D = TestFixture::D;
  Generator g(5);
  const auto check = [&](const auto& m, double lobe, double tolerance) {
    for (int i = 0; i < 3000; ++i) {
      const auto known = local_at<D>(1.2 * g.uniform(), 6 * g.uniform());
      ScatterNumbers<TypeParam> u{random_square<D>(g), lobe};
      for (double& x : u.direction) x = 0.02 + 0.96 * x;
      const auto sample = m.sample(known, u);
      if (!sample) continue;
      const auto numbers = m.invert(known, sample->direction, sample->event);
      for (std::size_t k = 0; k < u.direction.size(); ++k)
        ASSERT_NEAR(numbers.direction[k], u.direction[k], tolerance);
    }
  };
  check(Diffuse<TypeParam>{0.5}, 0, 1e-13);
  for (const double roughness : {0.02, 0.3, 1.0}) {
    check(RoughConductor<TypeParam>{roughness, 0.5}, 0, 1e-10);
    check(RoughDielectric<TypeParam>{roughness, 1.5, 1}, 0, 1e-10);       // reflects
    check(RoughDielectric<TypeParam>{roughness, 1.5, 1}, 0.9999, 1e-10);  // transmits
  }
}

TYPED_TEST(Materials, MirrorsTurnDirectionsOver) {
  constexpr int D = TestFixture::D;
  Generator g(6);
  const Mirror<TypeParam> mirror{0.9};
  for (int i = 0; i < 1000; ++i) {
    const auto known = random_direction<D>(g);
    const auto sample = mirror.sample(known, {random_square<D>(g), g.uniform()});
    EXPECT_EQ(sample->event, Event::reflection);
    EXPECT_EQ(Dimension<D>::cosine(sample->direction), Dimension<D>::cosine(known));
    for (int axis = 0; axis + 1 < D; ++axis) EXPECT_EQ(sample->direction[axis], -known[axis]);
    const auto s = mirror.evaluate(Event::reflection, known, sample->direction);
    EXPECT_EQ(s.value, 0.9 * s.toward_sensor);
    EXPECT_EQ(s.value, 0.9 * s.toward_light);
  }
}

TYPED_TEST(Materials, OpaqueOnesPassNothingThrough) {
  constexpr int D = TestFixture::D;
  const auto above = local_at<D>(0.4), below = local_at<D>(2.9);
  for (const auto& [a, b] : {std::pair(above, below), std::pair(below, above)}) {
    EXPECT_EQ((Diffuse<TypeParam>{1}.evaluate(Event::scattering, a, b).value), 0);
    EXPECT_EQ((Mirror<TypeParam>{1}.evaluate(Event::reflection, a, b).value), 0);
    EXPECT_EQ((RoughConductor<TypeParam>{0.2, 1}.evaluate(Event::scattering, a, b).value), 0);
  }
  EXPECT_FALSE((Black<TypeParam>{}.sample(above, {})));
}

// Any directions and numbers, the ends of the unit interval among them: finite and not negative.
TYPED_TEST(Materials, AreFiniteAtTheExtremes) {
  constexpr int D = TestFixture::D;
  Generator g(7);
  const double last = std::nextafter(1.0, 0.0);
  const auto number = [&] {
    const double kind = g.uniform();
    return kind < 0.2 ? 0.0 : kind < 0.4 ? last : g.uniform();
  };
  const auto check = [&](const auto& m, double, double) {
    for (int i = 0; i < 5000; ++i) {
      const double cosine = std::pow(10, -8 * g.uniform());
      const auto known = local_at<D>((g.uniform() < 0.5 ? 1 : -1) * std::acos(cosine));
      ScatterNumbers<TypeParam> u{{}, number()};
      for (double& x : u.direction) x = number();
      const auto sample = m.sample(known, u);
      if (!sample) continue;
      ASSERT_NEAR(glm::length(sample->direction), 1, 1e-12);
      if (Dimension<D>::cosine(sample->direction) == 0) continue;  // carries no light
      const auto s = m.evaluate(sample->event, known, sample->direction);
      for (const double x : {s.value, s.toward_sensor, s.toward_light}) {
        ASSERT_TRUE(std::isfinite(x)) << "cosine " << cosine;
        ASSERT_GE(x, 0);
      }
    }
  };
  TestFixture::for_each(check);
  check(RoughConductor<TypeParam>{1e-5, 1}, 1, 1);
  check(RoughDielectric<TypeParam>{1e-5, 1.5, 1}, 1, 1.5);
}

}  // namespace
}  // namespace wander::test

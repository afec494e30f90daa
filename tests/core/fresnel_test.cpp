// Fresnel reflectance, unpolarised, and the smooth interface that it divides light at.
#include <gtest/gtest.h>

#include "core/material.h"
#include "tests/core/directions.h"

namespace wander::test {
namespace {

TEST(Fresnel, ReflectsATwentyFifthAtNormalIncidenceOnGlass) {
  EXPECT_NEAR(fresnel(1.0, 1.0, 1.5), 0.04, 1e-16);
  EXPECT_NEAR(fresnel(1.0, 1.5, 1.0), 0.04, 1e-16);
}

// Brewster's angle, tan θ = 1.5: one polarisation vanishes, ((n² - 1)/(n² + 1))² of the other is
// left.
TEST(Fresnel, HalvesAtBrewstersAngle) {
  const double other = (1.5 * 1.5 - 1) / (1.5 * 1.5 + 1);
  EXPECT_NEAR(fresnel(std::cos(std::atan(1.5)), 1.0, 1.5), other * other / 2, 1e-16);
}

TEST(Fresnel, IsTheSameFromEitherSide) {
  Generator generator(1);
  for (int i = 0; i < 10'000; ++i) {
    const double index = 1 + 2 * generator.uniform(),
                 cosine = 1e-3 + generator.uniform() * (1 - 1e-3);
    const double sine = std::sqrt((1 - cosine) * (1 + cosine)) / index;
    const double across = std::sqrt((1 - sine) * (1 + sine));
    ASSERT_NEAR(fresnel(cosine, 1.0, index), fresnel(across, index, 1.0), 1e-11);
  }
}

TEST(Fresnel, IsExactlyOneUnderTotalInternalReflection) {
  const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
  for (const double part : {0.0, 1e-300, 1e-9, 0.5, 0.999})
    EXPECT_EQ(fresnel(part * critical, 1.5, 1.0), 1);
  const double f = fresnel(critical, 1.5, 1.0);  // at the angle itself, to its rounding
  EXPECT_LE(f, 1);
  EXPECT_GT(f, 1 - 1e-6);
  EXPECT_EQ(fresnel(0.0, 1.0, 1.5), 1);  // grazing
}

// 1 - sin² keeps ε / cos² of the squared cosine, and the amplitude is half of that.
TEST(Fresnel, VanishesBetweenEqualIndicesUpToRounding) {
  for (const double cosine : {1.0, 0.5, 1e-3}) EXPECT_LE(fresnel(cosine, 1.5, 1.5), 3e-10);
  for (const double cosine : {1.0, 0.5, 1e-3, 1e-5, 1e-7}) {
    const double amplitude = std::numeric_limits<double>::epsilon() / (cosine * cosine);
    EXPECT_LE(fresnel(cosine, 1.5, 1.5), amplitude * amplitude) << "cosine " << cosine;
  }
}

TEST(Fresnel, IsAProbability) {
  Generator generator(2);
  for (int i = 0; i < 100'000; ++i) {
    const double a = std::pow(10, 6 * generator.uniform() - 3),
                 cosine = std::pow(10, -16 * generator.uniform());
    const double f = fresnel(cosine, 1.0, a);
    ASSERT_GE(f, 0);
    ASSERT_LE(f, 1);
  }
}

// ∫ F cos θ dω / ∫ cos θ dω; in D dimensions the weight is cos θ sin^(D-2) θ.
template <int D>
double average(double n_incident, double n_transmitted) {
  const auto weight = [](double angle) {
    return std::cos(angle) * std::pow(std::sin(angle), D - 2);
  };
  const auto f = [&](double angle) {
    return weight(angle) * fresnel(std::cos(angle), n_incident, n_transmitted);
  };
  const double right = std::numbers::pi / 2;
  const double critical =
      n_incident > n_transmitted ? std::asin(n_transmitted / n_incident) : right / 2;
  return (integral(f, 0, critical) + integral(f, critical, right)) / integral(weight, 0, right);
}

TEST(Fresnel, HasTheKnownAveragesInThePlane) {
  EXPECT_NEAR(average<2>(1, 1.5), 0.06797652684085177, 1e-10);
  EXPECT_NEAR(average<2>(1.5, 1), 0.378651017893901, 1e-10);
}

TEST(Fresnel, LetsAsMuchEtendueInAsOut) {
  for (const double index : {1.1, 1.5, 3.0}) {
    EXPECT_NEAR((1 - average<2>(index, 1)) * index, 1 - average<2>(1, index), 1e-9);
    EXPECT_NEAR((1 - average<3>(index, 1)) * index * index, 1 - average<3>(1, index), 1e-9);
  }
}

template <class W>
class SmoothGlass : public ::testing::Test {
 public:
  static constexpr int D = W::dimension;
  Dielectric<W> glass{1.5, 1};

  double index_at(Vec<D, double> w) const { return Dimension<D>::cosine(w) > 0 ? 1 : 1.5; }
};
using Worlds = ::testing::Types<Flatland, Spaceland>;
TYPED_TEST_SUITE(SmoothGlass, Worlds);

TYPED_TEST(SmoothGlass, ObeysSnellsLaw) {
  constexpr int D = TestFixture::D;
  Generator generator(3);
  int transmitted = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto known = random_direction<D>(generator);
    const auto sample =
        this->glass.sample(known, {random_square<D>(generator), generator.uniform()});
    ASSERT_TRUE(sample);
    const auto w = sample->direction;
    ASSERT_NEAR(glm::length(w), 1, 1e-14);
    // n sin θ, as a vector along the surface, turns its sign.
    for (int axis = 0; axis + 1 < D; ++axis)
      ASSERT_NEAR(this->index_at(w) * w[axis], -this->index_at(known) * known[axis], 1e-13);
    const bool across = Dimension<D>::cosine(w) * Dimension<D>::cosine(known) < 0;
    ASSERT_EQ(sample->event, across ? Event::transmission : Event::reflection);
    transmitted += across;
  }
  EXPECT_GT(transmitted, 1000);
}

// A walk from the light carries flux: weight 1.  A walk from the sensor carries radiance, which is
// squeezed by n^(D-1) (Veach, ch. 5); neither loses energy.
TYPED_TEST(SmoothGlass, ScalesRadianceByTheIndexAndFluxNotAtAll) {
  constexpr int D = TestFixture::D;
  Generator generator(4);
  for (int i = 0; i < 10'000; ++i) {
    const auto known = random_direction<D>(generator);
    const auto sample =
        this->glass.sample(known, {random_square<D>(generator), generator.uniform()});
    const auto w = sample->direction;
    const auto from_light = this->glass.evaluate(sample->event, known, w);
    ASSERT_NEAR(from_light.value / from_light.toward_sensor, 1, 1e-12);
    const auto from_sensor = this->glass.evaluate(sample->event, w, known);
    const double squeeze = std::pow(this->index_at(known) / this->index_at(w), D - 1);
    ASSERT_NEAR(from_sensor.value / from_sensor.toward_light, squeeze, 1e-12);
    // The coefficients of both ways are of one δ in étendue n^(D-1) dσ⊥.
    ASSERT_NEAR(from_light.toward_sensor, from_sensor.toward_light, 1e-9);
  }
}

TYPED_TEST(SmoothGlass, ChoosesReflectionAsOftenAsFresnelSays) {
  constexpr int D = TestFixture::D;
  Generator generator(5);
  for (const double angle : {0.3, 1.2, 2.5, 2.0}) {
    const auto known = local_at<D>(angle);
    const double n = this->index_at(known);
    const double f = fresnel(std::abs(std::cos(angle)), n, 2.5 - n);
    for (int i = 0; i < 1000; ++i) {
      const double lobe = generator.uniform();
      const auto sample = this->glass.sample(known, {{}, lobe});
      ASSERT_EQ(sample->event, lobe < f ? Event::reflection : Event::transmission);
      const auto numbers = this->glass.invert(known, sample->direction, sample->event);
      ASSERT_LE(numbers.lobe_low, lobe);
      ASSERT_LT(lobe, numbers.lobe_high);
      ASSERT_TRUE(numbers.direction_is_free);
    }
  }
}

TYPED_TEST(SmoothGlass, GivesNothingWhereTheEventDoesNotFitTheDirections) {
  constexpr int D = TestFixture::D;
  const auto above = local_at<D>(0.3), below = local_at<D>(2.8);
  EXPECT_EQ(this->glass.evaluate(Event::transmission, above, local_at<D>(-0.3)).value, 0);
  EXPECT_EQ(this->glass.evaluate(Event::reflection, above, below).value, 0);
}

}  // namespace
}  // namespace wander::test

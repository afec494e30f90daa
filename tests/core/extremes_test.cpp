// Extremes of geometry, of materials and of brightness: what is computed is right within a stated
// tolerance, in float and in double, and nothing is ever a NaN.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include "core/path_sides.h"
#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

template <class W>
class Extremes : public ::testing::Test {
 public:
  using Real = typename W::Real;
  static constexpr double rounding = std::numeric_limits<Real>::epsilon();
  static constexpr Real last = 1 - std::numeric_limits<Real>::epsilon() / 2;

  static typename W::Local at(double angle) { return {std::sin(angle), std::cos(angle)}; }
};
using Precisions = ::testing::Types<Flatland, FlatlandSingle>;
TYPED_TEST_SUITE(Extremes, Precisions);

// Exactly grazing: G is zero, so they exchange no light, by any method.
TYPED_TEST(Extremes, LightAndSensorOnOneLineSeeNothing) {
  SceneMaker maker(3);
  maker.segment({0, 0.3}, {1, 0.3}, {maker.diffuse(0.5), 0, 2});
  maker.segment({2, 0.3}, {3, 0.3}, {maker.diffuse(0.5), 1});
  const auto scene = build_flatland<TypeParam>(maker.description());
  for (const auto method : {"pt", "lt", "bdpt", "pt-naive", "lt-naive"})
    for (const BinValue bin : sample_film(*scene, find_estimator(method), 2000, 1).total)
      EXPECT_EQ(bin.value, 0) << method;
}

// D(0) = 1/(2α), and at normal incidence value = ρ D / 2.
TYPED_TEST(Extremes, TheSharpestFacetsHaveTheDensityOfTheirRoughness) {
  using Real = typename TypeParam::Real;
  for (const double alpha : {1e-3, 1e-5, 1e-7}) {
    const RoughConductor<TypeParam> metal{static_cast<Real>(alpha), Real(0.5)};
    const auto up = TestFixture::at(0);
    const double peak = 0.5 / (4 * alpha);
    EXPECT_NEAR(double(metal.evaluate(Event::scattering, up, up).value) / peak, 1, 1e-6);
    // Half vectors at slope k α: D = (1 + k²)^(-3/2) / (2α), up to α².
    for (const double k : {0.5, 1.0, 3.0}) {
      const auto value =
          metal.evaluate(Event::scattering, up, TestFixture::at(2 * std::atan(k * alpha))).value;
      const double expected = peak / std::pow(1 + k * k, 1.5);
      EXPECT_NEAR(double(value) / expected, 1, 1e-6 + 4 * alpha * alpha * (1 + k * k)) << alpha;
    }
  }
}

// What rough metal scatters tends to what a mirror reflects.
TYPED_TEST(Extremes, ARoughnessThatVanishesKeepsTheEnergyOfAMirror) {
  using Real = typename TypeParam::Real;
  const auto energy_at = [](double alpha, double angle) {
    const RoughConductor<TypeParam> metal{static_cast<Real>(alpha), Real(0.75)};
    const auto known = TestFixture::at(angle);
    double sum = 0;
    constexpr int count = 200;
    for (int i = 0; i < count; ++i) {
      const auto s = metal.sample(known, {{static_cast<Real>((i + 0.5) / count)}, 0});
      if (!s) continue;
      const auto f = metal.evaluate(s->event, known, s->direction);
      sum += double(f.value) / double(f.toward_sensor) / count;
    }
    return sum;
  };
  for (const double angle : {0.0, 0.6, -1.2}) {
    EXPECT_NEAR(energy_at(2e-8, angle), 0.75, 1e-6);
    EXPECT_LT(energy_at(1, angle), 0.74);  // control
  }
  const auto built =
      build_material<TypeParam>(description::RoughConductor{9e-9, SceneMaker::grey(0.75)});
  EXPECT_EQ(double(std::get<Mirror<TypeParam>>(built).reflectance), 0.75);
}

// Indices that the precision cannot tell apart are one index, however rough the interface.
TYPED_TEST(Extremes, EqualIndicesLetEverythingPass) {
  const double apart = 1 + 0.2 * TestFixture::rounding;
  const auto built = build_material<TypeParam>(description::RoughDielectric{0.3, apart, 1});
  const auto glass = std::get<Dielectric<TypeParam>>(built);
  for (const double angle : {0.0, 1.0, 1.5, 2.5}) {
    const auto s = glass.sample(TestFixture::at(angle), {{}, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_EQ(s->event, Event::transmission);
    EXPECT_NEAR(double(glm::length(s->direction + TestFixture::at(angle))), 0, 1e-15);
  }
}

// At the critical angle and within rounding of it: all is reflected, or some is let through.
TYPED_TEST(Extremes, TheCriticalAngleIsNoCliff) {
  for (const double index : {1.0001, 1.5, 1e3}) {
    const Dielectric<TypeParam> glass{static_cast<typename TypeParam::Real>(index), 1};
    const double critical = std::sqrt(1 - 1 / (double(glass.interior) * double(glass.interior)));
    for (int ulps = -50; ulps <= 50; ++ulps) {
      const double cosine = critical * (1 + ulps * 0x1p-53);
      const typename TypeParam::Local inside{std::sqrt(1 - cosine * cosine), -cosine};
      const auto across = glass.follow(inside, Event::transmission);
      const auto s = glass.sample(inside, {{}, TestFixture::last});
      if (!s) continue;
      const auto f = glass.evaluate(s->event, inside, s->direction);
      EXPECT_TRUE(f.value >= 0 && f.value <= index) << cosine;
      EXPECT_TRUE(across ? (*across)[1] >= 0 : s->event == Event::reflection) << cosine;
    }
  }
}

// As much étendue in as out, n^(D-1) being that of the side that light arrives on.  The cosine
// across is 1 - η² sin², which keeps η² ε.
TYPED_TEST(Extremes, GlassOfExtremeIndexConservesEtendue) {
  using Real = typename TypeParam::Real;
  for (const double index : {1e3, 1e-3}) {
    const Dielectric<TypeParam> glass{static_cast<Real>(index), 1};
    for (const double angle : {0.0, 1e-4, 5e-4}) {
      const auto in = TestFixture::at(index > 1 ? angle : angle * index);
      const auto across = glass.follow(in, Event::transmission);
      ASSERT_TRUE(across);
      const auto enters = glass.evaluate(Event::transmission, in, *across);
      const auto leaves = glass.evaluate(Event::transmission, *across, in);
      const double tolerance = 1e6 * 0x1p-52 + 8 * TestFixture::rounding;
      EXPECT_NEAR(double(enters.value) / double(leaves.value) / index, 1, tolerance);
      EXPECT_NEAR(double(enters.toward_light) / double(leaves.toward_sensor), 1, tolerance);
    }
  }
}

// Every wall emits what it does not reflect, times the index around it: L = n everywhere.
TYPED_TEST(Extremes, AFurnaceWithGlassOfExtremeIndexIsAtEquilibrium) {
  for (const double index : {1e3, 1e-3}) {
    SceneMaker maker(40);
    const std::size_t wall = maker.diffuse(0.3);
    maker.segment({0, 0}, {2, 0}, {wall, 0.7 * index, 1});
    maker.segment({2, 0}, {2, 0.5}, {wall, 0.7 * index}).segment({2, 0.5}, {2, 1}, {wall, 0.7});
    maker.segment({2, 1}, {0, 1.2}, {wall, 0.7}).segment({0, 1.2}, {0, 0.5}, {wall, 0.7});
    maker.segment({0, 0.5}, {0, 0}, {wall, 0.7 * index});
    maker.segment({0, 0.5}, {2, 0.5}, {maker.glass(index)});
    const auto scene = build_flatland<TypeParam>(maker.description());
    const auto film = sample_film(*scene, find_estimator("pt"), 20'000, 3);
    EXPECT_TRUE(passes(matches(film.total, {2 * index}))) << "index " << index;
    EXPECT_TRUE(rejects(matches(film.total, {2.2 * index})));
    // Without connections every path finds the same light, but for what 40 vertices leave in glass.
    const auto naive = sample_film(*scene, find_estimator("pt-naive"), 1000, 3);
    EXPECT_NEAR(naive.mean.value / (2 * index), 1, 1e-10 + 1000 * TestFixture::rounding);
  }
}

// 400 vertices, far beyond what a product of densities in double holds: weights still sum to one.
TYPED_TEST(Extremes, PathsOfHundredsOfVerticesHaveDensitiesAndWeights) {
  constexpr int longest = 400;
  SceneMaker maker(longest);
  const std::size_t wall = maker.diffuse(0.999999);
  maker.segment({0, 0}, {50, 0}, {wall, 0, 1}).segment({50, 0}, {55, 30}, {wall});
  maker.segment({55, 30}, {0, 40}, {wall, 1}).segment({0, 40}, {0, 0}, {wall});
  const auto scene = build_flatland<TypeParam>(maker.description());
  const Transport<TypeParam> space(*scene, Roulette::off);
  Path<TypeParam> x(longest);
  x.resize(longest);
  Rng random(1, Purpose::test, 71);
  // A walk whose end lies on the light's own wall sees no light.
  Connection met = Connection::occluded;
  for (int tries = 0; met != Connection::open; ++tries) {
    ASSERT_LT(tries, 100);
    space.begin_sensor(x, longest - 1, random);
    for (int i = longest - 1; i > 1; --i) ASSERT_TRUE(space.extend(x, i, Toward::light, random));
    space.begin_light(x, 0, random);
    met = space.connect(x, 0);
  }
  for (int i = 0; i < longest; ++i) space.evaluate(x, i);
  weigh(space, x);
  EXPECT_TRUE(x.contribution.is_positive());
  EXPECT_EQ(x.contribution.value(), 0);  // it is less than the least double
  double sum = 0;
  for (const double w : x.weights()) sum += w;
  EXPECT_NEAR(sum, 1, 400 * TestFixture::rounding);
  const double weight = sides_of(space, x, 1, {all_techniques, Heuristic::balance}).mis_weight();
  EXPECT_NEAR(weight, x.weights()[1], 400 * TestFixture::rounding);
}

// Lights of 1e30 and 1e-30 side by side: the film is that of the bright one, and the weak one alone
// has a film of its own.
TYPED_TEST(Extremes, LightsOfSixtyOrdersOfMagnitudeShareAScene) {
  const auto room = [](double bright, double weak) {
    SceneMaker maker(4);
    const std::size_t wall = maker.diffuse(0.5);
    maker.segment({0, 0}, {1, 0}, {wall, 0, 3}).segment({1, 1}, {0.6, 1}, {wall, bright});
    maker.segment({0.4, 1}, {0, 1}, {wall, weak});
    return build_flatland<TypeParam>(maker.description());
  };
  const Estimator& bdpt = find_estimator("bdpt");
  const auto both = sample_film(*room(1e30, 1e-30), bdpt, 5000, 1);
  const auto bright = sample_film(*room(1, 1e-30), bdpt, 5000, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(both.total[i].value / 1e30 / bright.total[i].value, 1, 100 * TestFixture::rounding);
    EXPECT_NEAR(both.total[i].error / 1e30 / bright.total[i].error, 1, 1e-3);
  }
  for (const BinValue bin : sample_film(*room(1e-30, 0), bdpt, 5000, 1).total) {
    EXPECT_GT(bin.value, 1e-31);
    EXPECT_LT(bin.value, 1e-29);
  }
}

// A minus sign before zero is no other place.
TYPED_TEST(Extremes, MinusZeroIsZero) {
  const auto film = [](double zero) {
    SceneMaker maker(4);
    const std::size_t wall = maker.diffuse(0.5);
    maker.segment({zero, zero}, {1, zero}, {wall, 0, 3}).segment({1, 1}, {zero, 1}, {wall, 1});
    maker.circle({zero, 0.5}, 0.1, {wall}).arc({1, 0.5}, 0.1, zero, 120, {wall});
    const auto scene = build_flatland<TypeParam>(maker.description());
    return sample_film(*scene, find_estimator("bdpt"), 2000, 1);
  };
  const auto plus = film(0.0), minus = film(-0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(plus.total[i].value, minus.total[i].value);
    EXPECT_EQ(plus.total[i].error, minus.total[i].error);
  }
}

// ---- the ends of the unit interval

template <World W, class M>
void expect_sound_samples(const M& material, const char* name) {
  using Real = typename W::Real;
  const Real last = Extremes<W>::last;
  int sound = 0;
  for (const Real u : {Real(0), Real(0x1p-24), Real(0.5), last}) {
    for (const Real lobe : {Real(0), last}) {
      for (const double angle : {0.0, 1e-9, 0.7, -1.3, 1.5707963, 2.0, 3.1415926}) {
        const auto known = Extremes<W>::at(angle);
        const auto s = material.sample(known, {{u}, lobe});
        if (!s) continue;
        ASSERT_NEAR(double(glm::length(s->direction)), 1, 1e-6) << name;
        if (std::abs(s->direction[1]) < 1e-6) continue;  // along the surface: nothing is met
        const auto f = material.evaluate(s->event, known, s->direction);
        ASSERT_TRUE(std::isfinite(f.toward_sensor) && std::isfinite(f.value)) << name;
        // At u = 0 a facet may stand upright, and pass no light.
        ASSERT_TRUE(f.value > 0 ? f.toward_sensor > 0 : f.value == 0 && u == 0)
            << name << " u " << u << " angle " << angle;
        const auto inverted = material.invert(known, s->direction, s->event);
        ASSERT_TRUE(inverted.direction[0] >= 0 && inverted.direction[0] < 1) << name;
        ASSERT_TRUE(inverted.lobe_low >= 0 && inverted.lobe_high <= 1) << name;
        sound += f.value > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GE(sound, 10) << name;
}
TYPED_TEST(Extremes, EveryMaterialIsSampledSoundlyAtTheEndsOfTheUnitInterval) {
  using Real = typename TypeParam::Real;
  expect_sound_samples<TypeParam>(Diffuse<TypeParam>{Real(0.5)}, "diffuse");
  expect_sound_samples<TypeParam>(Mirror<TypeParam>{Real(0.5)}, "mirror");
  expect_sound_samples<TypeParam>(Dielectric<TypeParam>{Real(1.5), 1}, "glass");
  for (const double alpha : {1e-7, 1e-4, 0.1, 1.0}) {
    const auto roughness = static_cast<Real>(alpha);
    expect_sound_samples<TypeParam>(RoughConductor<TypeParam>{roughness, Real(0.5)}, "metal");
    expect_sound_samples<TypeParam>(RoughDielectric<TypeParam>{roughness, Real(1.5), 1},
                                    "rough glass");
  }
}

TYPED_TEST(Extremes, EndsOfPathsExistAtTheEndsOfTheUnitInterval) {
  for (const description::Scene& description : {full_room(4).description(), thin_lens_room()}) {
    const auto scene = build_flatland<TypeParam>(description);
    const Transport<TypeParam> space(*scene, Roulette::off);
    Path<TypeParam> x(4);
    x.resize(4);
    for (const auto u : {typename TypeParam::Real(0), TestFixture::last}) {
      space.begin_light(x, 0, PointNumbers<TypeParam>{0, {u}});
      EXPECT_TRUE(space.is_light(x[0]));
      EXPECT_NEAR(space.end_parameter(x, 0)[0], u, 4 * TestFixture::rounding);
      EXPECT_LT(space.end_parameter(x, 0)[0], 1);
      space.begin_sensor(x, 3, PointNumbers<TypeParam>{0, {u}});
      EXPECT_LT(space.end_parameter(x, 3)[0], 1);
      EXPECT_LT(scene->bin({u}), scene->bins());
    }
  }
}

}  // namespace
}  // namespace wander::test

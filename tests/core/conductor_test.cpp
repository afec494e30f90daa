// Conductors by their complex index of refraction: Fresnel's formulae, in each channel, on a smooth
// surface and on microfacets.
#include <gtest/gtest.h>

#include <complex>

#include "core/material.h"
#include "core/path_sampler.h"
#include "scenes/format/build_scene.h"
#include "tests/core/directions.h"
#include "tests/support/coloured_box.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

// |r|² of both polarisations by complex arithmetic [Born and Wolf, 14.2].
double by_amplitudes(double cosine, double eta, double k) {
  const std::complex<double> m(eta, k), square = m * m;
  const std::complex<double> across = std::sqrt(square - (1 - cosine) * (1 + cosine));
  const auto perpendicular = (cosine - across) / (cosine + across),
             parallel = (square * cosine - across) / (square * cosine + across);
  return (std::norm(perpendicular) + std::norm(parallel)) / 2;
}

TEST(ConductorFresnel, IsThatOfTheComplexAmplitudes) {
  Generator g(1);
  for (int i = 0; i < 100'000; ++i) {
    const double eta = std::pow(10, 3 * g.uniform() - 1.5), k = std::pow(10, 3 * g.uniform() - 1.5),
                 cosine = std::pow(10, -3 * g.uniform());
    const double exact = by_amplitudes(cosine, eta, k);
    ASSERT_NEAR(fresnel_conductor(cosine, eta, k), exact, 1e-11)
        << eta << " " << k << " " << cosine;
  }
}

TEST(ConductorFresnel, IsThatOfGlassWithoutExtinction) {
  for (const double eta : {0.3, 0.9, 1.1, 1.5, 3.0})
    for (const double cosine : {1.0, 0.9, 0.5, 0.1, 1e-3})
      EXPECT_NEAR(fresnel_conductor(cosine, eta, 0.0), fresnel(cosine, 1.0, eta), 1e-12)
          << eta << " " << cosine;
}

TEST(ConductorFresnel, HasTheKnownValues) {
  // Silver and copper at red, along the normal.
  EXPECT_NEAR(fresnel_conductor(1.0, 0.15528, 4.8284), 0.9748, 1e-5);
  EXPECT_NEAR(fresnel_conductor(1.0, 0.201, 3.9133),
              (0.799 * 0.799 + 3.9133 * 3.9133) / (1.201 * 1.201 + 3.9133 * 3.9133), 1e-15);
  EXPECT_EQ(fresnel_conductor(0.0, 0.2, 3.9), 1);  // grazing
  EXPECT_EQ(fresnel_conductor(1.0, 0.0, 2.0), 1);  // nothing enters
  EXPECT_EQ(fresnel_conductor(0.5, 0.0, 0.0), 1);
  for (const double cosine : {1.0, 0.7, 1e-3, 1e-9})
    EXPECT_EQ(fresnel_conductor(cosine, 1.0, 0.0), 0);
}

TEST(ConductorFresnel, IsAProbabilityAtTheExtremes) {
  Generator g(2);
  const auto number = [&] { return g.uniform() < 0.2 ? 0 : std::pow(10, 316 * g.uniform() - 310); };
  for (int i = 0; i < 100'000; ++i) {
    const double eta = std::min(number(), 1e6), k = std::min(number(), 1e6),
                 cosine = std::pow(10, -320 * g.uniform());
    const double f = fresnel_conductor(cosine, eta, k);
    ASSERT_GE(f, 0) << eta << " " << k << " " << cosine;
    ASSERT_LE(f, 1) << eta << " " << k << " " << cosine;
  }
}

using Colours = SpacelandColour;
constexpr std::array<double, 3> eta_of_copper{0.201, 0.92375, 1.1022},
    k_of_copper{3.9133, 2.4531, 2.1421};

TEST(Conductors, ReflectEachChannelByItsOwnIndex) {
  const Conductor<Colours> copper{{eta_of_copper, k_of_copper}};
  for (const double angle : {0.0, 0.7, 1.5}) {
    const auto light = local_at<3>(angle), sensor = local_at<3>(-angle);
    const auto s = copper.evaluate(Event::reflection, light, sensor);
    EXPECT_EQ(s.toward_light, 1);
    EXPECT_EQ(s.toward_sensor, 1);
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_NEAR(s.value * s.tint[i],
                  by_amplitudes(std::cos(angle), eta_of_copper[k], k_of_copper[k]), 1e-12);
    }
    EXPECT_NEAR(luminance(s.tint), 1, 1e-14);
  }
  EXPECT_EQ(copper.evaluate(Event::reflection, local_at<3>(0.1), local_at<3>(3)).value, 0);
  EXPECT_NEAR(copper.survival(), by_amplitudes(1, eta_of_copper[0], k_of_copper[0]), 1e-14);
}

// At grazing angles a dark conductor reflects all light: what survives there is not to weigh much more than what
// does not elsewhere.
TEST(Conductors, AreNotSurvivedByFewWhoWeighMuch) {
  for (const double eta : {1.0001, 1.03, 1.5, 4.}) {
    const Conductor<Spaceland> smooth{{{eta}, {0}}};
    const RoughMetal<Spaceland> rough{0.2, {{eta}, {0}}};
    EXPECT_EQ(smooth.survival(), rough.survival());
    for (int degrees = 0; degrees < 90; ++degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      const double reflected = by_amplitudes(std::cos(angle), eta, 0);
      EXPECT_LE(reflected, 2 * smooth.survival() * (1 + 1e-12)) << eta << ", " << degrees;
    }
    EXPECT_GE(smooth.survival(), by_amplitudes(1, eta, 0) * (1 - 1e-12));
  }
}

// The angle that counts is that to the facet, not to the surface.
TEST(Conductors, OfMicrofacetsReflectByTheHalfVector) {
  Generator g(3);
  const RoughMetal<Colours> copper{0.4, {eta_of_copper, k_of_copper}};
  const RoughConductor<Colours> white{0.4, 1};
  int told_apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto light = random_direction<3>(g);
    const auto sample = copper.sample(light, {random_square<3>(g), 0});
    if (!sample) continue;
    const auto sensor = sample->direction;
    const auto s = copper.evaluate(Event::scattering, light, sensor),
               of_white = white.evaluate(Event::scattering, light, sensor);
    EXPECT_EQ(s.toward_light, of_white.toward_light);
    EXPECT_EQ(s.toward_sensor, of_white.toward_sensor);
    const double cosine = std::abs(glm::dot(light, glm::normalize(light + sensor)));
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const double f = by_amplitudes(cosine, eta_of_copper[k], k_of_copper[k]);
      ASSERT_NEAR(s.value * s.tint[c], f * of_white.value, 1e-9 * of_white.value);
      const double wrong = by_amplitudes(std::abs(light.z), eta_of_copper[k], k_of_copper[k]);
      if (std::abs(wrong - f) > 1e-3) ++told_apart;
    }
  }
  EXPECT_GT(told_apart, 500);
}

TEST(Conductors, AreBuiltOfWhatScenesSay) {
  const description::Quantity eta{eta_of_copper, true}, k{k_of_copper, true}, one{{1, 1, 1}, false},
      none{};
  const auto built = build_material<Colours>(description::Conductor{eta, k});
  EXPECT_NEAR(std::get<Conductor<Colours>>(built).survival(),
              (Conductor<Colours>{{eta_of_copper, k_of_copper}}.survival()), 1e-15);
  EXPECT_EQ(
      std::get<RoughMetal<Colours>>(build_material<Colours>(description::RoughMetal{0.3, eta, k}))
          .roughness,
      0.3);
  EXPECT_TRUE(std::holds_alternative<Conductor<Colours>>(
      build_material<Colours>(description::RoughMetal{1e-9, eta, k})));
  // What has the index of the air around it reflects nothing.
  EXPECT_TRUE(std::holds_alternative<Black<Flatland>>(
      build_material<Flatland>(description::Conductor{one, none})));
  EXPECT_TRUE(std::holds_alternative<Black<Flatland>>(
      build_material<Flatland>(description::RoughMetal{0.2, one, none})));
}

// A box with metals smooth and rough: a path's light is that of each channel's own scene, to rounding.
TEST(Conductors, InColourAreThoseOfEachChannel) {
  description::Scene box = coloured_box();
  const description::Quantity eta{eta_of_copper, true}, k{k_of_copper, true};
  for (auto& material : box.materials) {
    if (material.name == "gold") material.kind = description::RoughMetal{0.4, eta, k};
    if (material.name == "tinted") material.kind = description::Conductor{eta, k};
  }
  const auto light_of = [](const auto& scene) {
    using World = typename std::decay_t<decltype(*scene)>::Universe;
    const Transport<World> space(*scene, Roulette::off);
    PathSampler<Transport<World>> sampler(space, all_techniques, Heuristic::balance);
    Rng rng(1, Purpose::estimate, 0);
    std::vector<std::array<double, 3>> all;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      rng.start(i);
      sampler.sample(rng, [&](const Path<World>& x, int, double value) {
        const auto tint = colour(x);
        all.push_back({value * tint[0], value * tint[1], value * tint[2]});
      });
    }
    return all;
  };
  const auto coloured = light_of(build_scene<SpacelandColour>(box));
  ASSERT_GT(coloured.size(), 1000U);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto one = light_of(build_scene<Spaceland>(channel_of(box, channel)));
    ASSERT_EQ(one.size(), coloured.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      ASSERT_NEAR(coloured[i][channel], one[i][0], 1e-12 * one[i][0]);
  }
}

}  // namespace
}  // namespace wander::test

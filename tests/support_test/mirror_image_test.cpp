// Mirror and refraction in closed form: the reference values, the identities of Fresnel's formulas,
// and the wrong answers that must differ.
#include "tests/support/mirror_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/support/quadrature.h"
#include "tests/support/reference_values.h"

namespace wander::test {
namespace {

constexpr MirrorScene mirror_scene() {
  using namespace reference::mirror;
  return {reflector, reflectance, emitter, radiance};
}

constexpr RefractionScene refraction_scene() {
  using namespace reference::refraction;
  return {interface, index_above, index_below, emitter, radiance};
}

TEST(MirrorImage, TheMirrorSceneIsReproduced) {
  using namespace reference::mirror;
  const std::vector<double> found = mirror_film(mirror_scene(), sensor, film.size());
  for (std::size_t b = 0; b < film.size(); ++b) EXPECT_NEAR(found[7 - b], film[b], tolerance) << b;
}

TEST(MirrorImage, ANarrowerMirrorAPerfectOneAndATurnedEmitterAreToldApart) {
  using namespace reference::mirror;
  MirrorScene narrow = mirror_scene(), perfect = mirror_scene(), turned = mirror_scene();
  narrow.mirror = {{-0.25, -1}, {0.25, -1}};
  perfect.reflectance = 1;
  turned.emitter = {emitter.to, emitter.from};
  EXPECT_LT(mirror_film(narrow, sensor, 8)[3], film[4] - 1e-3);
  EXPECT_GT(std::abs(mirror_film(perfect, sensor, 8)[7] - film[0]), 1e-3);
  EXPECT_EQ(mirror_film(turned, sensor, 8)[7], 0);
}

TEST(MirrorImage, ATurnedWorldReadsTheSame) {
  const auto turn = [](PlanePoint p) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    return PlanePoint{c * p.x - s * p.y, s * p.x + c * p.y};
  };
  const auto turned = [&](const PlaneSegment& s) { return PlaneSegment{turn(s.from), turn(s.to)}; };
  using namespace reference::mirror;
  const MirrorScene scene{turned(reflector), reflectance, turned(emitter), radiance};
  const std::vector<double> found = mirror_film(scene, turned(sensor), film.size());
  for (std::size_t b = 0; b < film.size(); ++b) EXPECT_NEAR(found[7 - b], film[b], 1e-11) << b;
}

TEST(MirrorImage, TheRefractionSceneIsReproducedAndNeedsTheIndexFactor) {
  using namespace reference::refraction;
  const auto found = refraction_film(refraction_scene(), sensor.from.y, {0, 0.5, 1, 1.5, 2});
  for (std::size_t b = 0; b < film.size(); ++b) {
    EXPECT_NEAR(found[b], film[b], tolerance);
    EXPECT_NEAR(found[b] / index_below, without_index_factor[b], 1e-6);
    EXPECT_GT(found[b] - without_index_factor[b], 0.1);
  }
}

TEST(MirrorImage, AnInterfaceOfIndexOneIsNotThere) {
  RefractionScene scene = refraction_scene();
  scene.index_below = 1;
  // Unobstructed, from y = -1: the closed form Le (sin θ2 - sin θ1).
  const auto sine = [](double across) { return across / std::hypot(across, 2.0); };
  EXPECT_NEAR(refraction_point_irradiance(scene, {0.3, -1}), sine(0.7) - sine(-1.3), 1e-13);
}

TEST(MirrorImage, FresnelObeysItsIdentities) {
  EXPECT_NEAR(fresnel_reflectance(1, 1.5), 0.04, 1e-15);
  EXPECT_EQ(fresnel_reflectance(0.1, 1 / 1.5), 1);  // total reflection
  for (const double cosine : {0.05, 0.3, 0.8, 1.0}) {
    const double refracted = std::sqrt(1 - (1 - cosine * cosine) / 2.25);
    EXPECT_NEAR(fresnel_reflectance(cosine, 1.5), fresnel_reflectance(refracted, 1 / 1.5), 1e-14);
  }
  // Cosine averages ½ ∫ F cos θ dθ in the plane, and (1 - F_in) η = 1 - F_out.
  const auto mean = [](double index) {
    return integral(
        [&](double sine) { return fresnel_reflectance(std::sqrt(1 - sine * sine), index); }, 0, 1);
  };
  EXPECT_NEAR(mean(1.5), 0.06797652684085177, 1e-10);
  EXPECT_NEAR(mean(1 / 1.5), 0.378651017893901, 1e-10);
  EXPECT_NEAR((1 - mean(1 / 1.5)) * 1.5, 1 - mean(1.5), 1e-10);
}

TEST(MirrorImage, AnInterfaceThatIsNotHorizontalIsRefused) {
  RefractionScene scene = refraction_scene();
  scene.interface.to.y = 0.5;
  EXPECT_THROW(refraction_point_irradiance(scene, {0, -1}), std::invalid_argument);
}

}  // namespace
}  // namespace wander::test

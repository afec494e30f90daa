// Films that may not change by a bit: and ones that do, where what was done to the scene is no symmetry.
#include "lab/symmetries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/scene_source.h"
#include "mlt/seeds/nothing_found.h"

namespace wander {
namespace {

description::Scene scene_named(const std::string& name) {
  description::Scene scene = open_scene("gallery:" + name).scene;
  if (scene.camera && scene.dimension == 3) scene.camera->resolution = {12, 9};
  return scene;
}

std::vector<SymmetryCheck> checks_of(const description::Scene& scene,
                                     const std::vector<Variation>& variations) {
  Session session;
  session.budget = SampleBudget{1000};
  return check_symmetries(Job(scene, reference_method()), variations, session, [] {});
}

class Symmetries : public testing::TestWithParam<const char*> {};

void expect_symmetries(const description::Scene& scene) {
  std::size_t same = 0;
  for (const SymmetryCheck& check : checks_of(scene, variations_of(scene))) {
    EXPECT_NE(check.verdict, SymmetryVerdict::differs)
        << check.method << " in " << name_of(check.precision) << ", " << check.variation << ": "
        << check.difference;
    // What is beyond single precision is said to be.
    if (check.precision == Precision::of_double) {
      EXPECT_EQ(check.verdict, SymmetryVerdict::same) << check.reason;
    }
    if (check.verdict == SymmetryVerdict::same) ++same;
  }
  EXPECT_GE(same, 8 * (checked_methods().size() + 1));
}

TEST_P(Symmetries, NoBitOfAnyFilmChanges) { expect_symmetries(scene_named(GetParam())); }

TEST(SymmetriesOfALens, ItsFocusAndItsApertureAreLengths) {
  description::Scene scene = scene_named("ring");  // of metal, meshes
  scene.camera->aperture_radius = 0.02;
  scene.camera->focus_distance = 0.7;
  expect_symmetries(scene);
}

// Segments, arcs, circles and a camera; space with colour, triangles, spheres, a mirror and glass.
INSTANTIATE_TEST_SUITE_P(Gallery, Symmetries,
                         testing::Values("slit", "lens", "glass-caustic-camera", "cornell-glass"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(SymmetriesTwin, WhatIsNoSymmetryIsSeen) {
  const description::Scene scene = scene_named("lens");
  description::Scene larger = scene;
  for (description::Shape& shape : larger.shapes)
    if (auto* arc = std::get_if<description::Arc>(&shape.kind)) arc->radius *= 1 + 1e-9;
  description::Scene brighter = scene;
  for (description::Shape& shape : brighter.shapes)
    if (shape.light) shape.light->radiance.channels[0] *= std::nextafter(1.0, 2.0);
  for (const Variation& twin :
       {Variation{"larger lenses", 1, larger}, Variation{"a little brighter", 1, brighter},
        Variation{"the factor forgotten", 2, scene}}) {
    const auto checks = checks_of(scene, {twin});
    EXPECT_TRUE(std::ranges::any_of(checks, [](const SymmetryCheck& check) {
      return check.verdict == SymmetryVerdict::differs && check.difference > 0;
    })) << twin.name;
  }
}

TEST(SymmetriesTwin, AFilmWithoutLightIsNoRefusal) {
  const description::Scene scene = scene_named("parallel");
  description::Scene dark = scene;
  for (description::Shape& shape : dark.shapes)
    if (auto* segment = std::get_if<description::Segment>(&shape.kind); shape.light)
      std::swap(segment->from, segment->to);
  for (const SymmetryCheck& check : checks_of(scene, {{"the lamp turned round", 1, dark}})) {
    EXPECT_EQ(check.verdict, SymmetryVerdict::differs) << check.method;
    EXPECT_EQ(check.difference, 1) << check.method;
  }
}

TEST(Variations, LeaveOutWhatASceneFileMayNotSay) {
  const auto names = [](const description::Scene& scene) {
    std::vector<std::string> all;
    for (const Variation& variation : variations_of(scene)) all.push_back(variation.name);
    return all;
  };
  description::Scene scene = scene_named("parallel");
  EXPECT_EQ(names(scene).size(), 10u);
  for (description::Shape& shape : scene.shapes)
    if (shape.light) shape.light->radiance.channels[0] = description::largest_radiance;
  const auto bright = names(scene);
  EXPECT_EQ(std::ranges::count(bright, "radiances x 2^30"), 0);
  EXPECT_EQ(std::ranges::count(bright, "radiances x 2^-90"), 1);
  for (description::Shape& shape : scene.shapes)
    if (auto* segment = std::get_if<description::Segment>(&shape.kind)) segment->to[0] = 1e40;
  const auto large = names(scene);
  EXPECT_EQ(std::ranges::count(large, "lengths x 2^100"), 0);
  EXPECT_EQ(std::ranges::count(large, "lengths x 2^30"), 1);
}

}  // namespace
}  // namespace wander

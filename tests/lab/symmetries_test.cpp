// Films that may not change by a bit: and ones that do, where what was done to the scene is no symmetry.
#include <algorithm>
#include <cmath>

#include "mlt/seeds/nothing_found.h"
#include "tests/core/geometry/meshes.h"
#include "tests/lab/expected_symmetries.h"

namespace wander::test {
namespace {

class Symmetries : public testing::TestWithParam<const char*> {};

TEST_P(Symmetries, NoBitOfAnyFilmChanges) {
  const description::Scene scene = scene_named(GetParam());
  expect_symmetries(scene, variations_of(scene));
}

// Normals along the axis of the turn, of a parallelogram, a triangle and a mesh; normals of corners.
description::Scene ball_on_a_box() {
  using description::Coordinates;
  description::Scene scene;
  scene.dimension = 3;
  scene.max_vertices = 6;
  scene.materials = {{"grey", description::Diffuse{{{0.7, 0.7, 0.7}}}},
                     {"metal", description::RoughConductor{0.3, {{0.9, 0.9, 0.9}}}}};
  const auto add = [&](description::ShapeKind kind, std::size_t material) {
    auto& shape = scene.shapes.emplace_back();
    shape.kind = std::move(kind);
    shape.material = material;
  };
  const auto mesh = [](Triangles triangles) {
    description::Mesh made;
    made.normals = triangles.normals.empty() ? description::MeshNormals::flat
                                             : description::MeshNormals::smooth;
    made.triangles = std::make_shared<const Triangles>(std::move(triangles));
    return made;
  };
  Generator g(7);
  Triangles ball = ball_mesh(g, 6, 0, {0, 0, 0.9}, 0.4);
  for (const Coordinates& p : ball.points)
    ball.normals.push_back({p[0] / 0.4, p[1] / 0.4, (p[2] - 0.9) / 0.4});
  add(description::Parallelogram{{-2, -2, 0}, {{{4, 0, 0}, {0, 4, 0}}}}, 1);
  add(mesh(std::move(ball)), 1);
  add(mesh(box_mesh({-0.6, -0.7, 0.1}, {0.8, 0.5, 0.45})), 0);
  add(description::Triangle{{{{-1, -1, 2}, {0, 1, 2}, {1, -1, 2}}}}, 0);
  scene.shapes.back().light = description::Light{{{1, 1, 1}}};
  scene.camera.emplace();
  scene.camera->position = {0.3, -3, 1.7};
  scene.camera->target = {0, 0, 0.5};
  scene.camera->up = {0, 0.1, 1};
  scene.camera->fov_degrees = 50;
  scene.camera->resolution = {12, 9};
  return scene;
}

TEST(SymmetriesOfSpace, FramesTurnWithTheWorld) {
  const description::Scene scene = ball_on_a_box();
  std::vector<Variation> all = variations_of(scene);
  std::erase_if(all, [](const Variation& one) { return !one.name.starts_with("turned"); });
  ASSERT_EQ(all.size(), 1u);
  expect_symmetries(scene, all);
}

TEST(SymmetriesOfALens, ItsFocusAndItsApertureAreLengths) {
  const description::Scene scene = ring_behind_a_lens();
  std::vector<Variation> lengths = variations_of(scene);
  std::erase_if(lengths, [](const Variation& one) { return !one.name.starts_with("lengths"); });
  ASSERT_GE(lengths.size(), 3u);
  lengths.resize(1);  // the others: symmetries_long_test.cpp
  expect_symmetries(scene, lengths);
}

// Arcs, and a camera in space before spheres and glass; segments: Extremes.AreCheckedForEveryMethodInBothPrecisions.  With colour: symmetries_long_test.cpp.
INSTANTIATE_TEST_SUITE_P(Gallery, Symmetries, testing::Values("lens", "glass-caustic-camera"),
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
  EXPECT_EQ(std::ranges::count(bright, "radiances x 2^-100"), 1);
  for (description::Shape& shape : scene.shapes)
    if (auto* segment = std::get_if<description::Segment>(&shape.kind)) segment->to[0] = 1e40;
  const auto large = names(scene);
  EXPECT_EQ(std::ranges::count(large, "lengths x 2^100"), 0);
  EXPECT_EQ(std::ranges::count(large, "lengths x 2^30"), 1);
}

}  // namespace
}  // namespace wander::test

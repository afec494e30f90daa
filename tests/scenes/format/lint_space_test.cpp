// Doubts about scenes of three dimensions: each is told, and a scene without them is not doubted.
#include <gtest/gtest.h>

#include "scenes/format/lint.h"
#include "tests/core/geometry/meshes.h"
#include "tests/scenes/format/space_texts.h"

namespace wander {
namespace {

std::vector<Fault> doubts(const std::string& shape) { return parse(with_solid(shape)).warnings; }

TEST(LintOfSpace, DoubtsNothingOfASoundScene) {
  EXPECT_EQ(doubts(R"({ "type": "parallelogram", "origin": [0, 0, 0],
    "edges": [[1, 0, 0], [0, 1, 0]] })")
                .size(),
            0u);
  EXPECT_EQ(doubts(R"({ "type": "parallelogram", "origin": [0, -1e-6, 0],
    "edges": [[1, 0, 0], [0, 0, -1]] })")
                .size(),
            0u);
}

// Of a scene with this shape.
std::vector<Fault> faults(const std::string& shape) {
  try {
    parse(with_solid(shape));
  } catch (const SceneFileError& error) {
    return error.faults;
  }
  return {};
}

TEST(LintOfSpace, RefusesLightsAndSensorsThatLieOnOtherShapes) {
  for (const char* shape : {R"({ "type": "parallelogram", "origin": [-1, 0, 1],
                                 "edges": [[3, 0, 0], [0, 0, -3]] })",
                            R"({ "type": "triangle",
                                 "points": [[0.2, 0, -0.2], [0.4, 0, -0.2], [0.2, 0, -0.4]] })"}) {
    const std::vector<Fault> found = faults(shape);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].pointer, "/shapes/1");
    EXPECT_NE(found[0].what.find("the sensor lies on /shapes/2 at no distance"), std::string::npos);
  }
}

TEST(LintOfSpace, RefusesALightThatIsThereTwice) {
  const std::string ball = R"({ "type": "sphere", "center": [0, 3, 0], "radius": 1 })";
  const std::string lamp = R"({ "type": "sphere", "center": [0, 3, 0], "radius": 1,
                                "light": { "radiance": 1 } })";
  EXPECT_EQ(faults(ball).size(), 0u);
  const std::vector<Fault> found = faults(ball + ", " + lamp);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pointer, "/shapes/3");
  EXPECT_NE(found[0].what.find("the light lies on /shapes/2"), std::string::npos);
  // Two lights in one place are said once.
  EXPECT_EQ(faults(lamp + ", " + lamp).size(), 1u);
}

// Most stand on a floor, where light meets neither.
TEST(LintOfSpace, DoubtsOtherSheetsThatLieOnEachOther) {
  const std::string sheet = R"({ "type": "parallelogram", "origin": [5, 1, 5],
                                 "edges": [[1, 0, 0], [0, 0, 1]] })";
  const std::string corner = R"({ "type": "triangle",
                                  "points": [[5.5, 1, 5.5], [7, 1, 5.5], [5.5, 1, 7]] })";
  const std::vector<Fault> found = doubts(sheet + ", " + corner);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pointer, "/shapes/3");
  EXPECT_NE(found[0].what.find("this shape lies on /shapes/2"), std::string::npos);
  const std::string beside = R"({ "type": "triangle",
                                  "points": [[6, 1, 5], [7, 1, 5], [6, 1, 6]] })";
  EXPECT_EQ(doubts(sheet + ", " + beside).size(), 0u);
}

TEST(LintOfSpace, DoubtsFeaturesAndPlacesThatCostDigits) {
  const std::vector<Fault> small =
      doubts(R"({ "type": "sphere", "center": [0, 1, 0], "radius": 1e-13 })");
  ASSERT_EQ(small.size(), 1u);
  EXPECT_EQ(small[0].pointer, "/shapes/2");
  EXPECT_NE(small[0].what.find("times smaller than the scene"), std::string::npos);
  const std::vector<Fault> remote = parse(space_only(R"([
      { "type": "sphere", "center": [1e8, 0, 0], "radius": 1, "light": { "radiance": 1 } },
      { "type": "triangle", "points": [[1e8, 0, 3], [1e8, 3, 3], [100000001, 0, 3]],
        "sensor": { "resolution": [1, 1] } }])"))
                                        .warnings;
  ASSERT_EQ(remote.size(), 1u);
  EXPECT_NE(remote[0].what.find("diameters from the origin"), std::string::npos);
}

TEST(LintOfSpace, CountsTrianglesWithoutArea) {
  description::Scene scene = parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene;
  auto triangles = std::make_shared<Triangles>();
  triangles->points = {{0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  triangles->corners = {{0, 1, 2}, {0, 1, 1}, {0, 0, 0}};
  scene.shapes.emplace_back().kind = description::Mesh{"m.obj", triangles};
  const std::vector<Fault> found = lint(scene).warnings;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].what.find("2 of the triangles of this mesh have no area"), std::string::npos);
}

// Nothing could be sampled on it.
TEST(LintOfSpace, RefusesLightsWithoutArea) {
  description::Scene scene = parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene;
  auto triangles = std::make_shared<Triangles>();
  triangles->points = {{0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  triangles->corners = {{0, 1, 2}};
  description::Shape& flat = scene.shapes.emplace_back();
  flat.kind = description::Mesh{"m.obj", triangles};
  EXPECT_TRUE(lint(scene).faults.empty());
  flat.light = scene.shapes.front().light;
  ASSERT_TRUE(flat.light);
  const std::vector<Fault> faults = lint(scene).faults;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].what.find("this light has no area"), std::string::npos);
}

TEST(LintOfSpace, LooksAtEveryFaceOfAMeshBesideALightOrSensor) {
  description::Scene scene = parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene;
  auto triangles = std::make_shared<Triangles>();
  triangles->points = {{0.2, 0, -0.2}, {0.4, 0, -0.2}, {0.2, 0, -0.4}, {0.2, 9, 0.2}, {0.4, 9, 0}};
  triangles->corners = {{0, 3, 4}, {0, 1, 2}};
  scene.shapes.emplace_back().kind = description::Mesh{"m.obj", triangles};
  const std::vector<Fault> found = lint(scene).faults;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].what.find("the sensor lies on /shapes/2"), std::string::npos);
  triangles->corners = {{0, 3, 4}};
  EXPECT_TRUE(lint(scene).faults.empty());
}

// ---- meshes that are neither

using test::ball_mesh;
using test::box_mesh;
using test::Generator;

class LintOfMeshes : public testing::Test {
 protected:
  void add(Triangles triangles, std::optional<std::size_t> material = {}) {
    auto& shape = scene_.shapes.emplace_back();
    shape.kind =
        description::Mesh{"m.obj", std::make_shared<const Triangles>(std::move(triangles))};
    shape.material = material;
  }
  std::vector<Fault> doubts() const { return lint(scene_).warnings; }

  description::Scene scene_ = parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene;
};

// Two boxes whose tops are one, below the lamp.
TEST_F(LintOfMeshes, FacesThatLightMayReachAreDoubted) {
  add(box_mesh({5, 1, 5}, {6, 2, 6}));
  add(box_mesh({8, 1, 5}, {9, 2, 6}));
  EXPECT_TRUE(doubts().empty());
  add(box_mesh({5.25, 1.5, 5.25}, {5.75, 2, 5.75}));
  const std::vector<Fault> found = doubts();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pointer, "/shapes/4");
  EXPECT_NE(found[0].what.find("this shape lies on /shapes/2"), std::string::npos);
}

Triangles turned_inside_out(Triangles mesh) {
  for (auto& corners : mesh.corners) std::swap(corners[0], corners[1]);
  return mesh;
}

// Which way its faces look says nothing: opaque surfaces reflect on both sides.
TEST_F(LintOfMeshes, ABoxOnAFloorIsNotUnlessItIsOfGlass) {
  scene_.materials = {{"glass", description::Dielectric{}}};
  for (const bool is_inside_out : {false, true}) {
    scene_.shapes.resize(2);
    const auto box = [&](Spaceland::Point low, Spaceland::Point high) {
      const Triangles mesh = box_mesh(low, high);
      return is_inside_out ? turned_inside_out(mesh) : mesh;
    };
    add(box({0, 1, 5}, {9, 2, 9}));
    add(box({5, 2, 5.5}, {6, 3, 6}));
    EXPECT_TRUE(doubts().empty()) << is_inside_out;
    scene_.shapes.back().material = 0;
    EXPECT_EQ(doubts().size(), 1u) << is_inside_out;
  }
}

// The floor of a room, of which nothing is below; of a table, its underside is seen.
TEST_F(LintOfMeshes, ABoxInARoomIsNotAndOneOnATableTopIs) {
  add(box_mesh({-9, -1, -9}, {9, 9, 9}));
  add(box_mesh({5, -1, 5.5}, {6, 3, 6}));
  EXPECT_TRUE(doubts().empty());
  scene_.shapes.resize(2);
  scene_.shapes.emplace_back().kind =
      description::Parallelogram{{4, 2, 4}, {{{3, 0, 0}, {0, 0, 3}}}};
  add(box_mesh({5, 2, 5.5}, {6, 3, 6}));
  EXPECT_EQ(doubts().size(), 1u);
}

TEST_F(LintOfMeshes, WhatIsTwiceInAMeshIsSaidOnce) {
  for (const bool is_turned : {false, true}) {
    scene_.shapes.resize(2);
    Triangles twice = box_mesh({5, 1, 5}, {6, 2, 6});
    for (std::size_t k = 0; k < 5; ++k) {
      auto corners = twice.corners[k];
      if (is_turned) std::swap(corners[1], corners[2]);
      twice.corners.push_back(corners);
    }
    add(std::move(twice));
    const std::vector<Fault> found = doubts();
    ASSERT_EQ(found.size(), 1u) << is_turned;
    EXPECT_EQ(found[0].what.find("triangles of this mesh lie on each other"), 0u);
  }
}

// The corners of a square, and a point within it near the first.
Triangles of_square(std::vector<std::array<std::int32_t, 3>> corners) {
  return {.points = {{5, 2, 5}, {6, 2, 5}, {6, 2, 6}, {5, 2, 6}, {5.3, 2, 5.3}},
          .corners = std::move(corners)};
}
// Faces 1 2 3 4 and 4 3 2 1 of a file, which are split from their first corners; and a dart, 4 1 2 5, of whose corners the
// first does not see all.  But not the two halves of a face.
TEST_F(LintOfMeshes, TheBackOfASheetAndAFoldedFaceAreThereTwice) {
  add(of_square({{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(doubts().empty());
  for (const auto& mesh : {of_square({{0, 1, 2}, {0, 2, 3}, {3, 2, 1}, {3, 1, 0}}),
                           of_square({{3, 0, 1}, {3, 1, 4}})}) {
    scene_.shapes.resize(2);
    add(mesh);
    const std::vector<Fault> found = doubts();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].what.find("triangles of this mesh lie on each other"), 0u);
  }
}

// Beside however large a mesh.
TEST_F(LintOfMeshes, ShapesOfOneFaceAreComparedWithEachOtherFirst) {
  Generator g(1);
  for (int k = 0; k < 2; ++k)
    scene_.shapes.emplace_back().kind =
        description::Parallelogram{{4, 2, 4}, {{{3, 0, 0}, {0, 0, 3}}}};
  add(ball_mesh(g, 120, 0, {6, 6, 6}, 1));
  EXPECT_EQ(doubts().size(), 1u);
}

TEST_F(LintOfMeshes, ATriangleWithoutAreaLiesOnNoLight) {
  Triangles mesh = box_mesh({5, 1, 5}, {6, 2, 6});
  const auto n = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{0.1, 0, -0.1}, {0.2, 0, -0.1}, {0.3, 0, -0.1}});
  mesh.corners.push_back({n, n + 1, n + 2});
  add(std::move(mesh));
  EXPECT_TRUE(lint(scene_).faults.empty());
}

TEST_F(LintOfMeshes, BallsAreComparedToo) {
  for (const double radius : {1.0, 1.5, 1.0}) {
    description::Sphere ball;
    ball.center = {6, 3, 6};
    ball.radius = radius;
    scene_.shapes.emplace_back().kind = ball;
  }
  const std::vector<Fault> found = doubts();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pointer, "/shapes/4");
}

// ---- cameras

std::string fault_of_camera(const std::string& shape, const std::string& position) {
  const std::string text = R"({ "format": "wanderlight-scene/1", "dimension": 3, "materials": {},
    "shapes": [ { "type": "sphere", "center": [0, 8, 0], "radius": 1, "light": { "radiance": 1 } },
      )" + shape + R"( ],
    "camera": { "type": "perspective", "position": )" +
                           position +
                           R"(, "target": [0.1, 5, 0.2], "fov_deg": 40, "resolution": [2, 2] } })";
  try {
    parse(text);
  } catch (const SceneFileError& error) {
    return error.what();
  }
  return {};
}

TEST(LintOfCameras, OneThatLiesOnASurfaceIsRefused) {
  const std::string sheet =
      R"({ "type": "parallelogram", "origin": [0, 0, 0], "edges": [[0, 0, 3], [3, 0, 0]] })";
  const std::string triangle =
      R"({ "type": "triangle", "points": [[0, 0, 0], [0, 0, 3], [3, 0, 0]] })";
  const std::string ball = R"({ "type": "sphere", "center": [0, 0, 0], "radius": 0.7 })";
  for (const auto& [shape, position] :
       std::initializer_list<std::pair<std::string, std::string>>{{sheet, "[1, 0, 2]"},
                                                                  {sheet, "[0, 0, 0]"},
                                                                  {sheet, "[3, 0, 1.5]"},
                                                                  {triangle, "[1, 0, 1]"},
                                                                  {triangle, "[1.5, 0, 1.5]"},
                                                                  {ball, "[0, 0.7, 0]"}}) {
    const std::string what = fault_of_camera(shape, position);
    EXPECT_NE(what.find(":4:15: /camera: the camera lies on /shapes/1 at no distance"),
              std::string::npos)
        << shape << position << what;
  }
  for (const auto& [shape, position] :
       std::initializer_list<std::pair<std::string, std::string>>{{sheet, "[1, 1e-9, 2]"},
                                                                  {sheet, "[3.001, 0, 1]"},
                                                                  {triangle, "[1.6, 0, 1.5]"},
                                                                  {ball, "[0, 0.701, 0]"},
                                                                  {ball, "[0, 0.3, 0]"}})
    EXPECT_EQ(fault_of_camera(shape, position), "") << shape << position;
}

}  // namespace
}  // namespace wander

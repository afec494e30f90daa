// Doubts about scenes of three dimensions: each is told, and a scene without them is not doubted.
#include <gtest/gtest.h>

#include "scenes/format/lint.h"
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

TEST(LintOfSpace, DoubtsLightsAndSensorsThatLieOnOtherShapes) {
  for (const char* shape : {R"({ "type": "parallelogram", "origin": [-1, 0, 1],
                                 "edges": [[3, 0, 0], [0, 0, -3]] })",
                            R"({ "type": "triangle",
                                 "points": [[0.2, 0, -0.2], [0.4, 0, -0.2], [0.2, 0, -0.4]] })"}) {
    const std::vector<Fault> found = doubts(shape);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].pointer, "/shapes/1");
    EXPECT_NE(found[0].what.find("the sensor lies on /shapes/2"), std::string::npos);
  }
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
  const std::vector<Fault> found = lint(scene);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].what.find("2 of the triangles of this mesh have no area"), std::string::npos);
}

// Of a mesh of more faces, each may lie where it will.
TEST(LintOfSpace, LooksAtAMeshOfOneTriangleAsAtATriangle) {
  description::Scene scene = parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene;
  auto triangles = std::make_shared<Triangles>();
  triangles->points = {{0.2, 0, -0.2}, {0.4, 0, -0.2}, {0.2, 0, -0.4}};
  triangles->corners = {{0, 1, 2}};
  scene.shapes.emplace_back().kind = description::Mesh{"m.obj", triangles};
  const std::vector<Fault> found = lint(scene);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].what.find("the sensor lies on /shapes/2"), std::string::npos);
  triangles->corners.push_back({0, 2, 1});
  EXPECT_TRUE(lint(scene).empty());
}

}  // namespace
}  // namespace wander

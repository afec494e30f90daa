// From what a scene file of three dimensions says to shapes and cameras of Spaceland.
#include <gtest/gtest.h>

#include "scenes/format/build_scene.h"
#include "tests/scenes/format/space_texts.h"

namespace wander::test::build_spaceland_test {
namespace {

using W = Spaceland;
using Point = W::Point;

std::unique_ptr<const Scene<W>> built(const std::string& text) {
  return build_scene<W>(parse(text).scene);
}
std::unique_ptr<const Scene<W>> built_with(const std::string& shape) {
  return built(with_solid(shape));
}
SurfacePoint<W> point_of(const Scene<W>& scene, ShapeId id, double u, double v) {
  return visit_shape([&](const auto& s) { return s.sample({u, v}); }, scene.shape(id));
}

TEST(BuiltSolids, AreWhereTheirDescriptionsSay) {
  const auto sheet = built_with(
      R"({ "type": "parallelogram", "origin": [1, 2, 3], "edges": [[2, 0, 0], [0, 0, 4]] })");
  EXPECT_EQ(point_of(*sheet, 2, 0.25, 0.5).position, Point(1.5, 2, 5));
  EXPECT_EQ(point_of(*sheet, 2, 0, 0).normal, Point(0, -1, 0));
  const auto triangle =
      built_with(R"({ "type": "triangle", "points": [[0, 0, 1], [2, 0, 1], [0, 2, 1]] })");
  EXPECT_EQ(point_of(*triangle, 2, 0, 0).position, Point(0, 0, 1));
  EXPECT_EQ(point_of(*triangle, 2, 0.5, 0.5).normal, Point(0, 0, 1));
  for (const bool flip : {false, true}) {
    const auto ball = built_with(fmt::format(
        R"({{ "type": "sphere", "center": [1, 2, 3], "radius": 2, "flip": {} }})", flip));
    const auto p = point_of(*ball, 2, 0.3, 0.4);
    EXPECT_NEAR(glm::length(p.position - Point(1, 2, 3)), 2, 1e-15);
    EXPECT_EQ(glm::dot(p.normal, p.position - Point(1, 2, 3)) > 0, !flip);
  }
}

TEST(BuiltSolids, HaveTheirLightAndTheirSensor) {
  const auto scene = built(space_only("[" + a_lamp + "," + a_screen + "]"));
  EXPECT_EQ(scene->surface(0).radiance, 5);
  EXPECT_EQ(scene->sensor(), 1);
  EXPECT_EQ(scene->bins(), 32);
  EXPECT_EQ(scene->resolution()[0], 4);  // rows first, the fastest axis last
  // Pixels go along the first edge, then along the second.
  EXPECT_EQ(scene->bin({0.99, 0}), 7);
  EXPECT_EQ(scene->bin({0, 0.99}), 24);
}

TEST(BuiltSolids, HaveTheLuminanceOfTheirColours) {
  const auto scene = built(R"({ "format": "wanderlight-scene/1", "dimension": 3, "materials": {
    "red": { "type": "diffuse", "reflectance": [1, 0.5, 0] },
    "grey": { "type": "diffuse", "reflectance": [0.1, 0.1, 0.1] } },
    "shapes": [ { "type": "sphere", "center": [0, 3, 0], "radius": 0.5, "material": "red",
      "light": { "radiance": [0, 10, 0] } }, { "type": "sphere", "center": [0, 5, 0],
      "radius": 0.5, "material": "grey" }, )" +
                           a_screen + "] }");
  EXPECT_DOUBLE_EQ(scene->surface(0).radiance, 7.152);
  EXPECT_DOUBLE_EQ(std::get<Diffuse<W>>(*scene->surface(0).material).reflectance,
                   0.2126 + 0.7152 / 2);
  EXPECT_EQ(std::get<Diffuse<W>>(*scene->surface(1).material).reflectance, 0.1);
}

// What a pinhole at (0, 0, 5) sees that looks along -z, with y up: the first pixel is top left.
TEST(BuiltViews, HaveTheFirstPixelAtTheTopLeft) {
  const auto scene = built(with_view(R"("position": [0, 0, 5], "target": [0, 0, 0], "fov_deg": 90,
    "resolution": [8, 4])"));
  const Camera<W>& camera = *scene->camera();
  EXPECT_EQ(camera.across[0], Point(1, 0, 0));
  EXPECT_EQ(camera.across[1], Point(0, -1, 0));
  EXPECT_NEAR(camera.extent[0], 2, 1e-15);
  EXPECT_NEAR(camera.extent[1], 1, 1e-15);
  EXPECT_EQ(camera.focus_distance, 5);
  const auto film = camera.film_coordinate(camera.position, glm::normalize(Point(-0.9, 0.45, -1)));
  ASSERT_TRUE(film);
  EXPECT_EQ(scene->bin(*film), 0);
  EXPECT_FALSE(camera.film_coordinate(camera.position, glm::normalize(Point(0, 0.55, -1))));
}

TEST(BuiltViews, StandUprightWhateverTheLengthOfUp) {
  const auto scene = built(with_view(R"("position": [1, 2, 3], "target": [4, 4, 4], "fov_deg": 50,
    "up": [0, 0, 100], "resolution": [8, 8], "aperture_radius": 0.5, "focus_distance": 2)"));
  const Camera<W>& camera = *scene->camera();
  const Point axis = glm::normalize(Point(3, 2, 1));
  EXPECT_NEAR(glm::length(camera.axis - axis), 0, 1e-15);
  EXPECT_NEAR(glm::dot(camera.across[0], axis), 0, 1e-15);
  EXPECT_NEAR(camera.across[0].z, 0, 1e-15);  // across up
  EXPECT_LT(camera.across[1].z, 0);           // down
  for (const Point& side : camera.across) EXPECT_NEAR(glm::length(side), 1, 1e-15);
  EXPECT_GT(glm::dot(glm::cross(camera.across[0], axis), camera.across[1]), -1 - 1e-15);
  EXPECT_EQ(camera.lens_radius, 0.5);
  EXPECT_EQ(camera.focus_distance, 2);
}

// Rays that are cast into a scene that was read meet what it says, and name the triangle.
TEST(BuiltScenes, OfMeshesAreHitWhereTheyAre) {
  description::Scene scene = parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene;
  auto triangles = std::make_shared<Triangles>();
  triangles->points = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  triangles->corners = {{0, 2, 1}, {0, 3, 2}};
  description::Shape shape;
  shape.kind = description::Mesh{"m.obj", triangles};
  shape.light = description::Light{{{2, 2, 2}, false}};
  scene.shapes.push_back(shape);
  const auto space = build_scene<W>(scene);
  const Ray<W> ray{.origin = {-0.5, 0.5, 0.5}, .direction = {0, 1, 0}};
  const Hit<W> hit = space->closest(ray);
  EXPECT_EQ(hit.shape, 2);
  EXPECT_EQ(hit.primitive, 1);
  EXPECT_EQ(hit.distance, 0.5);
  const auto point = space->surface_point(ray, hit);
  EXPECT_EQ(point.normal, Point(0, 1, 0));
  EXPECT_EQ(point.primitive, 1);
  EXPECT_NEAR(glm::length(point.position - Point(-0.5, 1, 0.5)), 0, 1e-15);
  EXPECT_FALSE(space->closest({.origin = point.position,
                               .direction = {1, 0.001, 0},
                               .from = Element<W>(hit.shape, hit.primitive)}));
  EXPECT_EQ(space->lights().size(), 2u);
  EXPECT_NEAR(space->light_choice().probability(1), 2 * 4 / (2 * 4 + 5 * std::numbers::pi), 1e-15);
}

}  // namespace
}  // namespace wander::test::build_spaceland_test

// From what a scene file says to shapes, materials and cameras: every field in its place.
#include "scenes/format/build_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wander::test::build_scene_test {
namespace {

using Point = Flatland::Point;
constexpr double pi = std::numbers::pi;

description::Quantity grey(double value) { return {{value, value, value}, false}; }

// The shape, dark, beside a light and a sensor; it comes first.
std::unique_ptr<const Scene<Flatland>> scene_with(description::ShapeKind kind) {
  description::Scene scene;
  scene.shapes.resize(3);
  scene.shapes[0].kind = std::move(kind);
  scene.shapes[1].kind = description::Segment{{9, 9}, {8, 9}};
  scene.shapes[1].light = description::Light{grey(2)};
  scene.shapes[2].kind = description::Segment{{9, 8}, {8, 8}};
  scene.shapes[2].sensor = description::Sensor{{3}};
  return build_flatland(scene);
}

SurfacePoint<Flatland> point_of(const Scene<Flatland>& scene, ShapeId id, double u) {
  return visit_shape([u](const auto& s) { return s.sample({u}); }, scene.shape(id));
}
double length_of(const Scene<Flatland>& scene, ShapeId id) {
  return visit_shape([](const auto& s) { return s.measure(); }, scene.shape(id));
}

TEST(BuiltArcs, RunFromTheFirstAngleToTheSecondCounterClockwise) {
  for (const auto& [from, to, extent] :
       {std::array{350.0, 80.0, 90.0}, {10.0, 40.0, 30.0}, {-90.0, 180.0, 270.0}}) {
    const auto scene = scene_with(description::Arc{{1, 2}, 3, from, to, false});
    EXPECT_NEAR(length_of(*scene, 0), 3 * extent * pi / 180, 1e-12);
    const double start = from * pi / 180;
    const Point expected = Point(1, 2) + 3.0 * Point(std::cos(start), std::sin(start));
    EXPECT_NEAR(glm::length(point_of(*scene, 0, 0).position - expected), 0, 1e-12);
  }
  EXPECT_NEAR(length_of(*scene_with(description::Arc{{}, 3, 30, 30, false}), 0), 6 * pi, 1e-12);
}

TEST(BuiltCurves, FaceOutwardUnlessFlipped) {
  for (const bool flip : {false, true}) {
    const double side = flip ? -1 : 1;
    for (const auto& scene : {scene_with(description::Circle{{1, 2}, 3, flip}),
                              scene_with(description::Arc{{1, 2}, 3, 0, 90, flip})}) {
      const auto p = point_of(*scene, 0, 0.3);
      EXPECT_GT(side * glm::dot(p.normal, p.position - Point(1, 2)), 0);
    }
  }
}

TEST(BuiltPolylines, HaveASegmentForEachSide) {
  description::Polyline line{{{0, 0}, {1, 0}, {1, 2}}, false};
  EXPECT_EQ(scene_with(line)->lights()[0], 2);  // two sides before it
  line.closed = true;
  const auto scene = scene_with(line);
  EXPECT_EQ(scene->lights()[0], 3);
  EXPECT_NEAR(length_of(*scene, 2), std::sqrt(5), 1e-15);
  EXPECT_EQ(point_of(*scene, 2, 0).position, Point(1, 2));
}

TEST(BuiltScenes, KnowTheirLightTheirSensorAndItsBins) {
  const auto scene = scene_with(description::Segment{{0, 0}, {4, 0}});
  EXPECT_EQ(scene->surface(1).radiance, 2);
  EXPECT_FALSE(scene->surface(0).is_light() || scene->surface(0).is_sensor);
  EXPECT_EQ(scene->sensor(), 2);
  EXPECT_EQ(scene->bins(), 3);
}

TEST(BuiltCameras, HaveTheLensAndTheFocusOfTheirDescription) {
  description::Scene scene;
  scene.shapes.resize(1);
  scene.shapes[0].light = description::Light{grey(1)};
  scene.shapes[0].kind = description::Segment{{9, 9}, {8, 9}};
  auto& camera = scene.camera.emplace();
  camera.position = {1, 1, 0};
  camera.target = {1, 4, 0};
  camera.fov_degrees = 90;
  camera.resolution = {5};
  camera.aperture_radius = 0.25;
  auto built = build_flatland(scene);
  EXPECT_EQ(built->bins(), 5);
  EXPECT_EQ(built->camera()->lens_radius, 0.25);
  EXPECT_EQ(built->camera()->focus_distance, 3);  // on the target, if nothing else is said
  EXPECT_NEAR(built->camera()->extent[0], 2, 1e-15);
  EXPECT_EQ(built->camera()->across[0], Point(1, 0));  // to the right
  camera.focus_distance = 0.5;
  EXPECT_EQ(build_flatland(scene)->camera()->focus_distance, 0.5);
}

TEST(BuiltMaterials, AreThoseOfTheirDescriptionOrWhatTheyAmountTo) {
  const auto build = [](description::MaterialKind kind) { return build_material<Flatland>(kind); };
  EXPECT_EQ(std::get<Diffuse<Flatland>>(build(description::Diffuse{grey(0.3)})).reflectance, 0.3);
  EXPECT_EQ(std::get<Mirror<Flatland>>(build(description::Mirror{grey(0.4)})).reflectance, 0.4);
  const auto glass = std::get<Dielectric<Flatland>>(build(description::Dielectric{1.5, 1.25}));
  EXPECT_EQ(glass.interior, 1.5);
  EXPECT_EQ(glass.exterior, 1.25);
  EXPECT_TRUE(std::holds_alternative<Black<Flatland>>(build(description::Diffuse{grey(0)})));
  EXPECT_TRUE(std::holds_alternative<Black<Flatland>>(build(description::Mirror{grey(0)})));
}

}  // namespace
}  // namespace wander::test::build_scene_test

// Making small Flatland scenes for tests of the core, by the same description that a scene file
// becomes.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/exact/plane.h"
#include "scenes/format/build_scene.h"

namespace wander::test {

using namespace exact;

// What a shape is made for.  Nothing: black.
struct Role {
  std::optional<std::size_t> material{};
  double radiance = 0;  // of a light, if positive
  int bins = 0;         // of a sensor, if positive
};

class SceneMaker {
 public:
  explicit SceneMaker(int max_vertices) { scene_.max_vertices = max_vertices; }

  static description::Quantity grey(double value) { return {{value, value, value}, false}; }

  // The index of a new material, for roles.
  std::size_t material(description::MaterialKind kind) {
    scene_.materials.push_back({std::to_string(scene_.materials.size()), kind});
    return scene_.materials.size() - 1;
  }
  std::size_t diffuse(double reflectance) {
    return material(description::Diffuse{grey(reflectance)});
  }
  std::size_t mirror(double reflectance) {
    return material(description::Mirror{grey(reflectance)});
  }
  std::size_t glass(double index) { return material(description::Dielectric{index, 1}); }
  std::size_t rough_metal(double roughness, double reflectance) {
    return material(description::RoughConductor{roughness, grey(reflectance)});
  }
  std::size_t rough_glass(double roughness, double index) {
    return material(description::RoughDielectric{roughness, index, 1});
  }

  SceneMaker& shape(description::ShapeKind kind, Role role) {
    description::Shape made;
    made.kind = std::move(kind);
    made.material = role.material;
    if (role.radiance > 0) made.light = description::Light{grey(role.radiance)};
    if (role.bins > 0) made.sensor = description::Sensor{{role.bins}};
    scene_.shapes.push_back(std::move(made));
    return *this;
  }

  SceneMaker& segment(PlanePoint from, PlanePoint to, Role role = {}) {
    return shape(description::Segment{coordinates(from), coordinates(to)}, role);
  }
  SceneMaker& line(PlaneSegment s, Role role = {}) { return segment(s.from, s.to, role); }
  // Runs around once; the inside is in front if it runs counter-clockwise.
  SceneMaker& room(const std::vector<PlanePoint>& corners, Role role) {
    description::Polyline walls{{}, true};
    for (const PlanePoint p : corners) walls.points.push_back(coordinates(p));
    return shape(walls, role);
  }
  enum class Normal { outward, inward };
  SceneMaker& circle(PlanePoint center, double radius, Role role, Normal normal = Normal::outward) {
    return shape(description::Circle{coordinates(center), radius, normal == Normal::inward}, role);
  }
  SceneMaker& arc(PlanePoint center, double radius, double from, double to, Role role) {
    return shape(description::Arc{coordinates(center), radius, from, to, false}, role);
  }
  SceneMaker& camera(description::Camera camera) {
    scene_.camera = std::move(camera);
    return *this;
  }

  const description::Scene& description() const { return scene_; }
  std::unique_ptr<const Scene<Flatland>> build() const { return build_flatland(scene_); }

  static description::Coordinates coordinates(PlanePoint p) { return {p.x, p.y, 0}; }

 private:
  description::Scene scene_;
};

// Walls that do not touch, so that no edge of a path is short and every technique has a finite
// variance: a light and a sensor that scatter, four walls of unequal reflectance, and something in
// the middle that casts shadows.
inline SceneMaker open_room(int max_vertices) {
  SceneMaker room(max_vertices);
  const std::size_t dark = room.diffuse(0.4), bright = room.diffuse(0.8);
  room.segment({0.1, 0}, {1.9, 0.05}, {bright, 0, 4});
  room.segment({2, 0.15}, {1.95, 0.9}, {dark});
  room.segment({1.5, 1}, {0.4, 1.05}, {bright, 2});
  room.segment({0, 0.85}, {0.05, 0.2}, {bright});
  room.segment({1.1, 0.4}, {0.7, 0.55}, {dark});
  room.segment({1.7, 1.1}, {2, 1.3}, {dark, 0.5});  // a second light, weaker, that faces away
  return room;
}

// Every material, light and sensor on top of one, walls and curves, closed.
inline SceneMaker full_room(int max_vertices) {
  SceneMaker room(max_vertices);
  const std::size_t plaster = room.diffuse(0.7);
  room.segment({0, 0}, {2, 0}, {plaster, 0, 6});
  room.segment({2, 0}, {2, 1.2}, {room.mirror(0.9)});
  room.segment({2, 1.2}, {0, 1}, {plaster});
  room.segment({0, 1}, {0, 0}, {room.rough_metal(0.2, 0.9)});
  room.segment({1.2, 1}, {0.5, 0.98}, {plaster, 3});
  room.circle({0.7, 0.4}, 0.2, {room.glass(1.5)});
  room.circle({1.5, 0.5}, 0.15, {room.rough_glass(0.3, 1.5)});
  room.arc({1.1, 0.2}, 0.1, 20, 160, {plaster});
  return room;
}

}  // namespace wander::test

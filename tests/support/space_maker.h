// Making small scenes of space for tests, by the same description that a scene file becomes.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "core/description.h"

namespace wander::test {

class SpaceMaker {
 public:
  using Coordinates = description::Coordinates;
  using Quantity = description::Quantity;

  // What a shape is made for.  Nothing: black.
  struct Role {
    std::optional<std::size_t> material{};
    std::optional<Quantity> radiance{};
    std::vector<int> resolution{};  // of a sensor
  };

  explicit SpaceMaker(int max_vertices) {
    scene_.dimension = 3;
    scene_.max_vertices = max_vertices;
  }

  static Quantity grey(double value) { return {{value, value, value}, false}; }
  static Quantity colour(double red, double green, double blue) {
    return {{red, green, blue}, true};
  }

  // The index of a new material, for roles.
  std::size_t material(description::MaterialKind kind) {
    scene_.materials.push_back({std::to_string(scene_.materials.size()), kind});
    return scene_.materials.size() - 1;
  }
  std::size_t diffuse(Quantity reflectance) { return material(description::Diffuse{reflectance}); }
  std::size_t mirror(Quantity reflectance) { return material(description::Mirror{reflectance}); }
  std::size_t glass(double index) { return material(description::Dielectric{index, 1}); }

  SpaceMaker& shape(description::ShapeKind kind, Role role) {
    description::Shape made;
    made.kind = std::move(kind);
    made.material = role.material;
    if (role.radiance) made.light = description::Light{*role.radiance};
    if (!role.resolution.empty()) made.sensor = description::Sensor{std::move(role.resolution)};
    scene_.shapes.push_back(std::move(made));
    return *this;
  }
  SpaceMaker& parallelogram(Coordinates origin, Coordinates edge, Coordinates other, Role role) {
    return shape(description::Parallelogram{origin, {edge, other}}, std::move(role));
  }
  SpaceMaker& triangle(std::array<Coordinates, 3> points, Role role) {
    return shape(description::Triangle{points}, std::move(role));
  }
  SpaceMaker& sphere(Coordinates center, double radius, Role role) {
    return shape(description::Sphere{center, radius, false}, std::move(role));
  }
  SpaceMaker& camera(description::Camera camera) {
    scene_.camera = std::move(camera);
    return *this;
  }

  const description::Scene& description() const { return scene_; }

 private:
  description::Scene scene_;
};

}  // namespace wander::test

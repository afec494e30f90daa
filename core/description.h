// What a scene file says, as plain data: the contract between the reader of scene files and the
// builder of scenes.  Nothing here knows JSON, geometry or light transport.
//
// Units: metres, degrees where a name ends in `_degrees`, radiance in W/(m rad) in two dimensions
// and W/(m^2 sr) in three.  A document that reaches this form is valid: every number is finite and
// in the domain that schema/scene.schema.json states, every reference resolves.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/geometry/triangles.h"

namespace wander::description {

// Two coordinates in Flatland, three in Spaceland; the third is zero in Flatland.
using Coordinates = std::array<double, 3>;
// One number, or red, green and blue (linear, Rec. 709): grey is three equal channels with
// `coloured` false.
struct Quantity {
  std::array<double, 3> channels{};
  bool coloured = false;
};

struct Black {};
struct Diffuse {
  Quantity reflectance;
};
struct Mirror {
  Quantity reflectance;
};
struct Dielectric {
  double interior_index = 1.5, exterior_index = 1;
};
struct RoughConductor {
  double roughness = 0;
  Quantity reflectance;
};
struct RoughDielectric {
  double roughness = 0, interior_index = 1.5, exterior_index = 1;
};
using MaterialKind =
    std::variant<Black, Diffuse, Mirror, Dielectric, RoughConductor, RoughDielectric>;

struct Material {
  std::string name;
  MaterialKind kind;
};

// One-sided Lambertian emission, from the side of the normal.
struct Light {
  Quantity radiance;
};
// One-sided Lambertian response, on the side of the normal; one bin per entry in 2D, {w, h} in 3D.
struct Sensor {
  std::vector<int> resolution;
};

struct Segment {
  Coordinates from{}, to{};
};
struct Polyline {
  std::vector<Coordinates> points;
  bool closed = false;
};
struct Circle {
  Coordinates center{};
  double radius = 0;
  bool flip = false;
};
struct Arc {
  Coordinates center{};
  double radius = 0, from_degrees = 0, to_degrees = 0;
  bool flip = false;
};
// Of space; a normal is on the side from which the corners run counter-clockwise.
struct Triangle {
  std::array<Coordinates, 3> points{};
};
struct Parallelogram {
  Coordinates origin{};
  std::array<Coordinates, 2> edges{};  // the normal is along edges[0] × edges[1]
};
struct Sphere {
  Coordinates center{};
  double radius = 0;
  bool flip = false;
};
struct Mesh {
  std::string file;                            // as the scene names it
  std::shared_ptr<const Triangles> triangles;  // of the file, where the transform puts them
};
using ShapeKind =
    std::variant<Segment, Polyline, Circle, Arc, Triangle, Parallelogram, Sphere, Mesh>;

// For a visitor that knows the shapes of one dimension only.  Throws std::logic_error for a shape of
// the other.
template <class Visitor>
auto visit_known(Visitor&& visitor, const ShapeKind& kind) {
  using One = std::conditional_t<std::is_invocable_v<Visitor&, const Segment&>, Segment, Sphere>;
  using Result = std::invoke_result_t<Visitor&, const One&>;
  return std::visit(
      [&]<class Kind>(const Kind& shape) -> Result {
        if constexpr (std::is_invocable_v<Visitor&, const Kind&>)
          return visitor(shape);
        else
          throw std::logic_error("a shape of the other dimension");
      },
      kind);
}

struct Shape {
  ShapeKind kind;
  std::optional<std::size_t> material;  // index into Scene::materials; none means black
  std::optional<Light> light;
  std::optional<Sensor> sensor;
  std::string name, id;
  int line = 0, column = 0;  // where the shape begins in its file, for messages
};

struct Camera {
  Coordinates position{}, target{}, up{};
  double fov_degrees = 0;  // horizontal, whole angle
  std::vector<int> resolution;
  double aperture_radius = 0;
  std::optional<double> focus_distance;  // default: distance from position to target
};

struct Scene {
  std::string name, description;
  int dimension = 2;
  int max_vertices = 8;
  std::vector<Material> materials;
  std::vector<Shape> shapes;
  std::optional<Camera> camera;
};

}  // namespace wander::description

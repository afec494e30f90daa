// What a scene file says, as plain data: the contract between the reader of scene files and the
// builder of scenes.  Nothing here knows JSON or light transport; which shapes there are stands in
// geometry/shape.h.
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

#include "core/geometry/shape.h"
#include "core/tint.h"

namespace wander {
class Texture;
}

namespace wander::description {

// One number, or red, green and blue (linear, Rec. 709): grey is three equal channels with
// `coloured` false.  A reflectance that a texture says has the texture's mean as its channels.
struct Quantity {
  std::array<double, 3> channels{};
  bool coloured = false;
  std::shared_ptr<const Texture> texture{};
};
inline double luminance(const Quantity& q) {
  return q.coloured ? wander::luminance(q.channels) : q.channels[0];
}

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
// Conductors by their index of refraction eta + i k.
struct Conductor {
  Quantity eta, k;
};
struct RoughMetal {
  double roughness = 0;
  Quantity eta, k;
};
using MaterialKind = std::variant<Black, Diffuse, Mirror, Dielectric, RoughConductor,
                                  RoughDielectric, Conductor, RoughMetal>;

struct Material {
  std::string name;
  MaterialKind kind;
};

// Of a channel that is not 0.  The range of single precision, less what a pixel and its error may be beside a radiance: what goes
// beyond that all the same is zero or infinite in film.exr, and as it is in film.nc.
inline constexpr double smallest_radiance = 1e-36, largest_radiance = 1e36;

// One-sided Lambertian emission, from the side of the normal.
struct Light {
  Quantity radiance;
};
// One-sided Lambertian response, on the side of the normal; one bin per entry in 2D, {w, h} in 3D.
struct Sensor {
  std::vector<int> resolution;
};

// A kind of shape of the plane has an outline, one of space has faces.
template <class Kind>
inline constexpr int dimension_of = requires(const Kind& kind) {
  kind.outline();
}
? 2 : 3;

// For a visitor of the shapes of D dimensions.  Throws std::logic_error for one of the other.
template <int D, class Visitor>
auto visit_kind(Visitor&& visitor, const ShapeKind& kind) {
  using One = std::conditional_t<D == 2, Segment, Triangle>;
  using Result = std::invoke_result_t<Visitor&, const One&>;
  return std::visit(
      [&]<class Kind>(const Kind& shape) -> Result {
        if constexpr (dimension_of<Kind> == D)
          return visitor(shape);
        else
          throw std::logic_error("a shape of the other dimension");
      },
      kind);
}

inline Outline outline_of(const ShapeKind& kind) {
  return visit_kind<2>([](const auto& shape) { return shape.outline(); }, kind);
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
  int line = 0, column = 0;              // where the camera begins in its file, for messages
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

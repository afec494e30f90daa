// The faces of surfaces in space, as their extent and what lies on each other are measured: never on the
// way of light.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <variant>

#include "core/description.h"

namespace wander {

// A triangle or parallelogram: corner + u edge0 + v edge1.
struct Sheet {
  glm::dvec3 corner{}, edge0{}, edge1{};
  bool is_triangle = false;

  bool has_area() const { return glm::cross(edge0, edge1) != glm::dvec3(0); }
  glm::dvec3 normal() const { return glm::normalize(glm::cross(edge0, edge1)); }
  double shortest_side() const;
  std::array<glm::dvec3, 4> inner_points() const;
  // Of a point in its plane: is it inside, or inside or on the edge to within rounding?
  bool holds(glm::dvec3 point) const;
  bool reaches(glm::dvec3 point) const;

 private:
  glm::dvec2 coordinates(glm::dvec3 point) const;  // along the edges
};

struct Ball {
  glm::dvec3 center{};
  double radius = 0;
};

using Face = std::variant<Sheet, Ball>;

struct Extent {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  glm::dvec3 low{infinity}, high{-infinity};

  double diameter() const { return glm::length(high - low); }
  // The largest coordinate, in diameters.
  double remoteness() const {
    const glm::dvec3 reach = glm::max(glm::abs(low), glm::abs(high));
    return std::max({reach.x, reach.y, reach.z}) / diameter();
  }
  void include(glm::dvec3 point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void include(const Extent& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  // Within this distance.
  bool meets(const Extent& other, double distance) const {
    return glm::all(glm::lessThanEqual(low, other.high + distance)) &&
           glm::all(glm::lessThanEqual(other.low, high + distance));
  }
};

Face face_of(const description::Triangle& triangle);
Face face_of(const description::Parallelogram& parallelogram);
Face face_of(const description::Sphere& sphere);
Extent extent_of(const Face& face);

template <class Visitor>
void for_each_face(const description::ShapeKind& kind, Visitor&& visit) {
  description::visit_kind<3>(
      [&](const auto& surface) {
        surface.for_each_face([&](const auto& face) { visit(face_of(face)); });
      },
      kind);
}

}  // namespace wander

#include "scenes/format/measured_face.h"

#include <algorithm>

namespace wander {

namespace {

using Point = glm::dvec3;

Point point_of(const description::Coordinates& c) { return {c[0], c[1], c[2]}; }

}  // namespace

double Sheet::shortest_side() const {
  const double sides = std::min(glm::length(edge0), glm::length(edge1));
  return is_triangle ? std::min(sides, glm::length(edge1 - edge0)) : sides;
}

std::array<Point, 4> Sheet::inner_points() const {
  const auto at = [&](double u, double v) { return corner + u * edge0 + v * edge1; };
  if (is_triangle) return {at(0.33, 0.33), at(0.01, 0.01), at(0.98, 0.01), at(0.01, 0.98)};
  return {at(0.5, 0.5), at(0.01, 0.01), at(0.99, 0.01), at(0.99, 0.99)};
}

glm::dvec2 Sheet::coordinates(Point p) const {
  const Point area = glm::cross(edge0, edge1);
  const double size = glm::dot(area, area);
  return {glm::dot(glm::cross(p - corner, edge1), area) / size,
          glm::dot(glm::cross(edge0, p - corner), area) / size};
}

bool Sheet::holds(Point p) const {
  const glm::dvec2 at = coordinates(p);
  return at.x > 0 && at.y > 0 && (is_triangle ? at.x + at.y < 1 : at.x < 1 && at.y < 1);
}

bool Sheet::reaches(Point p) const {
  constexpr double rounding = 1e-12;
  const glm::dvec2 at = coordinates(p);
  const double most = is_triangle ? at.x + at.y : std::max(at.x, at.y);
  return std::min(at.x, at.y) >= -rounding && most <= 1 + rounding;
}

Face face_of(const description::Triangle& s) {
  const Point a = point_of(s.points[0]);
  return Sheet{a, point_of(s.points[1]) - a, point_of(s.points[2]) - a, true};
}
Face face_of(const description::Parallelogram& s) {
  return Sheet{point_of(s.origin), point_of(s.edges[0]), point_of(s.edges[1])};
}
Face face_of(const description::Sphere& s) { return Ball{point_of(s.center), s.radius}; }

Extent extent_of(const Face& face) {
  Extent extent;
  if (const auto* ball = std::get_if<Ball>(&face)) {
    extent.include(ball->center - ball->radius);
    extent.include(ball->center + ball->radius);
    return extent;
  }
  const Sheet& sheet = std::get<Sheet>(face);
  for (const Point& p : {sheet.corner, sheet.corner + sheet.edge0, sheet.corner + sheet.edge1})
    extent.include(p);
  if (!sheet.is_triangle) extent.include(sheet.corner + sheet.edge0 + sheet.edge1);
  return extent;
}

}  // namespace wander

#include "scenes/import/back_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numbers>

namespace wander {

namespace {

using Point = glm::dvec3;

constexpr std::size_t most_facets = 5000, most_points = 1000;
constexpr std::size_t most_comparisons = 100'000'000;
constexpr double slack = 1e-6;  // of the scene's size

struct Extent {
  Point low{std::numeric_limits<double>::infinity()},
      high{-std::numeric_limits<double>::infinity()};

  void add(Point p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool holds(Point p, double margin) const {
    for (int axis = 0; axis < 3; ++axis)
      if (!(p[axis] > low[axis] + margin && p[axis] < high[axis] - margin)) return false;
    return true;
  }
};

Point point(const Triangles& mesh, std::int32_t index) {
  const auto& p = mesh.points[static_cast<std::size_t>(index)];
  return {p[0], p[1], p[2]};
}

Extent extent_of(std::span<const Point> points) {
  Extent extent;
  for (const Point p : points) extent.add(p);
  return extent;
}

// Each edge has one triangle on either side; points at the same place are one.
bool is_closed(const Triangles& mesh) {
  std::map<std::array<double, 3>, std::int32_t> places;
  std::vector<std::int32_t> place;
  for (const auto& p : mesh.points)
    place.push_back(places.emplace(p, static_cast<std::int32_t>(places.size())).first->second);
  std::map<std::pair<std::int32_t, std::int32_t>, int> edges;  // uses one way less those the other
  for (const auto& corners : mesh.corners)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = place[static_cast<std::size_t>(corners[i])],
                         b = place[static_cast<std::size_t>(corners[(i + 1) % 3])];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  return !mesh.corners.empty() &&
         std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

double volume_of(const Triangles& mesh) {
  if (mesh.points.empty()) return 0;
  const Point from = point(mesh, 0);
  double six = 0;
  for (const auto& c : mesh.corners)
    six += glm::dot(point(mesh, c[0]) - from,
                    glm::cross(point(mesh, c[1]) - from, point(mesh, c[2]) - from));
  return six / 6;
}

class Onlookers {
 public:
  Onlookers(std::span<const PlacedSurface> surfaces, std::span<const Point> eyes)
      : surfaces_(surfaces), eyes_(eyes) {
    Extent all = extent_of(eyes);
    for (const PlacedSurface& surface : surfaces)
      for (const Point p : surface.points) all.add(p);
    const Point size = all.high - all.low;
    slack_ = slack * std::max({size.x, size.y, size.z, 0.0});
  }

  bool are_behind(std::size_t index) {
    const PlacedSurface& surface = surfaces_[index];
    if (surface.back == PlacedSurface::Back::same) return false;
    if (surface.enclosure == PlacedSurface::Enclosure::open)
      return surface.facets.corners.empty() || are_behind_facets(index);
    const Extent extent = extent_of(surface.points);
    if (surface.enclosure == PlacedSurface::Enclosure::front_inside)
      return any(index, [&](Point p) { return !extent.holds(p, -slack_); });
    return any(index, [&](Point p) { return extent.holds(p, slack_) && is_inside(surface, p); });
  }

 private:
  // Also when there is too much to look at.
  template <class Test>
  bool any(std::size_t but, Test&& test) {
    if (std::ranges::any_of(eyes_, test)) return true;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      if (i == but) continue;
      comparisons_ += surfaces_[i].points.size();
      if (comparisons_ > most_comparisons || std::ranges::any_of(surfaces_[i].points, test))
        return true;
    }
    return false;
  }

  // By the solid angle that the facets cover [Van Oosterom and Strackee 1983]; of a surface with too
  // many, whatever is in its extent.
  bool is_inside(const PlacedSurface& surface, Point p) {
    if (surface.radius > 0) return glm::length(p - surface.center) < surface.radius - slack_;
    if (surface.facets.corners.empty()) return true;
    double angle = 0;
    for (const auto& corners : surface.facets.corners) {
      const Point a = point(surface.facets, corners[0]) - p,
                  b = point(surface.facets, corners[1]) - p,
                  c = point(surface.facets, corners[2]) - p;
      const double x = glm::length(a), y = glm::length(b), z = glm::length(c);
      angle +=
          2 * std::atan2(glm::dot(a, glm::cross(b, c)),
                         x * y * z + glm::dot(a, b) * z + glm::dot(b, c) * x + glm::dot(c, a) * y);
    }
    comparisons_ += surface.facets.corners.size();
    return std::abs(angle) > 2 * std::numbers::pi;
  }

  bool are_behind_facets(std::size_t index) {
    const Triangles& mesh = surfaces_[index].facets;
    for (const auto& corners : mesh.corners) {
      const Point a = point(mesh, corners[0]);
      const Point across = glm::cross(point(mesh, corners[1]) - a, point(mesh, corners[2]) - a);
      const double length = glm::length(across);
      if (!(length > 0)) continue;
      const auto is_behind = [&](Point p) { return glm::dot(p - a, across) < -slack_ * length; };
      comparisons_ += mesh.points.size();
      for (std::size_t i = 0; i < mesh.points.size(); ++i)
        if (is_behind(point(mesh, static_cast<std::int32_t>(i)))) return true;
      if (any(index, is_behind)) return true;
    }
    return false;
  }

  std::span<const PlacedSurface> surfaces_;
  std::span<const Point> eyes_;
  double slack_ = 0;
  std::size_t comparisons_ = 0;
};

}  // namespace

PlacedSurface placed_mesh(Triangles mesh, PlacedSurface::Back back) {
  PlacedSurface surface;
  surface.back = back;
  if (mesh.corners.empty()) return surface;
  const std::size_t stride = 1 + mesh.points.size() / most_points;
  for (std::size_t i = 0; i < mesh.points.size(); i += stride)
    surface.points.push_back(point(mesh, static_cast<std::int32_t>(i)));
  if (back == PlacedSurface::Back::same) return surface;
  if (is_closed(mesh))
    surface.enclosure = volume_of(mesh) > 0 ? PlacedSurface::Enclosure::front_outside
                                            : PlacedSurface::Enclosure::front_inside;
  if (mesh.corners.size() <= most_facets) surface.facets = std::move(mesh);
  return surface;
}

PlacedSurface placed_sphere(Point center, double radius, PlacedSurface::Enclosure enclosure) {
  PlacedSurface surface;
  surface.enclosure = enclosure;
  surface.radius = radius;
  surface.center = center;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-radius, radius}) {
      surface.points.push_back(center);
      surface.points.back()[axis] += side;
    }
  return surface;
}

std::vector<bool> seen_from_behind(std::span<const PlacedSurface> surfaces,
                                   std::span<const Point> eyes) {
  Onlookers onlookers(surfaces, eyes);
  std::vector<bool> seen;
  for (std::size_t i = 0; i < surfaces.size(); ++i) seen.push_back(onlookers.are_behind(i));
  return seen;
}

}  // namespace wander

// Triangles of space, alone: where a ray crosses them, and their points.
//
// Crossings are watertight [Woop, Benthin and Wald 2013]: a ray is sheared into an axis, and on
// which side of it an edge runs is decided from the two projected ends alone, which all triangles
// at that edge compute alike.  A side is never decided wrongly: the difference of two rounded
// products has the right sign or is 0, and then it is computed exactly.  Edges belong to the
// triangles on both sides, so rays at the edges and corners of a closed surface meet it.
#pragma once

#include <algorithm>
#include <glm/common.hpp>

#include "core/geometry/shapes_flat.h"
#include "core/surfaces.h"

namespace wander {

// A corner of a polygon in the coordinates of a sheared ray, which runs along z through 0.
template <World W>
struct ShearedPoint {
  using Length = typename W::Length;
  Length x, y, z;  // z in units of the ray's direction

  ShearedPoint(const ShearedRay<W>& ray, const typename W::Point& p) {
    const Length along = p[ray.z] - ray.origin[ray.z];
    x = p[ray.x] - ray.origin[ray.x] - ray.shear_x * along;
    y = p[ray.y] - ray.origin[ray.y] - ray.shear_y * along;
    z = ray.scale * along;
  }
};

// Twice the signed area of (0, a, b): on which side of the edge from a to b the ray passes.
template <World W>
typename W::Length side_of(const ShearedPoint<W>& a, const ShearedPoint<W>& b) {
  const auto one = a.x * b.y, other = a.y * b.x;
  if (one != other) [[likely]]
    return one - other;
  // Equal as rounded: what is left of both decides.
  return std::fma(a.x, b.y, -one) - std::fma(a.y, b.x, -other);
}

// Where a ray crosses the plane of a triangle: twice the signed areas that it makes with the edges,
// as seen along the ray.
template <World W>
struct TriangleCrossing {
  using Length = typename W::Length;
  Length a = 0, b = 0, c = 0;  // weights of the corners
  Length sum = 0;              // 0: the triangle is missed
  Length distance = 0;         // may be negative

  explicit operator bool() const { return sum != 0; }
};

template <World W>
TriangleCrossing<W> crossing(const ShearedRay<W>& ray, const typename W::Point& a,
                             const typename W::Point& b, const typename W::Point& c) {
  using Length = typename W::Length;
  const ShearedPoint<W> p(ray, a), q(ray, b), r(ray, c);
  const Length u = side_of(q, r), v = side_of(r, p), w = side_of(p, q);
  if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return {};
  const Length sum = u + v + w;
  if (sum == 0) return {};  // seen from its edge, or without area
  return {u, v, w, sum, (u * p.z + v * q.z + w * r.z) / sum};
}

// An origin within rounding of the plane of a polygon counts as in front of it, as a segment's does
// in the plane: light cannot leave a room through the last bit of a corner.
template <World W>
bool lies_on_plane(const typename W::Point& p, const typename W::Point& a,
                   const typename W::Point& normal) {
  using Length = typename W::Length;
  const auto reach = glm::max(glm::abs(a), glm::abs(p));
  const Length most = std::max({reach.x, reach.y, reach.z});
  return std::abs(glm::dot(a - p, normal)) <= 8 * std::numeric_limits<Length>::epsilon() * most;
}

template <World W>
typename W::Direction triangle_normal(const typename W::Point& a, const typename W::Point& b,
                                      const typename W::Point& c) {
  return glm::normalize(glm::cross(b - a, c - a));
}

// Distance to the triangle, or infinity.
template <World W>
typename W::Length triangle_distance(const ShearedRay<W>& ray, const typename W::Point& a,
                                     const typename W::Point& b, const typename W::Point& c) {
  using Length = typename W::Length;
  constexpr Length nothing = std::numeric_limits<Length>::infinity();
  const TriangleCrossing<W> found = crossing(ray, a, b, c);
  if (!found || !(found.distance < ray.limit)) return nothing;
  if (found.distance > 0) [[likely]]
    return found.distance;
  return lies_on_plane<W>(ray.origin, a, triangle_normal<W>(a, b, c)) ? Length(0) : nothing;
}

// Made of the corners, so that it lies in the plane as exactly as they say.
template <World W>
typename W::Point triangle_point(const ShearedRay<W>& ray, const typename W::Point& a,
                                 const typename W::Point& b, const typename W::Point& c) {
  const TriangleCrossing<W> found = crossing(ray, a, b, c);
  return a + (found.b / found.sum) * (b - a) + (found.c / found.sum) * (c - a);
}

// Even by area; lines of equal u[0] are parallel to the side opposite a.
template <World W>
typename W::Point triangle_sample(typename W::Square u, const typename W::Point& a,
                                  const typename W::Point& b, const typename W::Point& c) {
  using Length = typename W::Length;
  const Length far = std::sqrt(Length(u[0])), share = Length(u[1]);
  return a + far * ((1 - share) * (b - a) + share * (c - a));
}
template <World W>
std::array<typename W::Length, 2> triangle_parameter(const typename W::Point& p,
                                                     const typename W::Point& a,
                                                     const typename W::Point& b,
                                                     const typename W::Point& c) {
  using Length = typename W::Length;
  const auto area = glm::cross(b - a, c - a);
  const Length size = glm::length(area);
  const auto normal = area / size;
  const Length to_b = glm::dot(glm::cross(p - a, c - a), normal) / size,
               to_c = glm::dot(glm::cross(b - a, p - a), normal) / size;
  const Length far = to_b + to_c;
  return {far * far, far > 0 ? to_c / far : Length(0)};
}

template <World W>
Box<W> triangle_bounds(const typename W::Point& a, const typename W::Point& b,
                       const typename W::Point& c) {
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

template <World W>
class Triangle {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  static constexpr bool flat = true;

  Triangle(Point a, Point b, Point c) : a_(a), b_(b), c_(c) {}  // counter-clockwise from outside

  Length intersect(const ShearedRay<W>& ray, Element<W> self) const {
    if (ray.from == self || ray.to == self) return std::numeric_limits<Length>::infinity();
    return triangle_distance(ray, a_, b_, c_);
  }
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>&) const {
    return {triangle_point<W>(ray, a_, b_, c_), normal()};
  }
  SurfacePoint<W> sample(typename W::Square u) const {
    return {triangle_sample<W>(u, a_, b_, c_), normal()};
  }
  typename W::Square parameter(Point p, PrimitiveId<W> = {}) const {
    const auto u = triangle_parameter<W>(p, a_, b_, c_);
    return {into_unit<typename W::Real>(u[0]), into_unit<typename W::Real>(u[1])};
  }
  Length measure() const { return glm::length(glm::cross(b_ - a_, c_ - a_)) / 2; }
  Point edge(PrimitiveId<W>) const { return b_ - a_; }
  Box<W> bounds() const { return triangle_bounds<W>(a_, b_, c_); }

 private:
  typename W::Direction normal() const { return triangle_normal<W>(a_, b_, c_); }

  Point a_, b_, c_;
};

template <World W, class Add>
void add_surfaces(const description::Triangle& s, SurfaceRole, Add&& add) {
  const auto& [a, b, c] = s.points;
  add(Triangle<W>(point_of<W>(a), point_of<W>(b), point_of<W>(c)));
}

}  // namespace wander

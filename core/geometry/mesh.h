// A surface of triangles that share corners.  The interface is that of shapes_flat.h; a primitive is
// a triangle.
//
// A mesh that emits is sampled evenly: u[0] chooses the triangle by its share of the area, in the
// order of the mesh, and what is left of it is a number of that triangle's own.  So u and the points
// belong together one to one, and what lies near each other in the mesh is near in u; a guide finds
// the triangle in constant time [Chen and Asau 1974].  (An alias table would scatter the numbers of
// a triangle, and could be turned round only by drawing.)
//
// A mesh whose corners have normals is shaded by what is between them (core/shading.h); rays, sides
// and points do not know of it.
#pragma once

#include <memory>

#include "core/geometry/triangle.h"

namespace wander {

template <World W>
class Mesh {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  using Square = typename W::Square;
  static constexpr bool flat = true;
  using Role = SurfaceRole;  // only an emitter has a parameter for each of its points

  Mesh(std::shared_ptr<const Triangles> triangles, Role role);

  std::int32_t primitives() const { return static_cast<std::int32_t>(triangles_->corners.size()); }
  Length intersect(const ShearedRay<W>& ray, Element<W> self) const {
    if (ray.from == self || ray.to == self) return std::numeric_limits<Length>::infinity();
    const auto [a, b, c] = corners(self.primitive);
    return triangle_distance(ray, a, b, c);
  }
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>& hit) const;
  SurfacePoint<W> sample(Square u) const;
  Square parameter(Point p, PrimitiveId<W> primitive = {}) const;
  Length measure() const { return measure_; }
  bool is_smooth() const { return !triangles_->normals.empty(); }
  // The normals of the corners as they are mixed there, on the triangle's own side.
  Point shading_normal(Point p, std::int32_t primitive) const;
  // Those of the corners as they are mixed there.
  std::array<double, 2> texture_coordinates(Point p, std::int32_t primitive) const;
  // Of two the one that runs farther across z, for corners may have normals along z anywhere.
  Point edge(std::int32_t primitive) const {
    const auto [a, b, c] = corners(primitive);
    const Point one = b - a, other = c - a;
    const auto across = [](const Point& e) { return e.x * e.x + e.y * e.y; };
    return across(one) >= across(other) ? one : other;
  }
  Box<W> bounds() const;
  Box<W> bounds(std::int32_t primitive) const {
    const auto [a, b, c] = corners(primitive);
    return triangle_bounds<W>(a, b, c);
  }

 private:
  struct Corners {
    Point a, b, c;
  };
  struct Shares {
    std::vector<double> before;       // of the area, in the triangles before each; 1 at the end
    std::vector<std::int32_t> guide;  // where the search for u[0] begins, by equal steps of it
  };

  Point point(std::int32_t index) const {
    const auto& p = triangles_->points[static_cast<std::size_t>(index)];
    return {p[0], p[1], p[2]};
  }
  Corners corners(std::int32_t primitive) const {
    const auto& index = triangles_->corners[static_cast<std::size_t>(primitive)];
    return {point(index[0]), point(index[1]), point(index[2])};
  }
  Point corner_normal(std::int32_t primitive, std::size_t corner, Point own) const;
  SurfacePoint<W> with_normal(Point p, std::int32_t primitive) const;
  void share_out();
  std::int32_t find(double u) const;
  double before(std::int32_t primitive) const {
    return shares_->before[static_cast<std::size_t>(primitive)];
  }

  std::shared_ptr<const Triangles> triangles_;
  std::shared_ptr<const Shares> shares_;  // of an emitter
  Length measure_ = 0;
};

template <World W, class Add>
void add_surfaces(const description::Mesh& s, SurfaceRole role, Add&& add) {
  add(Mesh<W>(s.triangles, role));
}

}  // namespace wander

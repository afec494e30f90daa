// The smooth surfaces of Spaceland, spheres and parallelograms.  The interface is that of
// shapes_flat.h.
#pragma once

#include "core/geometry/shapes_flat.h"
#include "core/surfaces.h"

namespace wander {

template <World W>
class Sphere {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  static constexpr bool flat = false;
  enum class Facing { outward, inward };

  Sphere(Point center, Length radius, Facing facing);

  Length intersect(const Ray<W>& ray, Element<W> self) const;
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>& hit) const;
  SurfacePoint<W> sample(typename W::Square u) const;
  typename W::Square parameter(Point p, PrimitiveId<W> = {}) const;
  Length measure() const;
  Box<W> bounds() const { return {center_ - Point(radius_), center_ + Point(radius_)}; }

 private:
  Length valid(const Ray<W>& ray, Length distance) const;
  SurfacePoint<W> at(Point from_center) const;

  Point center_;
  Length radius_, facing_;
};

// Its edges are those of triangle.h: where two sheets share corners, bit for bit, no ray passes
// between them.
template <World W>
class Parallelogram {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  static constexpr bool flat = true;

  Parallelogram(Point origin, Point edge0, Point edge1);

  Length intersect(const ShearedRay<W>& ray, Element<W> self) const;
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>& hit) const;
  SurfacePoint<W> sample(typename W::Square u) const;
  typename W::Square parameter(Point p, PrimitiveId<W> = {}) const;
  // Along the edges.
  std::array<double, 2> texture_coordinates(Point p, PrimitiveId<W>) const {
    const Point from_origin = p - origin_;
    return {static_cast<double>(glm::dot(from_origin, dual0_)),
            static_cast<double>(glm::dot(from_origin, dual1_))};
  }
  Length measure() const { return area_; }
  Point edge(PrimitiveId<W>) const { return edge0_; }
  Box<W> bounds() const;

 private:
  Point origin_, edge0_, edge1_, normal_;
  std::array<Point, 4> corners_;
  Point dual0_, dual1_;  // dot(p - origin, dual) are the coordinates along the edges
  Length area_;
};

// ---- What rays meet of the surfaces that scene files name

template <World W, class Add>
void add_surfaces(const description::Sphere& s, SurfaceRole, Add&& add) {
  using Facing = typename Sphere<W>::Facing;
  add(Sphere<W>(point_of<W>(s.center), s.radius, s.flip ? Facing::inward : Facing::outward));
}

template <World W, class Add>
void add_surfaces(const description::Parallelogram& s, SurfaceRole, Add&& add) {
  add(Parallelogram<W>(point_of<W>(s.origin), point_of<W>(s.edges[0]), point_of<W>(s.edges[1])));
}

}  // namespace wander

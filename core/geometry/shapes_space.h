// The surfaces of Spaceland: spheres and parallelograms.  The interface is that of shapes_flat.h.
#pragma once

#include "core/geometry/shapes_flat.h"

namespace wander {

template <World W>
class Sphere {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  enum class Facing { outward, inward };

  Sphere(Point center, Length radius, Facing facing);

  Length intersect(const Ray<W>& ray, ShapeId self) const;
  SurfacePoint<W> surface(const Ray<W>& ray, Length distance) const;
  SurfacePoint<W> sample(typename W::Square u) const;
  typename W::Square parameter(Point p) const;
  Length measure() const;
  Box<W> bounds() const { return {center_ - Point(radius_), center_ + Point(radius_)}; }

 private:
  Length valid(const Ray<W>& ray, Length distance) const;
  SurfacePoint<W> at(Point from_center) const;

  Point center_;
  Length radius_, facing_;
};

template <World W>
class Parallelogram {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;

  Parallelogram(Point origin, Point edge0, Point edge1);

  Length intersect(const Ray<W>& ray, ShapeId self) const;
  SurfacePoint<W> surface(const Ray<W>& ray, Length distance) const;
  SurfacePoint<W> sample(typename W::Square u) const;
  typename W::Square parameter(Point p) const;
  Length measure() const { return area_; }
  Box<W> bounds() const;

 private:
  Point origin_, edge0_, edge1_, normal_;
  Point dual0_, dual1_;  // dot(p - origin, dual) are the coordinates along the edges
  Length area_;
};

}  // namespace wander

// The curves of Flatland: straight segments and exact circular arcs.
//
// A shape offers
//   intersect(ray, self)        distance to the nearest crossing in (0, limit), or infinity; `self`
//                               is the element that is asked
//   surface(ray, hit)           position and normal of that crossing
//   sample(u)                   the point at parameter u in [0,1), by arc length or area
//   parameter(point, primitive) its inverse
//   edge(primitive)             of a flat surface of space, a direction in it that turns with it
//   measure(), bounds()
//   flat                        no two points of one primitive see each other
// and a shape of many primitives (mesh.h) also their number, primitives(), and bounds(primitive).
#pragma once

#include <numbers>

#include "core/curves.h"
#include "core/ray.h"

namespace wander {

template <World W>
typename W::Point point_of(const description::Coordinates& c) {
  typename W::Point p;
  for (int axis = 0; axis < W::dimension; ++axis)
    p[axis] = c[static_cast<std::size_t>(axis)] + 0.0;  // -0 is 0
  return p;
}

template <World W>
struct Box {
  typename W::Point low, high;
};

template <World W>
class Segment {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  static constexpr bool flat = true;

  Segment(Point from, Point to);

  // The end points are classified by the side of the ray they lie on, so segments that share an end
  // point leave no gap: a ray through it crosses exactly one of the two.  How far the crossing is they would
  // not tell well: what rounding makes of them is of the order of the distance, so a long ray would miss what stands
  // close before its end.  With e from end to end, d = a × e / direction × e.
  Length intersect(const Ray<W>& ray, Element<W> self) const {
    if (ray.from == self || ray.to == self) return miss();
    const Point a = from_ - ray.origin, b = to_ - ray.origin;
    const Length side_a = cross(ray.direction, a), side_b = cross(ray.direction, b);
    if ((side_a > 0) == (side_b > 0)) return miss();
    const Point along = to_ - from_;
    const Length numerator = side_a > 0 ? -cross(a, along) : cross(a, along);
    // An origin within rounding of this line counts as in front of it: light cannot leave a room
    // through the last bit of a corner.
    if (!(numerator >= -slack_)) return miss();
    const Length distance = numerator / std::abs(cross(ray.direction, along));
    return distance < ray.limit ? std::max(distance, Length(0)) : miss();
  }
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>&) const {
    const Length side_a = cross(ray.direction, from_ - ray.origin);
    const Length side_b = cross(ray.direction, to_ - ray.origin);
    return {from_ + (to_ - from_) * (side_a / (side_a - side_b)), normal_};
  }
  SurfacePoint<W> sample(typename W::Square u) const {
    return {from_ + (to_ - from_) * Length(u[0]), normal_};
  }
  typename W::Square parameter(Point p, PrimitiveId<W> = {}) const;
  Length measure() const { return length_; }
  Box<W> bounds() const { return {glm::min(from_, to_), glm::max(from_, to_)}; }

  Point from() const { return from_; }
  Point to() const { return to_; }
  Length slack() const { return slack_; }

 private:
  static constexpr Length miss() { return std::numeric_limits<Length>::infinity(); }

  Point from_, to_, normal_;
  Length length_, slack_;
};

// An arc runs counter-clockwise; a circle is an arc of a full turn.
template <World W>
class Arc {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  static constexpr bool flat = false;
  enum class Facing { outward, inward };

  Arc(Point center, Length radius, Length start_radians, Length extent_radians, Facing facing);

  Length intersect(const Ray<W>& ray, Element<W> self) const;
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>& hit) const;
  SurfacePoint<W> sample(typename W::Square u) const;
  typename W::Square parameter(Point p, PrimitiveId<W> = {}) const;
  Length measure() const { return radius_ * extent_; }
  Box<W> bounds() const;

 private:
  bool holds(Point from_center) const;
  SurfacePoint<W> at(Point from_center) const;
  Length valid(const Ray<W>& ray, Length distance) const;

  Point center_, first_, last_;  // unit vectors from the centre to the ends
  Length radius_, start_, extent_, facing_;
};

// ---- What rays meet of the curves that scene files name

template <World W, class Add>
void add_curves(const description::Segment& s, Add&& add) {
  add(Segment<W>(point_of<W>(s.from), point_of<W>(s.to)));
}

template <World W, class Add>
void add_curves(const description::Polyline& s, Add&& add) {
  s.for_each_side([&](const auto& from, const auto& to) {
    add(Segment<W>(point_of<W>(from), point_of<W>(to)));
  });
}

template <World W, class Add>
void add_curves(const description::Circle& s, Add&& add) {
  using Facing = typename Arc<W>::Facing;
  add(Arc<W>(point_of<W>(s.center), s.radius, 0, 2 * std::numbers::pi,
             s.flip ? Facing::inward : Facing::outward));
}

template <World W, class Add>
void add_curves(const description::Arc& s, Add&& add) {
  using Facing = typename Arc<W>::Facing;
  const double degrees = s.degrees_turned(), radian = std::numbers::pi / 180;
  const double turn = degrees >= 360 ? 2 * std::numbers::pi : degrees * radian;
  add(Arc<W>(point_of<W>(s.center), s.radius, s.from_degrees * radian, turn,
             s.flip ? Facing::inward : Facing::outward));
}

}  // namespace wander

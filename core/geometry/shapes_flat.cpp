#include "core/geometry/shapes_flat.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace wander {

namespace {

template <class T>
T largest_coordinate(Vec<2, T> p) {
  return std::max(std::abs(p.x), std::abs(p.y));
}

template <class T>
constexpr T full_turn = 2 * std::numbers::pi_v<T>;

}  // namespace

template <World W>
Segment<W>::Segment(Point from, Point to)
    : from_(from),
      to_(to),
      normal_(glm::normalize(left_of(to - from))),
      length_(glm::length(to - from)),
      slack_(4 * std::numeric_limits<Length>::epsilon() * length_ *
             std::max(largest_coordinate(from), largest_coordinate(to))) {}

template <World W>
typename W::Square Segment<W>::parameter(Point p, PrimitiveId<W>) const {
  const Point along = to_ - from_;
  const Length u = glm::dot(p - from_, along) / glm::dot(along, along);
  return {into_unit<typename W::Real>(u)};
}

template <World W>
Arc<W>::Arc(Point center, Length radius, Length start, Length extent, Facing facing)
    : center_(center),
      first_(std::cos(start), std::sin(start)),
      last_(std::cos(start + extent), std::sin(start + extent)),
      radius_(radius),
      start_(start),
      extent_(extent),
      facing_(facing == Facing::outward ? Length(1) : Length(-1)) {}

template <World W>
bool Arc<W>::holds(Point q) const {
  if (extent_ >= full_turn<Length>) return true;
  if (extent_ <= std::numbers::pi_v<Length>) return cross(first_, q) >= 0 && cross(q, last_) >= 0;
  return !(cross(last_, q) > 0 && cross(q, first_) > 0);
}

template <World W>
auto Arc<W>::valid(const Ray<W>& ray, Length distance) const -> Length {
  if (!(distance > 0 && distance < ray.limit)) return std::numeric_limits<Length>::infinity();
  if (!holds(ray.origin + distance * ray.direction - center_))
    return std::numeric_limits<Length>::infinity();
  return distance;
}

// |m + t d|² = R² with m from the centre to the origin.  Where the ray touches this curve one root
// is known, 0 or 1, and is divided out.
template <World W>
auto Arc<W>::intersect(const Ray<W>& ray, Element<W> self) const -> Length {
  const Point m = ray.origin - center_;
  const Length dd = glm::dot(ray.direction, ray.direction), md = glm::dot(m, ray.direction);
  const bool leaves = ray.from == self, arrives = ray.to == self;
  if (leaves && arrives) return std::numeric_limits<Length>::infinity();
  if (leaves) return valid(ray, -2 * md / dd);
  const Length mm = glm::dot(m, m) - radius_ * radius_;
  if (arrives) return valid(ray, mm / dd);

  const Length area = cross(m, ray.direction);
  const Length discriminant = dd * radius_ * radius_ - area * area;
  if (discriminant < 0) return std::numeric_limits<Length>::infinity();
  const Length q = -(md + std::copysign(std::sqrt(discriminant), md));
  const Length one = valid(ray, q / dd), other = valid(ray, mm / q);
  return std::min(one, other);
}

template <World W>
SurfacePoint<W> Arc<W>::at(Point q) const {
  const Point outward = glm::normalize(q);
  return {center_ + radius_ * outward, facing_ * outward};
}

template <World W>
SurfacePoint<W> Arc<W>::surface(const Ray<W>& ray, const Hit<W>& hit) const {
  return at(ray.origin + hit.distance * ray.direction - center_);
}

template <World W>
SurfacePoint<W> Arc<W>::sample(typename W::Square u) const {
  const Length angle = start_ + extent_ * Length(u[0]);
  return at({std::cos(angle), std::sin(angle)});
}

template <World W>
typename W::Square Arc<W>::parameter(Point p, PrimitiveId<W>) const {
  const Point q = p - center_;
  Length angle = std::atan2(cross(first_, q), glm::dot(first_, q));
  if (angle < 0) {
    const Length beyond = angle + full_turn<Length>;
    // Just before the start of an open arc is its start, not its end.
    angle = beyond <= extent_ || -angle > beyond - extent_ ? beyond : Length(0);
  }
  const Length u = angle / extent_;
  return {into_unit<typename W::Real>(u)};
}

template <World W>
Box<W> Arc<W>::bounds() const {
  const Point a = center_ + radius_ * first_, b = center_ + radius_ * last_;
  Box<W> box{glm::min(a, b), glm::max(a, b)};
  for (const Point axis : {Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)}) {
    if (!holds(axis)) continue;
    box.low = glm::min(box.low, center_ + radius_ * axis);
    box.high = glm::max(box.high, center_ + radius_ * axis);
  }
  return box;
}

template class Segment<Flatland>;
template class Segment<FlatlandSingle>;
template class Arc<Flatland>;
template class Arc<FlatlandSingle>;

}  // namespace wander

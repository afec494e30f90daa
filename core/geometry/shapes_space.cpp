#include "core/geometry/shapes_space.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/geometry/triangle.h"

namespace wander {

namespace {

template <class T>
constexpr T nothing = std::numeric_limits<T>::infinity();

template <class Real, class Length>
Real to_unit(Length u) {
  return static_cast<Real>(std::clamp(u, Length(0), std::nextafter(Length(1), Length(0))));
}

}  // namespace

template <World W>
Sphere<W>::Sphere(Point center, Length radius, Facing facing)
    : center_(center),
      radius_(radius),
      facing_(facing == Facing::outward ? Length(1) : Length(-1)) {}

template <World W>
auto Sphere<W>::valid(const Ray<W>& ray, Length distance) const -> Length {
  return distance > 0 && distance < ray.limit ? distance : nothing<Length>;
}

// As Arc::intersect: where the ray touches the sphere one root is known, and is divided out.
template <World W>
auto Sphere<W>::intersect(const Ray<W>& ray, Element<W> self) const -> Length {
  const Point m = ray.origin - center_;
  const Length dd = glm::dot(ray.direction, ray.direction), md = glm::dot(m, ray.direction);
  const bool leaves = ray.from == self, arrives = ray.to == self;
  if (leaves && arrives) return nothing<Length>;
  if (leaves) return valid(ray, -2 * md / dd);
  const Length mm = glm::dot(m, m) - radius_ * radius_;
  if (arrives) return valid(ray, mm / dd);

  const Point area = glm::cross(m, ray.direction);
  const Length discriminant = dd * radius_ * radius_ - glm::dot(area, area);
  if (discriminant < 0) return nothing<Length>;
  const Length q = -(md + std::copysign(std::sqrt(discriminant), md));
  return std::min(valid(ray, q / dd), valid(ray, mm / q));
}

template <World W>
SurfacePoint<W> Sphere<W>::at(Point q) const {
  const Point outward = glm::normalize(q);
  return {center_ + radius_ * outward, facing_ * outward};
}

template <World W>
SurfacePoint<W> Sphere<W>::surface(const Ray<W>& ray, const Hit<W>& hit) const {
  return at(ray.origin + hit.distance * ray.direction - center_);
}

// Archimedes: height and azimuth are uniform.
template <World W>
SurfacePoint<W> Sphere<W>::sample(typename W::Square u) const {
  const Length z = 1 - 2 * Length(u[0]), phi = 2 * std::numbers::pi_v<Length> * Length(u[1]);
  const Length sine = std::sqrt(std::max(Length(0), (1 - z) * (1 + z)));
  return at({sine * std::cos(phi), sine * std::sin(phi), z});
}

template <World W>
typename W::Square Sphere<W>::parameter(Point p, PrimitiveId<W>) const {
  const Point q = glm::normalize(p - center_);
  const Length turn = std::atan2(q.y, q.x) / (2 * std::numbers::pi_v<Length>);
  using Real = typename W::Real;
  return {to_unit<Real>((1 - q.z) / 2), to_unit<Real>(turn < 0 ? turn + 1 : turn)};
}

template <World W>
auto Sphere<W>::measure() const -> Length {
  return 4 * std::numbers::pi_v<Length> * radius_ * radius_;
}

template <World W>
Parallelogram<W>::Parallelogram(Point origin, Point edge0, Point edge1)
    : origin_(origin),
      edge0_(edge0),
      edge1_(edge1),
      corners_{origin, origin + edge0, origin + edge0 + edge1, origin + edge1} {
  const Point area = glm::cross(edge0, edge1);
  area_ = glm::length(area);
  normal_ = area / area_;
  dual0_ = glm::cross(edge1, area) / (area_ * area_);
  dual1_ = glm::cross(area, edge0) / (area_ * area_);
}

template <World W>
auto Parallelogram<W>::intersect(const ShearedRay<W>& ray, Element<W> self) const -> Length {
  if (ray.from == self || ray.to == self) return nothing<Length>;
  // The plane costs less than the edges, and often spares them.
  const Length distance =
      glm::dot(origin_ - ray.origin, normal_) / glm::dot(ray.direction, normal_);
  if (!(distance < ray.limit)) return nothing<Length>;
  if (!(distance > 0) && !lies_on_plane<W>(ray.origin, origin_, normal_)) return nothing<Length>;
  const ShearedPoint<W> p(ray, corners_[0]), q(ray, corners_[1]), r(ray, corners_[2]),
      s(ray, corners_[3]);
  const Length a = side_of(p, q), b = side_of(q, r), c = side_of(r, s), d = side_of(s, p);
  if (std::min({a, b, c, d}) < 0 && std::max({a, b, c, d}) > 0) return nothing<Length>;
  return std::max(distance, Length(0));
}

template <World W>
SurfacePoint<W> Parallelogram<W>::surface(const Ray<W>& ray, const Hit<W>& hit) const {
  return {ray.origin + hit.distance * ray.direction, normal_};
}

template <World W>
SurfacePoint<W> Parallelogram<W>::sample(typename W::Square u) const {
  return {origin_ + Length(u[0]) * edge0_ + Length(u[1]) * edge1_, normal_};
}

template <World W>
typename W::Square Parallelogram<W>::parameter(Point p, PrimitiveId<W>) const {
  using Real = typename W::Real;
  return {to_unit<Real>(glm::dot(p - origin_, dual0_)),
          to_unit<Real>(glm::dot(p - origin_, dual1_))};
}

template <World W>
Box<W> Parallelogram<W>::bounds() const {
  const Point far = origin_ + edge0_ + edge1_;
  const Point a = origin_ + edge0_, b = origin_ + edge1_;
  return {glm::min(glm::min(origin_, far), glm::min(a, b)),
          glm::max(glm::max(origin_, far), glm::max(a, b))};
}

template class Sphere<Spaceland>;
template class Sphere<SpacelandColour>;
template class Parallelogram<Spaceland>;
template class Parallelogram<SpacelandColour>;

}  // namespace wander

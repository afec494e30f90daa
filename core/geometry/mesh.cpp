#include "core/geometry/mesh.h"

namespace wander {

namespace {

// The normal of a triangle, and what the second and third corners weigh at a point of it.
template <World W>
struct Mixture {
  typename W::Point own;
  typename W::Length of_b, of_c;
};

template <World W>
Mixture<W> mixture_at(typename W::Point p, typename W::Point a, typename W::Point b,
                      typename W::Point c) {
  const auto area = glm::cross(b - a, c - a);
  const auto size = glm::length(area);
  const auto own = area / size;
  return {own, glm::dot(glm::cross(p - a, c - a), own) / size,
          glm::dot(glm::cross(b - a, p - a), own) / size};
}

}  // namespace

template <World W>
Mesh<W>::Mesh(std::shared_ptr<const Triangles> triangles, Role role)
    : triangles_(std::move(triangles)) {
  for (std::int32_t i = 0; i < primitives(); ++i) {
    const auto [a, b, c] = corners(i);
    measure_ += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  if (role == Role::emitter) share_out();
}

template <World W>
void Mesh<W>::share_out() {
  auto shares = std::make_shared<Shares>();
  const auto count = static_cast<std::size_t>(primitives());
  shares->before.reserve(count + 1);
  Length sum = 0;
  for (std::int32_t i = 0; i < primitives(); ++i) {
    shares->before.push_back(static_cast<double>(sum / measure_));
    const auto [a, b, c] = corners(i);
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  shares->before.push_back(1);
  // The last triangle that begins at or before each step.
  shares->guide.reserve(count);
  std::int32_t last = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(count);
    while (shares->before[static_cast<std::size_t>(last) + 1] <= u) ++last;
    shares->guide.push_back(last);
  }
  shares_ = std::move(shares);
}

// The triangle with before(i) <= u < before(i + 1); one without area has no such u.
template <World W>
std::int32_t Mesh<W>::find(double u) const {
  const auto step = static_cast<std::size_t>(u * static_cast<double>(shares_->guide.size()));
  std::int32_t i = shares_->guide[std::min(step, shares_->guide.size() - 1)];
  while (before(i) > u) --i;  // the step itself may be rounded up
  while (before(i + 1) <= u) ++i;
  return i;
}

template <World W>
SurfacePoint<W> Mesh<W>::with_normal(Point p, std::int32_t primitive) const {
  const auto [a, b, c] = corners(primitive);
  return {p, triangle_normal<W>(a, b, c), primitive};
}

template <World W>
auto Mesh<W>::corner_normal(std::int32_t primitive, std::size_t corner, Point own) const -> Point {
  const auto& of =
      triangles_->normal_corners.empty() ? triangles_->corners : triangles_->normal_corners;
  const std::int32_t index = of[static_cast<std::size_t>(primitive)][corner];
  if (index < 0) return own;
  const auto& n = triangles_->normals[static_cast<std::size_t>(index)];
  const Point normal(n[0], n[1], n[2]);
  return normal == Point(0) ? own : normal;
}

template <World W>
auto Mesh<W>::texture_coordinates(Point p, std::int32_t primitive) const -> std::array<double, 2> {
  const auto [a, b, c] = corners(primitive);
  const auto [own, of_b, of_c] = mixture_at<W>(p, a, b, c);
  const auto& numbers = (triangles_->coordinate_corners.empty()
                             ? triangles_->corners
                             : triangles_->coordinate_corners)[static_cast<std::size_t>(primitive)];
  const auto at = [&](std::size_t corner, std::size_t axis) {
    return triangles_->coordinates[static_cast<std::size_t>(numbers[corner])][axis];
  };
  const auto mixed = [&at, of_b = of_b, of_c = of_c](std::size_t axis) {
    const double first = at(0, axis);
    return static_cast<double>(first + of_b * (at(1, axis) - first) + of_c * (at(2, axis) - first));
  };
  return {mixed(0), mixed(1)};
}

template <World W>
auto Mesh<W>::shading_normal(Point p, std::int32_t primitive) const -> Point {
  const auto [a, b, c] = corners(primitive);
  const auto [own, of_b, of_c] = mixture_at<W>(p, a, b, c);
  const Point mixed = (1 - of_b - of_c) * corner_normal(primitive, 0, own) +
                      of_b * corner_normal(primitive, 1, own) +
                      of_c * corner_normal(primitive, 2, own);
  const Length along = glm::dot(mixed, own);
  if (!(std::abs(along) > 0)) return own;  // they cancel
  return mixed / std::copysign(glm::length(mixed), along);
}

template <World W>
SurfacePoint<W> Mesh<W>::surface(const Ray<W>& ray, const Hit<W>& hit) const {
  const auto [a, b, c] = corners(hit.primitive);
  return with_normal(triangle_point<W>(ray, a, b, c), hit.primitive);
}

template <World W>
SurfacePoint<W> Mesh<W>::sample(Square u) const {
  using Real = typename W::Real;
  const auto chosen = static_cast<double>(u[0]);
  const std::int32_t i = find(chosen);
  const double rest = (chosen - before(i)) / (before(i + 1) - before(i));
  const auto [a, b, c] = corners(i);
  return with_normal(triangle_sample<W>({into_unit<Real>(rest), u[1]}, a, b, c), i);
}

template <World W>
auto Mesh<W>::parameter(Point p, PrimitiveId<W> primitive) const -> Square {
  using Real = typename W::Real;
  const auto [a, b, c] = corners(primitive);
  const auto own = triangle_parameter<W>(p, a, b, c);
  const double low = before(primitive), high = before(primitive + 1);
  const double u = low + std::clamp(static_cast<double>(own[0]), 0.0, 1.0) * (high - low);
  // Rounded up, it would be a number of the next triangle.
  return {into_unit<Real>(std::clamp(u, low, std::nextafter(high, low))), into_unit<Real>(own[1])};
}

template <World W>
Box<W> Mesh<W>::bounds() const {
  Box<W> box = bounds(0);
  for (std::int32_t i = 1; i < primitives(); ++i) {
    const Box<W> other = bounds(i);
    box = {glm::min(box.low, other.low), glm::max(box.high, other.high)};
  }
  return box;
}

template class Mesh<Spaceland>;
template class Mesh<SpacelandColour>;

}  // namespace wander

#include "core/geometry/few_curves.h"

#include <limits>

// The same numbers with the instructions of either processor: the loader chooses.  (clang has no clones of
// what is made of a template; and what chooses would run before ThreadSanitizer is there.)
#if defined(__clang__) || defined(__SANITIZE_THREAD__)
#define WANDER_WIDEST_LANES
#else
#define WANDER_WIDEST_LANES [[gnu::target_clones("avx2", "default")]]
#endif

namespace wander {

template <World W>
FewCurves<W>::FewCurves(std::span<const Shape<W>> shapes) : shapes_(shapes) {
  std::size_t lane = 0;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto* segment = std::get_if<Segment<W>>(&shapes[i]);
    if (segment == nullptr) {
      arcs_.push_back(static_cast<ShapeId>(i));
      continue;
    }
    if (lane == 0) segments_.emplace_back();
    for (std::size_t k = lane; k < width; ++k) {
      Segments& last = segments_.back();
      last.from_x[k] = segment->from().x;
      last.from_y[k] = segment->from().y;
      last.to_x[k] = segment->to().x;
      last.to_y[k] = segment->to().y;
      last.along_x[k] = segment->to().x - segment->from().x;
      last.along_y[k] = segment->to().y - segment->from().y;
      last.slack[k] = segment->slack();
      last.shape[k] = static_cast<Length>(i);
    }
    lane = (lane + 1) % width;
  }
}

// Segment::intersect, without its early ends.
template <World W>
void FewCurves<W>::find(const Segments& segments, const Ray<W>& ray, Lanes& distances) {
  constexpr Length infinity = std::numeric_limits<Length>::infinity();
  const Lanes none = Lanes{} + infinity, zero{};
  const Lanes ax = segments.from_x - ray.origin.x, ay = segments.from_y - ray.origin.y;
  const Lanes bx = segments.to_x - ray.origin.x, by = segments.to_y - ray.origin.y;
  const Lanes side_a = ray.direction.x * ay - ray.direction.y * ax;
  const Lanes side_b = ray.direction.x * by - ray.direction.y * bx;
  const Lanes area = ax * segments.along_y - ay * segments.along_x;
  const Lanes span = ray.direction.x * segments.along_y - ray.direction.y * segments.along_x;
  const Lanes numerator = side_a > zero ? -area : area;
  const Lanes distance = numerator / (span > zero ? span : -span);
  const auto crosses = (side_a > zero) ^ (side_b > zero);
  const auto other = (segments.shape != static_cast<Length>(ray.from.shape)) &
                     (segments.shape != static_cast<Length>(ray.to.shape));
  const auto met = crosses & other & (numerator >= -segments.slack) & (distance < ray.limit);
  distances = met ? (distance < zero ? zero : distance) : none;
}

template <World W>
auto FewCurves<W>::distance(ShapeId arc, const Ray<W>& ray) const -> Length {
  return std::get<Arc<W>>(shapes_[static_cast<std::size_t>(arc)]).intersect(ray, Element<W>(arc));
}

namespace {

template <class Lanes>
double least(const Lanes& lanes) {
  const auto lesser = [](double a, double b) { return a < b ? a : b; };
  return lesser(lesser(lanes[0], lanes[1]), lesser(lanes[2], lanes[3]));
}

}  // namespace

template <World W>
WANDER_WIDEST_LANES Hit<W> FewCurves<W>::closest(const Ray<W>& ray) const {
  Lanes nearest = Lanes{} + std::numeric_limits<Length>::infinity();
  Lanes shape = Lanes{} + static_cast<Length>(no_shape);
  for (const Segments& segments : segments_) {
    Lanes found;
    find(segments, ray, found);
    shape = found < nearest ? segments.shape : shape;
    nearest = found < nearest ? found : nearest;
  }
  Hit<W> hit;
  hit.distance = least(nearest);
  hit.shape = static_cast<ShapeId>(
      least(nearest == hit.distance ? shape : Lanes{} + std::numeric_limits<Length>::infinity()));
  if (arcs_.empty()) return hit;
  Ray<W> shortened = ray;
  shortened.limit = std::min(ray.limit, hit.distance);
  for (const ShapeId arc : arcs_) {
    const Length found = distance(arc, shortened);
    if (found < shortened.limit) {
      shortened.limit = found;
      hit = {arc, found};
    }
  }
  return hit;
}

template <World W>
WANDER_WIDEST_LANES bool FewCurves<W>::any(const Ray<W>& ray) const {
  Lanes nearest = Lanes{} + std::numeric_limits<Length>::infinity();
  for (const Segments& segments : segments_) {
    Lanes found;
    find(segments, ray, found);
    nearest = found < nearest ? found : nearest;
  }
  if (least(nearest) < ray.limit) return true;
  for (const ShapeId arc : arcs_)
    if (distance(arc, ray) < ray.limit) return true;
  return false;
}

template class FewCurves<Flatland>;
template class FewCurves<FlatlandSingle>;

}  // namespace wander

// Every curve of a small scene of the plane, asked one after the other: where there are few, no
// hierarchy is as quick.  Segments are asked four at a time, arcs one by one.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/shape.h"

namespace wander {

template <World W>
class FewCurves {
 public:
  using Universe = W;
  using Length = typename W::Length;
  // Of more curves a hierarchy is quicker.
  static constexpr std::size_t most = 64;

  FewCurves() = default;
  explicit FewCurves(std::span<const Shape<W>> shapes);  // which outlive it

  // Of segments that are met at the same distance, the first of the scene; of arcs, too, if no
  // segment is as near.
  Hit<W> closest(const Ray<W>& ray) const;
  bool any(const Ray<W>& ray) const;

 private:
  static constexpr std::size_t width = 4;
  static_assert(std::same_as<Length, double>);
  using Lanes [[gnu::vector_size(width * sizeof(double))]] = double;
  // Lanes that are left over hold the last segment again.
  struct alignas(sizeof(Lanes)) Segments {
    Lanes from_x{}, from_y{}, to_x{}, to_y{}, along_x{}, along_y{}, slack{};
    Lanes shape{};  // its ShapeId
  };

  [[gnu::always_inline]] static inline void find(const Segments& segments, const Ray<W>& ray,
                                                 Lanes& distances);
  Length distance(ShapeId arc, const Ray<W>& ray) const;

  std::span<const Shape<W>> shapes_;
  std::vector<Segments> segments_;
  std::vector<ShapeId> arcs_;
};

}  // namespace wander

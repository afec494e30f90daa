// What a scene asks of the structure that finds what its rays meet, and which one each dimension
// uses.
#pragma once

#include <concepts>

#include "core/geometry/bvh.h"
#include "core/geometry/few_curves.h"
#include "core/geometry/wide_bvh.h"

namespace wander {

template <class A, class W>
concept Accelerator = std::constructible_from<A, std::span<const Shape<W>>> &&
    requires(const A& accelerator, const Ray<W>& ray) {
  { accelerator.closest(ray) } -> std::same_as<Hit<W>>;
  { accelerator.any(ray) } -> std::same_as<bool>;
};

// Most scenes of the plane are small.
template <World W>
class PlaneAccelerator {
 public:
  PlaneAccelerator() = default;
  explicit PlaneAccelerator(std::span<const Shape<W>> shapes)
      : is_small_(shapes.size() <= FewCurves<W>::most) {
    if (is_small_)
      few_ = FewCurves<W>(shapes);
    else
      many_ = Bvh<W>(shapes);
  }

  Hit<W> closest(const Ray<W>& ray) const {
    return is_small_ ? few_.closest(ray) : many_.closest(ray);
  }
  bool any(const Ray<W>& ray) const { return is_small_ ? few_.any(ray) : many_.any(ray); }

 private:
  bool is_small_ = true;
  FewCurves<W> few_;
  Bvh<W> many_;
};

// The others are for geometry in double.
template <World W, int D = W::dimension, class Length = typename W::Length>
struct AcceleratorOf {
  using Type = Bvh<W>;
};
template <World W>
struct AcceleratorOf<W, 2, double> {
  using Type = PlaneAccelerator<W>;
};
template <World W>
struct AcceleratorOf<W, 3, double> {
  using Type = WideBvh<W>;
};
template <World W>
using SceneAccelerator = typename AcceleratorOf<W>::Type;

}  // namespace wander

// What a scene asks of the structure that finds what its rays meet, and which one each dimension
// uses.
#pragma once

#include <concepts>

#include "core/geometry/bvh.h"
#include "core/geometry/wide_bvh.h"

namespace wander {

template <class A, class W>
concept Accelerator = std::constructible_from<A, std::span<const Shape<W>>> &&
    requires(const A& accelerator, const Ray<W>& ray) {
  { accelerator.closest(ray) } -> std::same_as<Hit<W>>;
  { accelerator.any(ray) } -> std::same_as<bool>;
};

// Scenes of the plane are small; in space most of the time is theirs.
template <World W>
using SceneAccelerator = std::conditional_t<W::dimension == 3, WideBvh<W>, Bvh<W>>;

}  // namespace wander

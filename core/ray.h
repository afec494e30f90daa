// A ray, and what a surface is where a ray meets it.
//
// A ray that leaves a surface, or ends on one, names that surface: it is never hit again where the
// ray touches it (no epsilon, so that a scene multiplied by a power of two behaves bit for bit the
// same).  Distances along a ray are in units of the length of `direction`.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/world.h"

namespace wander {

using ShapeId = std::int32_t;
inline constexpr ShapeId no_shape = -1;  // a point in the open, such as a camera

template <World W>
struct Ray {
  typename W::Point origin;
  typename W::Direction direction;
  ShapeId from = no_shape;  // the shape that the origin lies on
  ShapeId to = no_shape;    // the shape that origin + direction lies on, for connections
  typename W::Length limit = std::numeric_limits<typename W::Length>::infinity();
};

template <World W>
struct SurfacePoint {
  typename W::Point position;
  typename W::Direction normal;  // of unit length, the side that emits and listens
};

template <World W>
struct Hit {
  ShapeId shape = no_shape;
  typename W::Length distance = std::numeric_limits<typename W::Length>::infinity();

  explicit operator bool() const { return shape != no_shape; }
};

// The rays that a computation cast, for a benchmark to cast again alone.
template <World W>
struct RayLog {
  std::vector<Ray<W>> closest, any;
};

}  // namespace wander

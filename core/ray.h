// A ray, and what a surface is where a ray meets it.
//
// A ray that leaves a surface, or ends on one, names that surface: it is never hit again where the
// ray touches it (no epsilon, so that a scene multiplied by a power of two behaves bit for bit the
// same).  Distances along a ray are in units of the length of `direction`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/world.h"

namespace wander {

using ShapeId = std::int32_t;
inline constexpr ShapeId no_shape = -1;  // a point in the open, such as a camera

// Which part of a shape: the triangle of a mesh, 0 where the shape is its only part.  All shapes of
// the plane are, and take no memory to say so.
struct OnlyPart {
  bool operator==(const OnlyPart&) const = default;
};
template <World W>
using PrimitiveId = std::conditional_t<W::dimension == 3, std::int32_t, OnlyPart>;

// What a ray meets, leaves and ends on.
template <World W>
struct Element {
  ShapeId shape = no_shape;
  [[no_unique_address]] PrimitiveId<W> primitive{};

  constexpr Element() = default;
  // Where shapes have parts, a shape alone says too little.
  constexpr explicit(W::dimension == 3) Element(ShapeId of_shape, PrimitiveId<W> part = {})
      : shape(of_shape), primitive(part) {}
  bool operator==(const Element&) const = default;
};

template <World W>
struct Ray {
  typename W::Point origin;
  typename W::Direction direction;
  Element<W> from{};  // what the origin lies on
  Element<W> to{};    // what origin + direction lies on, for connections
  typename W::Length limit = std::numeric_limits<typename W::Length>::infinity();
};

// A ray in space with what every triangle needs of its direction [Woop, Benthin and Wald 2013]: the
// axis z along which it is longest, and the shear and scale that turn the ray into that axis.
template <World W>
struct ShearedRay : Ray<W> {
  using Length = typename W::Length;
  int x, y, z;
  Length shear_x, shear_y, scale;

  ShearedRay(const Ray<W>& ray) : Ray<W>(ray) {
    // Without branches, for directions are as good as random.
    const Length first = std::abs(ray.direction[0]), second = std::abs(ray.direction[1]),
                 third = std::abs(ray.direction[2]);
    constexpr std::array<int, 3> after{1, 2, 0};
    z = std::max(int{second > first}, 2 * int{third > std::max(first, second)});
    x = after[static_cast<std::size_t>(z)];
    y = after[static_cast<std::size_t>(x)];
    scale = 1 / ray.direction[z];
    shear_x = ray.direction[x] * scale;
    shear_y = ray.direction[y] * scale;
  }
};

// A ray as shapes are asked about it.
template <World W>
using ReadyRay = std::conditional_t<W::dimension == 3, ShearedRay<W>, Ray<W>>;

template <World W>
struct SurfacePoint {
  typename W::Point position;
  typename W::Direction normal;  // of unit length, the side that emits and listens
  [[no_unique_address]] PrimitiveId<W> primitive{};
};

template <World W>
struct Hit {
  ShapeId shape = no_shape;
  typename W::Length distance = std::numeric_limits<typename W::Length>::infinity();
  [[no_unique_address]] PrimitiveId<W> primitive{};

  explicit operator bool() const { return shape != no_shape; }
};

// The rays that a computation cast, for a benchmark to cast again alone.
template <World W>
struct RayLog {
  std::vector<Ray<W>> closest, any;
};

}  // namespace wander

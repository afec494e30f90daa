// Points and directions: the only header that includes GLM.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace wander {

template <int D, class T>
using Vec = glm::vec<D, T, glm::defaultp>;

// Quarter turn to the left: the normal of a segment that runs along v.
template <class T>
constexpr Vec<2, T> left_of(Vec<2, T> v) {
  return {-v.y, v.x};
}

// z component of the cross product: twice the signed area of the triangle (0, a, b).
template <class T>
constexpr T cross(Vec<2, T> a, Vec<2, T> b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace wander

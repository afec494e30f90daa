// Bounded functions of a path, with which the invariance of a kernel is tested, and a partition of
// the paths into cells, with which the balance of its flux is.
//
// Lengths are those of a room of about the unit square (test_scenes.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/dimension.h"
#include "core/path.h"

namespace wander::test {

inline constexpr std::size_t film_stripes = 6, length_classes = 4, waves = 6;

// 0 … 3: two, three, four, and more vertices.
inline std::size_t length_class(int vertices) {
  return static_cast<std::size_t>(std::min(vertices, 5) - 2);
}

template <class Space, class W>
std::size_t film_stripe(const Space& space, const Path<W>& x, std::size_t stripes) {
  const double u = static_cast<double>(space.film(x)[0]);
  return std::min(static_cast<std::size_t>(std::max(0.0, u) * static_cast<double>(stripes)),
                  stripes - 1);
}

// Waves across the scene, in one direction and another, of one to a few periods.
template <class Point>
double wave(const Point& p, std::size_t k) {
  constexpr std::array<double, waves> along{7, 3, -8, 15, 1, 25}, across{2, 11, 5, -9, 21, 18};
  return std::cos(along[k] * static_cast<double>(p[0]) + across[k] * static_cast<double>(p[1]) +
                  static_cast<double>(k));
}

// The sine, with a sign, of the angle between the edge from x_i and the normal at vertex v.
template <class W>
double sine_at(const Path<W>& x, int i, int v) {
  using T = typename W::Length;
  const Frame<W::dimension, T> frame{x[v].place.normal};
  return static_cast<double>(frame.to_local(x[i].place.to_sensor)[0]);
}

template <class W>
double shortest_edge(const Path<W>& x) {
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i + 1 < x.size(); ++i)
    shortest = std::min(
        shortest, static_cast<double>(glm::length(x[i + 1].place.position - x[i].place.position)));
  return shortest;
}

// h(x): film stripe by length; waves at the light, before the sensor and in the middle; sines at
// the ends; edges shorter than a bound; number of vertices; how many of them are specular.
inline constexpr std::size_t function_count = film_stripes * length_classes + 3 * waves + 8;
using FunctionValues = std::array<double, function_count>;

template <class Space, class W>
FunctionValues functions_of(const Space& space, const Path<W>& x) {
  FunctionValues h{};
  const int n = x.size();
  h[length_class(n) * film_stripes + film_stripe(space, x, film_stripes)] = 1;
  std::size_t next = film_stripes * length_classes;
  for (const int i : {0, n - 2, n / 2})
    for (std::size_t k = 0; k < waves; ++k) h[next++] = wave(x[i].place.position, k);
  for (const double sine : {sine_at(x, 0, 0), sine_at(x, n - 2, n - 1)}) {
    h[next++] = sine;
    h[next++] = sine * sine;
  }
  const double shortest = shortest_edge(x);
  h[next++] = shortest < 0.05 ? 1 : 0;
  h[next++] = shortest < 0.2 ? 1 : 0;
  h[next++] = n;
  for (int i = 0; i < n; ++i) h[next] += is_specular(x[i].event) ? 1 : 0;
  return h;
}

// Cells: film stripe by length by sign of a wave at the light.
inline constexpr std::size_t cell_count = 2 * length_classes * 2;

template <class Space, class W>
std::size_t cell_of(const Space& space, const Path<W>& x) {
  const std::size_t side = wave(x[0].place.position, 2) > 0 ? 1 : 0;
  return (film_stripe(space, x, 2) * length_classes + length_class(x.size())) * 2 + side;
}

}  // namespace wander::test

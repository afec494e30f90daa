// Functions of a path with values in [0, 1], by which the invariance of a kernel is tested, and a
// partition of the paths into cells, by which the balance of its flux is.
//
// Lengths are in units of the scene's extent, so that the functions of a scene multiplied by a
// power of two are the same to the last bit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "core/dimension.h"
#include "core/geometry/shape.h"
#include "core/path.h"

namespace wander {

// A function or a cell by its number, in words.
std::string name_of_function(std::size_t k);
std::string name_of_cell(std::size_t k);

// Four classes of length: two, three, four, and more vertices.
inline constexpr std::size_t film_stripes = 6, length_classes = 4, waves = 6;
// h(x): film stripe by length; waves at the light, before the sensor and in the middle; sines at
// the ends; edges shorter than a bound; number of vertices; how many of them are specular.
inline constexpr std::size_t function_count = film_stripes * length_classes + 3 * waves + 8;
using FunctionValues = std::array<double, function_count>;
// Cells: half of the film by length by sign of a wave at the light.
inline constexpr std::size_t cell_count = 2 * length_classes * 2;

template <class Space>
class PathFunctions {
 public:
  using W = typename Space::Universe;

  explicit PathFunctions(const Space& space) : space_(space) {
    const Box<W> box = space.scene().bounds();
    low_ = box.low;
    for (int k = 0; k < W::dimension; ++k)
      extent_ = std::max(extent_, static_cast<double>(box.high[k] - box.low[k]));
  }

  FunctionValues values(const Path<W>& x) const {
    FunctionValues h{};
    const int n = x.size();
    h[length_class(n) * film_stripes + film_stripe(x, film_stripes)] = 1;
    std::size_t next = film_stripes * length_classes;
    for (const int i : {0, n - 2, n / 2})
      for (std::size_t k = 0; k < waves; ++k) h[next++] = (1 + wave(x[i].place.position, k)) / 2;
    for (const double sine : {sine_at(x, 0, 0), sine_at(x, n - 2, n - 1)}) {
      h[next++] = (1 + sine) / 2;
      h[next++] = sine * sine;
    }
    const double shortest = shortest_edge(x) / extent_;
    h[next++] = shortest < 0.05 ? 1 : 0;
    h[next++] = shortest < 0.2 ? 1 : 0;
    const double longest = space_.max_vertices();
    h[next++] = n / longest;
    for (int i = 0; i < n; ++i) h[next] += is_specular(x[i].event) ? 1 / longest : 0;
    return h;
  }

  std::size_t cell(const Path<W>& x) const {
    const std::size_t side = wave(x[0].place.position, 0) > 0 ? 1 : 0;
    return (film_stripe(x, 2) * length_classes + length_class(x.size())) * 2 + side;
  }

 private:
  static std::size_t length_class(int vertices) {
    return static_cast<std::size_t>(std::min(vertices, 5) - 2);
  }
  std::size_t film_stripe(const Path<W>& x, std::size_t stripes) const {
    const double u = static_cast<double>(space_.film_position(x)[0]);
    return std::min(static_cast<std::size_t>(std::max(0.0, u) * static_cast<double>(stripes)),
                    stripes - 1);
  }
  // Waves across the scene, in one direction and another, of one to a few periods.
  double wave(const typename W::Point& p, std::size_t k) const {
    constexpr std::array<std::array<double, waves>, 3> along{
        {{7, 3, -8, 15, 1, 25}, {2, 11, 5, -9, 21, 18}, {5, -4, 9, 2, 13, -17}}};
    double phase = static_cast<double>(k);
    for (int axis = 0; axis < W::dimension; ++axis)
      phase += along[static_cast<std::size_t>(axis)][k] *
               (static_cast<double>(p[axis] - low_[axis]) / extent_);
    return std::cos(phase);
  }
  // The sine, with a sign, of the angle between the edge from x_i and the normal at vertex v.
  static double sine_at(const Path<W>& x, int i, int v) {
    const Frame<W::dimension, typename W::Length> frame{x[v].place.normal};
    return std::clamp(static_cast<double>(frame.to_local(x[i].place.to_sensor)[0]), -1.0, 1.0);
  }
  static double shortest_edge(const Path<W>& x) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i + 1 < x.size(); ++i)
      shortest =
          std::min(shortest,
                   static_cast<double>(glm::length(x[i + 1].place.position - x[i].place.position)));
    return shortest;
  }

  const Space& space_;
  typename W::Point low_;
  double extent_ = 0;
};

}  // namespace wander

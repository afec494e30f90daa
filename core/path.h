// A light path: x_0 on a light, x_{n-1} on the sensor, in Veach's order.
//
// With every vertex the path keeps what the densities and the contribution are made of:
//   value        Le(x_0→x_1), f_s(x_{i-1}→x_i→x_{i+1}), We(x_{n-2}→x_{n-1}); of colours, luminance
//   tint         what the colour of value is beside that (tint.h)
//   geometry     G(x_i, x_{i+1}) = V |cos cos'| / r^(D-1), of the edge towards the sensor
//   from_light   density, per unit of area, of sampling x_i from its neighbour on the light's side
//   from_sensor  the same from the sensor's side
// so that, with (s,t) the technique that samples s vertices from the light and t from the sensor,
//   f(x)       = Π value_i Π geometry_i · luminance(Π tint_i)
//   p_{s,t}(x) = Π_{i<s} from_light_i Π_{i>=s} from_sensor_i            [Veach 1997, eq. 10.7-10.9]
// Measure: area product over the vertices that are not specular.
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "core/event.h"
#include "core/ray.h"
#include "core/scaled.h"

namespace wander {

// Where a vertex is.  Pointland has one of its own.
template <class W>
struct Place {
  typename W::Point position{};
  typename W::Direction normal{};
  typename W::Direction to_sensor{};  // unit vector along the edge towards the sensor
  ShapeId shape = no_shape;
  [[no_unique_address]] PrimitiveId<W> primitive{};

  Element<W> element() const { return Element<W>(shape, primitive); }

  template <class Archive>
  void serialize(Archive& archive) {
    for (int k = 0; k < W::dimension; ++k) archive(position[k], normal[k], to_sensor[k]);
    archive(shape);
    if constexpr (!std::is_empty_v<PrimitiveId<W>>) archive(primitive);
  }
};

template <class W>
struct Vertex {
  using Real = typename W::Real;
  typename W::Place place;
  double geometry = 0;
  Real value = 0, from_light = 0, from_sensor = 0;
  Event event = Event::scattering;
  [[no_unique_address]] typename W::Tint tint{};

  template <class Archive>
  void serialize(Archive& archive) {
    archive(place, geometry, value, from_light, from_sensor, event, tint);
  }
};

// Memory is taken once, for the longest path of a scene; no operation below allocates.  Vertices that
// a path grows by are as they were left.
template <class W>
class Path {
 public:
  explicit Path(int max_vertices) : vertices_(static_cast<std::size_t>(max_vertices)) {
    weights_.reserve(static_cast<std::size_t>(max_vertices) + 1);
  }
  Path(const Path& other) : Path(static_cast<int>(other.vertices_.size())) { *this = other; }
  Path(Path&&) = default;
  Path& operator=(Path&&) = default;
  Path& operator=(const Path& other) {
    if (vertices_.size() < other.vertices_.size()) vertices_.resize(other.vertices_.size());
    resize(other.size());
    copy(other, 0, other.size(), 0);
    contribution = other.contribution;
    intensity = other.intensity;
    intensity_under_roulette = other.intensity_under_roulette;
    weights_ = other.weights_;
    return *this;
  }
  ~Path() = default;

  int size() const { return size_; }
  // What a path is made anew in has not been weighed.
  void resize(int n) {
    size_ = n;
    intensity = {};
  }
  Vertex<W>& operator[](int i) { return vertices_[static_cast<std::size_t>(i)]; }
  const Vertex<W>& operator[](int i) const { return vertices_[static_cast<std::size_t>(i)]; }

  // Vertices [first, first + count) of `other`, to `at` here.
  void copy(const Path& other, int first, int count, int at) {
    std::copy_n(other.vertices_.begin() + first, count, vertices_.begin() + at);
  }

  // Kept with the path while it is a state of a chain: f(x), the intensity Σ_s q_s p_{s,t}(x) of a
  // sampler that chooses technique s with probability ∝ q_s, and w_s = q_s p_{s,t} / Σ.
  Scaled contribution;
  Scaled intensity;
  // The same of a sampler whose walks play Russian roulette.
  Scaled intensity_under_roulette;
  bool is_weighed() const { return !intensity.is_zero(); }
  std::vector<double>& weights() { return weights_; }
  const std::vector<double>& weights() const { return weights_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(size_, weights_, contribution, intensity, intensity_under_roulette);
    if (vertices_.size() < static_cast<std::size_t>(size_))
      vertices_.resize(static_cast<std::size_t>(size_));
    for (int i = 0; i < size_; ++i) archive((*this)[i]);
  }

 private:
  std::vector<Vertex<W>> vertices_;
  int size_ = 0;
  std::vector<double> weights_;
};

// What a deposit of luminance 1 on behalf of this path shows: Π tint_i, of luminance 1.
template <class W>
typename W::Tint colour(const Path<W>& x) {
  typename W::Tint product;
  if constexpr (W::Tint::channels > 1)
    for (int i = 0; i < x.size(); ++i) {
      product *= x[i].tint;
      product.normalize();
    }
  return product;
}

// f(x), with respect to the area product.
template <class W>
Scaled contribution(const Path<W>& x) {
  Scaled f = double(x[x.size() - 1].value);
  for (int i = 0; i + 1 < x.size(); ++i) f *= double(x[i].value) * x[i].geometry;
  if constexpr (W::Tint::channels > 1) {
    typename W::Tint product;
    for (int i = 0; i < x.size(); ++i) {
      product *= x[i].tint;
      f *= product.normalize();
    }
  }
  return f;
}

// Such as LDSE: the event of each vertex, light first.
template <class W>
std::string path_class(const Path<W>& x) {
  std::string letters;
  for (int i = 0; i < x.size(); ++i) letters += letter(x[i].event);
  return letters;
}

}  // namespace wander

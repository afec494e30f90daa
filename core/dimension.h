// Everything that differs between light in the plane and light in space.
//
// Radiometry after Jarosz, Schönefeld, Kobbelt and Jensen, "Theory, Analysis and Applications of 2D
// Global Illumination" (TOG 2012); microfacets after Walter et al. 2007 and Heitz 2014.  With D the
// dimension:
//   half_space       ∫ cos θ dω over the hemisphere: 2, π
//   spread(r)        r^(D-1): what a unit of angle covers at distance r
//   reflection       ∂ω_h/∂ω_o = 1 / (2^(D-1) |o·h|^(D-2))
//   ball             uniform points of a unit lens, which has one dimension less
//   ring             offsets of length r in the unit square (a sign; an angle), and how many they are
//   cone             directions at an angle θ from another (two; a circle), and how many they are
//   boundary         of a box with these extents, up to a factor: perimeter, area
//   ggx              density of microfacet normals per unit of angle, ∫ D(h) cos θ_h dω_h = 1
//   *_sample/_invert a map of the unit cube onto directions, and back
// Local vectors have the surface normal as their last axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/vector.h"

namespace wander {

template <int D>
struct Dimension;

// An orthonormal frame with the normal as its last axis.
template <int D, class T>
struct Frame;

template <class T>
struct Frame<2, T> {
  Vec<2, T> normal;

  explicit Frame(Vec<2, T> n) : normal(n) {}
  template <class Edge>
  Frame(Vec<2, T> n, const Edge&) : normal(n) {}

  Vec<2, T> tangent() const { return {normal.y, -normal.x}; }
  Vec<2, T> to_local(Vec<2, T> v) const { return {glm::dot(v, tangent()), glm::dot(v, normal)}; }
  Vec<2, T> to_world(Vec<2, T> v) const { return v.x * tangent() + v.y * normal; }
};

// In space the tangent is z × n.  About ±z, where that is nothing, it is the axis that an edge of the
// surface runs along most nearly; edge() is asked there alone.  So a frame turns with the world where
// that makes a quarter turn about z, bit for bit, as no frame that is made of n alone does.
template <class T>
struct Frame<3, T> {
  Vec<3, T> normal, tangent, bitangent;

  explicit Frame(Vec<3, T> n) : Frame(n, [] { return Vec<3, T>(1, 0, 0); }) {}
  template <class Edge>
  Frame(Vec<3, T> n, const Edge& edge) : normal(n) {
    const T squared_sine = n.x * n.x + n.y * n.y;
    if (squared_sine > std::numeric_limits<T>::min()) [[likely]] {
      const T cosecant = 1 / std::sqrt(squared_sine);
      tangent = {-n.y * cosecant, n.x * cosecant, 0};
      bitangent = {-n.z * tangent.y, n.z * tangent.x, squared_sine * cosecant};
    } else {
      tangent = nearest_axis(edge());
      bitangent = glm::cross(n, tangent);
    }
  }

  Vec<3, T> to_local(Vec<3, T> v) const {
    return {glm::dot(v, tangent), glm::dot(v, bitangent), glm::dot(v, normal)};
  }
  Vec<3, T> to_world(Vec<3, T> v) const { return v.x * tangent + v.y * bitangent + v.z * normal; }

 private:
  // Of ±x and ±y; each takes one of the two diagonals beside it.
  static Vec<3, T> nearest_axis(Vec<3, T> v) {
    if (v.x > v.y && v.x >= -v.y) return {1, 0, 0};
    if (v.y >= v.x && v.y > -v.x) return {0, 1, 0};
    if (v.x < v.y) return {-1, 0, 0};
    return {0, -1, 0};
  }
};

template <>
struct Dimension<2> {
  template <class T>
  static constexpr T half_space = T(2);
  template <class T>
  static T spread(T distance) {
    return distance;
  }
  // cos^(D+1): a unit of film at distance 1 seen through a pinhole (We = 1 / (|film| cos^(D+1))).
  template <class T>
  static T film_spread(T cosine) {
    return cosine * cosine * cosine;
  }
  template <class T>
  static T index_spread(T index) {
    return index;
  }  // n^(D-1)
  template <class T>
  static T boundary(Vec<2, T> extents) {
    return extents.x + extents.y;
  }
  template <class T>
  static T cosine(Vec<2, T> local) {
    return local.y;
  }
  template <class T>
  static T squared_sine(Vec<2, T> local) {
    return local.x * local.x;
  }

  // Uniform points of the unit ball of one dimension less, such as a lens; its measure.
  template <class T>
  static constexpr T ball_measure = T(2);
  template <class T>
  static std::array<T, 1> ball_sample(std::array<T, 1> u) {
    return {2 * u[0] - 1};
  }
  template <class T>
  static std::array<T, 1> ball_invert(std::array<T, 1> p) {
    return {(p[0] + 1) / 2};
  }

  // Density of directions ∝ cos θ: sin θ is uniform.
  template <class T>
  static Vec<2, T> cosine_sample(std::array<T, 1> u) {
    const T sine = 2 * u[0] - 1;
    return {sine, std::sqrt((1 - sine) * (1 + sine))};
  }
  template <class T>
  static std::array<T, 1> cosine_invert(Vec<2, T> local) {
    return {(local.x + 1) / 2};
  }

  template <class T>
  static constexpr T ring_measure(T) {
    return T(2);
  }
  template <class T>
  static std::array<T, 1> ring_offset(T r, T u) {
    return {std::copysign(r, u - T(0.5))};
  }
  template <class T>
  static constexpr T cone_measure(T) {
    return T(2);
  }
  template <class T>
  static Vec<2, T> cone_direction(Vec<2, T> axis, T theta, T u) {
    const T sine = std::copysign(std::sin(theta), u - T(0.5)), cosine = std::cos(theta);
    return {cosine * axis.x - sine * axis.y, sine * axis.x + cosine * axis.y};
  }

  template <class T>
  static T reflection(T) {
    return T(0.5);
  }

  // Marginal of the three-dimensional GGX slopes: P(m) = α²/(2 (α²+m²)^(3/2)), D = P/cos³.
  template <class T>
  static T ggx(T alpha, Vec<2, T> h) {
    const T s = alpha * alpha * h.y * h.y + h.x * h.x;
    return alpha * alpha / (2 * s * std::sqrt(s));
  }

  // Microfacet normals visible from v, density |v·h|⁺ G1(v) D(h) / cos θ_v: stretched by α, the
  // normals fill a half circle whose projection along v is uniform.
  template <class T>
  static Vec<2, T> visible_normal_sample(T alpha, Vec<2, T> v, std::array<T, 1> u) {
    const Vec<2, T> w = glm::normalize(Vec<2, T>(alpha * v.x, v.y));
    const T p = u[0] * (1 + w.y) - w.y;
    const Vec<2, T> h = p * across(w) + std::sqrt(std::max(T(0), 1 - p * p)) * w;
    return glm::normalize(Vec<2, T>(alpha * h.x, std::max(T(0), h.y)));
  }
  template <class T>
  static std::array<T, 1> visible_normal_invert(T alpha, Vec<2, T> v, Vec<2, T> h) {
    const Vec<2, T> w = glm::normalize(Vec<2, T>(alpha * v.x, v.y));
    const Vec<2, T> stretched = glm::normalize(Vec<2, T>(h.x, alpha * h.y));
    return {(glm::dot(stretched, across(w)) + w.y) / (1 + w.y)};
  }

 private:
  // The axis across w on which the half circle reaches from -w.y to 1.
  template <class T>
  static Vec<2, T> across(Vec<2, T> w) {
    return w.x > 0 ? Vec<2, T>(-w.y, w.x) : Vec<2, T>(w.y, -w.x);
  }
};

template <>
struct Dimension<3> {
  template <class T>
  static constexpr T half_space = std::numbers::pi_v<T>;
  template <class T>
  static T spread(T distance) {
    return distance * distance;
  }
  template <class T>
  static T film_spread(T cosine) {
    return (cosine * cosine) * (cosine * cosine);
  }
  template <class T>
  static T index_spread(T index) {
    return index * index;
  }
  template <class T>
  static T boundary(Vec<3, T> e) {
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }
  template <class T>
  static T cosine(Vec<3, T> local) {
    return local.z;
  }
  template <class T>
  static T squared_sine(Vec<3, T> local) {
    return local.x * local.x + local.y * local.y;
  }

  template <class T>
  static constexpr T ball_measure = std::numbers::pi_v<T>;
  template <class T>
  static std::array<T, 2> ball_sample(std::array<T, 2> u) {
    const T radius = std::sqrt(u[0]), phi = 2 * std::numbers::pi_v<T> * u[1];
    return {radius * std::cos(phi), radius * std::sin(phi)};
  }
  template <class T>
  static std::array<T, 2> ball_invert(std::array<T, 2> p) {
    return {p[0] * p[0] + p[1] * p[1], turn(p[0], p[1])};
  }

  // Density of directions ∝ cos θ: a uniform point of the disk, lifted (Malley).
  template <class T>
  static Vec<3, T> cosine_sample(std::array<T, 2> u) {
    const std::array<T, 2> p = ball_sample(u);
    return {p[0], p[1], std::sqrt(1 - u[0])};
  }
  template <class T>
  static std::array<T, 2> cosine_invert(Vec<3, T> local) {
    return ball_invert(std::array<T, 2>{local.x, local.y});
  }

  template <class T>
  static T ring_measure(T r) {
    return 2 * std::numbers::pi_v<T> * r;
  }
  template <class T>
  static std::array<T, 2> ring_offset(T r, T u) {
    const T phi = 2 * std::numbers::pi_v<T> * u;
    return {r * std::cos(phi), r * std::sin(phi)};
  }
  template <class T>
  static T cone_measure(T theta) {
    return 2 * std::numbers::pi_v<T> * std::sin(theta);
  }
  template <class T>
  static Vec<3, T> cone_direction(Vec<3, T> axis, T theta, T u) {
    const std::array<T, 2> p = ring_offset(std::sin(theta), u);
    return Frame<3, T>(axis).to_world({p[0], p[1], std::cos(theta)});
  }

  template <class T>
  static T reflection(T cosine_oh) {
    return 1 / (4 * cosine_oh);
  }

  template <class T>
  static T ggx(T alpha, Vec<3, T> h) {
    const T s = alpha * alpha * h.z * h.z + squared_sine(h);
    return alpha * alpha / (std::numbers::pi_v<T> * s * s);
  }

  // As in the plane; in space the mirror images of the visible normals of a sphere fill a spherical
  // cap evenly (Dupuy and Benyoub 2023).
  template <class T>
  static Vec<3, T> visible_normal_sample(T alpha, Vec<3, T> v, std::array<T, 2> u) {
    const Vec<3, T> w = glm::normalize(Vec<3, T>(alpha * v.x, alpha * v.y, v.z));
    const T phi = 2 * std::numbers::pi_v<T> * u[1], z = (1 - u[0]) * (1 + w.z) - w.z;
    const T sine = std::sqrt(std::clamp((1 - z) * (1 + z), T(0), T(1)));
    const Vec<3, T> h = Vec<3, T>(sine * std::cos(phi), sine * std::sin(phi), z) + w;
    return glm::normalize(Vec<3, T>(alpha * h.x, alpha * h.y, std::max(T(0), h.z)));
  }
  template <class T>
  static std::array<T, 2> visible_normal_invert(T alpha, Vec<3, T> v, Vec<3, T> h) {
    const Vec<3, T> w = glm::normalize(Vec<3, T>(alpha * v.x, alpha * v.y, v.z));
    const Vec<3, T> stretched = glm::normalize(Vec<3, T>(h.x, h.y, alpha * h.z));
    const Vec<3, T> mirrored = 2 * glm::dot(w, stretched) * stretched - w;
    return {1 - (mirrored.z + w.z) / (1 + w.z), turn(mirrored.x, mirrored.y)};
  }

 private:
  // Angle of (x, y) as a fraction of a turn, in [0, 1).
  template <class T>
  static T turn(T x, T y) {
    const T fraction = std::atan2(y, x) / (2 * std::numbers::pi_v<T>);
    return fraction < 0 ? std::min(fraction + 1, std::nextafter(T(1), T(0))) : fraction;
  }
};

}  // namespace wander

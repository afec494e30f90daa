// Colour.  Light is transported by its luminance: densities, sampling and the chains see nothing
// else, and a `value` of a path is one number in every world.  A tint is what colour adds to it,
//
//   colour = luminance · tint,   luminance(tint) = 1   for a light, or for one scattering
//
// so a path has the colour Π value_i geometry_i · Π tint_i, whose luminance is
//
//   f(x) = Π value_i Π geometry_i · luminance(Π tint_i).
//
// With one channel a tint is nothing, and takes no room.  With three it is red, green and blue,
// linear, with the primaries of Rec. 709.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace wander {

// Of the channels of a film; their sum is 1.
inline constexpr std::array<double, 3> luminance_weights{0.2126, 0.7152, 0.0722};

constexpr double luminance(const std::array<double, 3>& colour) {
  return luminance_weights[0] * colour[0] + luminance_weights[1] * colour[1] +
         luminance_weights[2] * colour[2];
}

template <int Channels>
struct Tint;

template <>
struct Tint<1> {
  static constexpr int channels = 1;

  constexpr double operator[](int) const { return 1; }
  constexpr double largest() const { return 1; }
  constexpr Tint& operator*=(Tint) { return *this; }
  constexpr double normalize() { return 1; }
  // Of luminance 1.
  static constexpr Tint of(const std::array<double, 3>&) { return {}; }

  template <class Archive>
  void serialize(Archive&) {}
};

template <>
struct Tint<3> {
  static constexpr int channels = 3;
  std::array<double, 3> colour{1, 1, 1};

  constexpr double operator[](int channel) const {
    return colour[static_cast<std::size_t>(channel)];
  }
  constexpr double largest() const { return std::max({colour[0], colour[1], colour[2]}); }
  constexpr Tint& operator*=(const Tint& other) {
    for (std::size_t k = 0; k < colour.size(); ++k) colour[k] *= other.colour[k];
    return *this;
  }
  // Takes its luminance out, and returns it: products of many tints, each of which has channels up to 13.85 (of
  // pure blue), stay within range, and what they lose of their light is in a factor beside them.
  constexpr double normalize() {
    const double whole = wander::luminance(colour);
    *this = of(colour);
    return whole;
  }
  // Of luminance 1; white if there is no light in it.
  static constexpr Tint of(const std::array<double, 3>& colour) {
    const double whole = wander::luminance(colour);
    if (!(whole > 0)) return {};
    return {{colour[0] / whole, colour[1] / whole, colour[2] / whole}};
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(colour);
  }
};

constexpr double luminance(Tint<1>) { return 1; }
constexpr double luminance(const Tint<3>& tint) { return luminance(tint.colour); }

// How the values of a film lie side by side: the pixels in their order, and of each its channels.
// The shape of a film in colour ends with an axis of three.
inline int channels_of(std::span<const int> film_shape) {
  return film_shape.size() == 3 ? film_shape.back() : 1;
}
inline std::span<const int> pixels_of(std::span<const int> film_shape) {
  return film_shape.first(std::min<std::size_t>(film_shape.size(), 2));
}
inline std::size_t values_of(std::span<const int> film_shape) {
  std::size_t values = 1;
  for (const int extent : film_shape) values *= static_cast<std::size_t>(extent);
  return values;
}
// The part of luminance that a value of a film stands for.
inline double luminance_weight(int channels, std::size_t index) {
  return channels == 3 ? luminance_weights[index % 3] : 1;
}

}  // namespace wander

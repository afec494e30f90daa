// The worlds in which light is transported.  A world fixes the dimension, the precision and the
// channels of colour; all of light transport is written once, for any world.
//
// Positions, directions and distances are never held below double precision (`Length`); scattering,
// densities and sampling use `Real`, so half vectors, refraction and Fresnel's terms, which are
// made of angles, lose nothing where `Real` is float.  What differs between two and three
// dimensions is in dimension.h and nowhere else.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <type_traits>

#include "core/dimension.h"
#include "core/tint.h"
#include "core/vector.h"

namespace wander {

template <class W>
struct Place;  // where a vertex of a path is: path.h

template <int D, std::floating_point R, int Channels = 1>
struct Universe {
  static constexpr int dimension = D, channels = Channels;
  using Real = R;
  using Length = std::conditional_t<std::same_as<R, float>, double, R>;
  using Point = Vec<D, Length>;
  using Direction = Vec<D, Length>;     // of unit length, in the coordinates of the scene
  using Local = Vec<D, Length>;         // the same in a frame whose last axis is the normal
  using Square = std::array<R, D - 1>;  // what a position on a surface, or a direction, is made of
  using Dimension = wander::Dimension<D>;
  using Tint = wander::Tint<Channels>;
  using Place = wander::Place<Universe>;
};

using Flatland = Universe<2, double>;
using FlatlandSingle = Universe<2, float>;
using Spaceland = Universe<3, double>;
using SpacelandColour = Universe<3, double, 3>;

// A coordinate of the unit cube, which is half open, in a precision that may be less: no number
// below 1 is rounded to 1.
template <std::floating_point Real, std::floating_point T>
Real unit_number(T u) {
  if constexpr (std::numeric_limits<Real>::digits >= std::numeric_limits<T>::digits)
    return static_cast<Real>(u);
  else
    return std::min(static_cast<Real>(u), 1 - std::numeric_limits<Real>::epsilon() / 2);
}
// The same for one that rounding may have led out of the cube.
template <std::floating_point Real, std::floating_point T>
Real into_unit(T u) {
  return unit_number<Real>(std::clamp(u, T(0), 1 - std::numeric_limits<T>::epsilon() / 2));
}

template <class W>
concept World = requires {
  { W::dimension } -> std::convertible_to<int>;
  typename W::Real;
  typename W::Length;
  typename W::Point;
  typename W::Dimension;
  typename W::Tint;
};

}  // namespace wander

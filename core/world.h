// The worlds in which light is transported.  A world fixes the dimension and the precision; all of
// light transport is written once, for any world.
//
// Positions, directions and distances are never held below double precision (`Length`); scattering,
// densities and sampling use `Real`.  What differs between two and three dimensions is in
// dimension.h and nowhere else.
#pragma once

#include <array>
#include <concepts>
#include <type_traits>

#include "core/dimension.h"
#include "core/vector.h"

namespace wander {

template <class W>
struct Place;  // where a vertex of a path is: path.h

template <int D, std::floating_point R>
struct Universe {
  static constexpr int dimension = D;
  using Real = R;
  using Length = std::conditional_t<std::same_as<R, float>, double, R>;
  using Point = Vec<D, Length>;
  using Direction = Vec<D, Length>;     // of unit length, in the coordinates of the scene
  using Local = Vec<D, R>;              // of unit length, in a frame whose last axis is the normal
  using Square = std::array<R, D - 1>;  // what a position on a surface, or a direction, is made of
  using Dimension = wander::Dimension<D>;
  using Place = wander::Place<Universe>;
};

using Flatland = Universe<2, double>;
using Spaceland = Universe<3, double>;

template <class W>
concept World = requires {
  { W::dimension } -> std::convertible_to<int>;
  typename W::Real;
  typename W::Length;
  typename W::Point;
  typename W::Dimension;
};

}  // namespace wander

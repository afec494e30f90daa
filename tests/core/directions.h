// Directions of either dimension for tests: as points of the unit cube, for χ² tests, and by angle.
// Local directions have the normal as their last axis.
#pragma once

#include <cmath>
#include <numbers>

#include "core/world.h"
#include "tests/support/chi_square.h"
#include "tests/support/generator.h"

namespace wander::test {

// What a unit of the cube covers of all directions: 2π, 4π.
template <int D>
constexpr double all_directions = (D == 2 ? 2 : 4) * std::numbers::pi;

template <int D>
CubePoint<D - 1> cube_of(const Vec<D, double>& w) {
  if constexpr (D == 2)
    return cube_of_direction(w.x, w.y);
  else
    return cube_of_direction(w.x, w.y, w.z);
}

template <int D>
Vec<D, double> direction_of(const CubePoint<D - 1>& u) {
  if constexpr (D == 2) {
    const auto [x, y] = direction_on_circle(u);
    return {x, y};
  } else {
    const auto [x, y, z] = direction_on_sphere(u);
    return {x, y, z};
  }
}

// At this angle from the normal; in space, of some azimuth that is on no axis.
template <int D>
Vec<D, double> local_at(double angle, double azimuth = 0.7) {
  if constexpr (D == 2)
    return {std::sin(angle), std::cos(angle)};
  else
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
            std::cos(angle)};
}

template <int D>
std::array<double, D - 1> random_square(Generator& generator) {
  std::array<double, D - 1> u{};
  for (double& x : u) x = generator.uniform();
  return u;
}

// Uniform over all directions, for properties that must hold everywhere.
template <int D>
Vec<D, double> random_direction(Generator& generator) {
  return direction_of<D>(random_square<D>(generator));
}

// ∫ f dω over all directions.  The cut in two at the equator is where densities break.
template <int D, class Function>
double integral_over_directions(const Function& f, Accuracy accuracy) {
  const auto of_cube = [&](const CubePoint<D - 1>& u) { return f(direction_of<D>(u)); };
  Box<D - 1> low, high;
  low.low.fill(0), low.high.fill(1), high = low;
  low.high[D - 2] = high.low[D - 2] = 0.5;
  return all_directions<D> *
         (integral<D - 1>(of_cube, low, accuracy) + integral<D - 1>(of_cube, high, accuracy));
}

// In space fewer and coarser cells: what is tested is the same formula.
template <int D>
ChiSquareOptions direction_options() {
  if constexpr (D == 2) return {};
  return {.cells_per_axis = 15, .samples = 100'000, .integral = {.absolute = 1e-7, .depth = 7}};
}

}  // namespace wander::test

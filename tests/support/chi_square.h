// A sampler against its density: Pearson's χ² between the histogram of what sample() draws and the
// integral of density() over each cell, after the practice of Mitsuba's and Nori's tests.
//
// Points live in the unit cube [0, 1]^N, N = 1 or 2, and the density is with respect to its volume.
// The caller brings other spaces there by a map of constant Jacobian, so that no factor can hide:
//   circle   u = angle / 2π + 1/2          density_cube = 2π density_angle
//   sphere   u = (azimuth / 2π + 1/2, (1 + z) / 2)   density_cube = 4π density_solid_angle
// A sampler may fail (std::nullopt): its density then integrates to less than 1, and failures are
// one more cell of the histogram.
//
// Beyond χ², these fail at once: a point outside the cube or where the density is zero, a negative
// or non-finite density, a density that integrates to more than 1.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/quadrature.h"
#include "tests/support/statistics.h"

namespace wander::test {

template <std::size_t N>
using CubePoint = std::array<double, N>;

// Draws a point of the cube, or fails.
template <class F, std::size_t N>
concept CubeSampler = requires(F& sample) {
  { sample() } -> std::convertible_to<std::optional<CubePoint<N>>>;
};
template <class F, std::size_t N>
concept CubeDensity = requires(const F& density, const CubePoint<N>& x) {
  { density(x) } -> std::convertible_to<double>;
};

struct ChiSquareOptions {
  // Odd counts keep the edges of cells off the symmetric places where densities break.
  std::size_t cells_per_axis = 31;
  std::size_t samples = 200'000;
  double false_alarm = usual_false_alarm;
  double mass_tolerance = 1e-4;  // by which the density may exceed a total of 1
  // Per cell; it must be small against 1 / (samples · cells).  A density that jumps in a dimension
  // of two is bisected along the jump to `depth`.
  Accuracy integral{.absolute = 1e-9, .depth = 9};
};

inline CubePoint<1> cube_of_direction(double x, double y) {
  return {std::atan2(y, x) / (2 * std::numbers::pi) + 0.5};
}
inline CubePoint<2> cube_of_direction(double x, double y, double z) {
  return {std::atan2(y, x) / (2 * std::numbers::pi) + 0.5, 0.5 * (1 + z)};
}
inline std::array<double, 2> direction_on_circle(const CubePoint<1>& u) {
  const double angle = 2 * std::numbers::pi * (u[0] - 0.5);
  return {std::cos(angle), std::sin(angle)};
}
inline std::array<double, 3> direction_on_sphere(const CubePoint<2>& u) {
  const double azimuth = 2 * std::numbers::pi * (u[0] - 0.5);
  const double z = 2 * u[1] - 1;
  const double ring = 2 * std::sqrt(u[1] * (1 - u[1]));  // √(1 - z²) without cancellation
  return {ring * std::cos(azimuth), ring * std::sin(azimuth), z};
}

// A regular grid of cells over the cube.
template <std::size_t N>
struct CellGrid {
  std::size_t per_axis;

  std::size_t count() const {
    std::size_t product = 1;
    for (std::size_t d = 0; d < N; ++d) product *= per_axis;
    return product;
  }

  std::optional<std::size_t> cell_of(const CubePoint<N>& x) const {
    std::size_t cell = 0;
    for (std::size_t d = N; d-- > 0;) {
      if (!(x[d] >= 0 && x[d] <= 1)) return std::nullopt;  // NaN too
      const auto along = static_cast<std::size_t>(x[d] * static_cast<double>(per_axis));
      cell = cell * per_axis + std::min(along, per_axis - 1);
    }
    return cell;
  }

  Box<N> box_of(std::size_t cell) const {
    Box<N> box;
    const auto n = static_cast<double>(per_axis);
    for (std::size_t d = 0; d < N; ++d, cell /= per_axis) {
      const auto i = static_cast<double>(cell % per_axis);
      box.low[d] = i / n;
      box.high[d] = (i + 1) / n;
    }
    return box;
  }
};

// Either counts per cell with the failures last, or what was wrong with a sample.
struct SampledCells {
  std::vector<double> counts;
  std::string fault;
};

template <std::size_t N, CubeSampler<N> Sample, CubeDensity<N> Density>
SampledCells sample_cells(const CellGrid<N>& grid, Sample&& sample, const Density& density,
                          std::size_t samples) {
  SampledCells result{std::vector<double>(grid.count() + 1, 0.0), {}};
  for (std::size_t i = 0; i < samples; ++i) {
    const std::optional<CubePoint<N>> x = sample();
    if (!x) {
      ++result.counts.back();
      continue;
    }
    const std::optional<std::size_t> cell = grid.cell_of(*x);
    const double here = cell ? static_cast<double>(density(*x)) : 0.0;
    if (cell && std::isfinite(here) && here > 0) {
      ++result.counts[*cell];
      continue;
    }
    std::ostringstream text;
    text << "sample " << i << " at (";
    for (const double coordinate : *x) text << ' ' << coordinate;
    text << " )" << (cell ? " where the density is " : " lies outside the cube");
    if (cell) text << here;
    result.fault = text.str();
    return result;
  }
  return result;
}

// The probability of each cell; the failures, last, have what is missing to 1.
template <std::size_t N, CubeDensity<N> Density>
std::vector<double> cell_probabilities(const CellGrid<N>& grid, const Density& density,
                                       Accuracy accuracy) {
  std::vector<double> probabilities(grid.count() + 1);
  double total = 0;
  for (std::size_t cell = 0; cell < grid.count(); ++cell)
    total += probabilities[cell] = integral<N>(density, grid.box_of(cell), accuracy);
  probabilities.back() = 1 - total;
  return probabilities;
}

template <std::size_t N, CubeSampler<N> Sample, CubeDensity<N> Density>
Decision sampler_matches_density(Sample&& sample, const Density& density,
                                 const ChiSquareOptions& options = {}) {
  const CellGrid<N> grid{options.cells_per_axis};
  Decision failed{.test = "χ² of a sampler", .p_value = 0, .false_alarm = options.false_alarm};
  const SampledCells cells = sample_cells(grid, sample, density, options.samples);
  failed.detail = cells.fault;
  if (!cells.fault.empty()) return failed;

  std::vector<double> expected = cell_probabilities(grid, density, options.integral);
  const double missing = expected.back();
  if (!(missing >= -options.mass_tolerance)) {
    failed.detail = "the density integrates to " + std::to_string(1 - missing);
    return failed;
  }
  // Rounding of the integral around 1 is no probability of failing.
  if (std::abs(missing) <= options.mass_tolerance && cells.counts.back() == 0) expected.back() = 0;
  expected.back() = std::max(0.0, expected.back());
  for (double& value : expected) value *= static_cast<double>(options.samples);
  Decision decision = chi_square_test(cells.counts, expected, options.false_alarm);
  decision.test = "χ² of a sampler";
  return decision;
}

}  // namespace wander::test

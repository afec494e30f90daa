// Pilots of given ratios, and what a choice of the border between samples and chains costs by one, summed anew (partition.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "mlt/run/partition.h"

namespace wander::test {

// Of each ratio, so many paths.
inline Pilot pilot_of(std::initializer_list<std::pair<double, int>> paths,
                      double samples = 10'000) {
  Pilot pilot{.samples = samples,
              .rays = wander::rays_per_step * samples / 2};  // two cost as much as a step
  for (const auto& [ratio, count] : paths)
    for (int i = 0; i < count; ++i) pilot.found.add(ratio);
  return pilot;
}
inline constexpr std::size_t bins_of_pilot = 100;

// What a pilot without states says of a border and its τ: parts of V, and V_b.
struct Work {
  double parts, total;
};
inline Work work(const Pilot& pilot, Partition side, double steps, double rho) {
  const RatioHistogram found = pilot.found.without_largest();
  double all = 0, samples = 0, chains = 0, hard = 0;
  for (int i = found.first(); i < found.end(); ++i) all += found[i].sum;
  const double b = pilot.b();
  for (int i = found.first(); i < found.end(); ++i) {
    const auto [count, sum] = found[i];
    if (count == 0) continue;
    const double l = sum / count, light = b * sum / all;
    const double w_M = l / (l + side.c) / (1 + l / side.end);
    samples += light * l * std::pow(1 - w_M, 2) / rho;
    chains += light * std::pow(w_M, 2);
    hard += light * w_M;
  }
  const double spread = steps * (b * chains - hard * hard);
  return {samples + steps * b * chains,
          (samples + spread) / (bins_of_pilot * std::pow(1 - hard / b, 2))};
}
// V (1 + ρ κ)
inline double work(const Pilot& pilot, const Pooling& with) {
  double least = INFINITY, parts = 0;
  std::vector<Pilot::Border> borders = pilot.borders;
  if (borders.empty())
    for (const double c : borders_around(pilot.b())) borders.push_back({.c = c});
  for (const Pilot::Border& border : borders) {
    const Work of = work(pilot, border.side(), border.steps_per_draw, with.samples_per_step);
    least = std::min(least, of.total);
    if (border.c == with.partition.c && border.end == with.partition.end) parts = of.parts;
  }
  return (parts + least) * (1 + with.samples_per_step / 2);
}

// All there is, the fewest samples first.
inline std::vector<Pooling> all_choices(const Pilot& pilot) {
  std::vector<Pooling> all;
  for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2)
    for (const double c : borders_around(pilot.b()))
      if (rho == fewest_samples_per_step || rho / 2 <= usual_most_cost) all.push_back({{c}, rho});
  return all;
}

}  // namespace wander::test

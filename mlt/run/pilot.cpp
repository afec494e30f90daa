#include "mlt/run/pilot.h"

#include <cmath>
#include <vector>

namespace wander {

std::uint64_t seed_of_pilot(std::uint64_t seed) {
  // Knuth's multiplicative hash: another seed, far from those that are near this one.
  return (seed ^ 0x70696C6F74) * 0x9E3779B97F4A7C15;
}

double steps_per_draw(std::span<const GroupFindings> groups, std::uint64_t steps) {
  std::vector<double> sums(groups.front().film->bins()), squares(sums.size());
  double count = 0;
  for (const GroupFindings& group : groups) {
    double mass = 0;
    for (std::size_t j = 0; j < sums.size(); ++j) mass += group.film->weight(j);
    if (!(mass > 0)) continue;
    ++count;
    for (std::size_t j = 0; j < sums.size(); ++j) {
      const double share = group.film->weight(j) / mass;
      sums[j] += share;
      squares[j] += share * share;
    }
  }
  if (count < 2) return Pilot{}.steps_per_draw;
  double spread = 0, even = 0;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const double p = sums[j] / count;
    spread += (squares[j] - count * p * p) / (count - 1);
    even += p * (1 - p);
  }
  if (!(even > 0)) return 1;
  const auto n = static_cast<double>(steps);
  // x by halving the octaves in which it may lie: R falls with x.
  double low = 0.5, high = 2 * n;
  while (high / low > 1.001) {
    const double x = std::sqrt(low * high);
    (2 * (x - 1 + std::exp(-x)) > spread / even * x * x ? low : high) = x;
  }
  return 2 * n / std::sqrt(low * high);
}

Pilot pilot_of(std::span<const GroupFindings> groups, double rays, std::uint64_t steps) {
  Pilot pilot{.rays = rays};
  for (const GroupFindings& group : groups) {
    pilot.samples += static_cast<double>(group.seeds->samples);
    for (const RatioHistogram& stratum : group.evidence->ratios) pilot.found.add(stratum, 1);
    for (const StateRatios& stratum : group.states)
      pilot.states.add(*stratum.ratios, stratum.weight);
  }
  if (steps > 0) pilot.steps_per_draw = steps_per_draw(groups, steps);
  return pilot;
}

}  // namespace wander

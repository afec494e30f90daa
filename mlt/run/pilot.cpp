#include "mlt/run/pilot.h"

#include <utility>
#include <vector>

namespace wander {

std::uint64_t seed_of_pilot(std::uint64_t seed) {
  // Knuth's multiplicative hash: another seed, far from those that are near this one.
  return (seed ^ 0x70696C6F74) * 0x9E3779B97F4A7C15;
}

double steps_per_draw_of_film(std::span<const GroupFindings> groups, std::uint64_t steps) {
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
  return even > 0 ? steps_per_draw(spread / even, static_cast<double>(steps)) : 1;
}

Pilot pilot_of(std::span<const GroupFindings> groups, double rays, std::uint64_t steps) {
  Pilot pilot{.rays = rays};
  for (const GroupFindings& group : groups) {
    pilot.samples += static_cast<double>(group.seeds->samples);
    for (const RatioHistogram& stratum : group.evidence->ratios) pilot.found.add(stratum, 1);
    RatioHistogram states;
    for (const StateRatios& stratum : group.states) states.add(*stratum.ratios, stratum.weight);
    if (states.count() > 0) pilot.states.push_back(std::move(states));
  }
  if (steps == 0) return pilot;
  pilot.steps = static_cast<double>(steps);
  pilot.steps_per_draw = steps_per_draw_of_film(groups, steps);
  return pilot;
}

}  // namespace wander

#include "mlt/run/pilot.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wander {

std::uint64_t seed_of_pilot(std::uint64_t seed) {
  // Knuth's multiplicative hash: another seed, far from those that are near this one.
  return (seed ^ 0x70696C6F74) * 0x9E3779B97F4A7C15;
}

double steps_per_draw(std::span<const GroupFindings> groups, std::size_t border,
                      const RatioHistogram& states, std::uint64_t steps) {
  std::vector<double> sums(groups.front().film->bins()), squares(sums.size());
  double count = 0;
  for (const GroupFindings& group : groups) {
    double mass = 0;
    for (std::size_t j = 0; j < sums.size(); ++j) mass += group.film->weight(j);
    if (!(mass > 0)) continue;
    ++count;
    const GroupFilm& film = group.parts[border].of_chains();
    for (std::size_t j = 0; j < sums.size(); ++j) {
      const double share = film.weight(j) / mass;
      sums[j] += share;
      squares[j] += share * share;
    }
  }
  if (count < 2) return usual_steps_per_draw;
  const Partition& side = groups.front().parts[border].partition();
  double spread = 0, second_moment = 0;
  for (int i = states.first(); i < states.end(); ++i)
    if (const auto [number, sum] = states[i]; number > 0)
      second_moment += number * std::pow(side.of_chains(sum / number), 2) / states.count();
  double of_draw = second_moment;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const double mean = sums[j] / count;
    spread += (squares[j] - count * mean * mean) / (count - 1);
    of_draw -= mean * mean;
  }
  // Where all paths have one weight and one bin nothing differs but by rounding.
  const bool differs = of_draw > 1e-9 * second_moment;
  return steps_per_draw(differs ? spread / of_draw : 0, static_cast<double>(steps));
}

Pilot pilot_of(std::span<const GroupFindings> groups, double rays, std::uint64_t steps) {
  Pilot pilot{.rays = rays};
  for (const GroupFindings& group : groups) {
    pilot.samples += static_cast<double>(group.seeds->samples);
    for (const RatioHistogram& stratum : group.evidence->ratios) pilot.found.add(stratum, 1);
    for (const StateRatios& stratum : group.states)
      pilot.states.add(*stratum.ratios, stratum.weight);
  }
  pilot.steps_per_chain = static_cast<double>(steps);
  if (steps == 0) return pilot;
  const std::span<const PooledParts> parts = groups.front().parts;
  for (std::size_t k = 0; k < parts.size(); ++k)
    pilot.borders.push_back(
        {parts[k].partition().c, steps_per_draw(groups, k, pilot.states, steps)});
  return pilot;
}

namespace {

// The share of the chains' part of the light that samples found and chains have not come to.
double unvisited(const Pilot& pilot, Partition side) {
  double by_states = 0, by_samples = 0, found = 0;
  for (int i = pilot.states.first(); i < pilot.states.end(); ++i)
    if (const auto [number, sum] = pilot.states[i]; number > 0)
      by_states += number * side.of_chains(sum / number);
  for (int i = pilot.found.first(); i < pilot.found.end(); ++i)
    if (const auto [number, sum] = pilot.found[i]; number > 0) {
      by_samples += sum * side.of_chains(sum / number);
      found += sum;
    }
  if (!(by_samples > 0)) return 0;
  return 1 - by_states / pilot.states.count() / (by_samples / found);
}

}  // namespace

Pilot extrapolated(const Pilot& early, const Pilot& late, double steps_per_chain) {
  constexpr double noise = 0.25;
  Pilot pilot = late;
  const double so_far = std::log(late.steps_per_chain / early.steps_per_chain);
  const double to_come = std::log(std::max(1.0, steps_per_chain / late.steps_per_chain));
  if (!(so_far > 0)) return pilot;
  for (std::size_t k = 0; k < pilot.borders.size(); ++k) {
    auto& [c, tau] = pilot.borders[k];
    const double grown = std::log(tau / early.borders[k].steps_per_draw) / so_far;
    const double power = std::max(grown, unvisited(late, {c}));
    tau *= std::exp(std::clamp((power - noise) / (1 - noise), 0.0, 1.0) * to_come);
  }
  return pilot;
}

}  // namespace wander

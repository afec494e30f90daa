#include "mlt/run/pilot.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wander {

std::uint64_t seed_of_pilot(std::uint64_t seed) {
  // Knuth's multiplicative hash: another seed, far from those that are near this one.
  return (seed ^ 0x70696C6F74) * 0x9E3779B97F4A7C15;
}

namespace {

// Σ over bins of the variance between groups, and of the square of their mean.
class Spread {
 public:
  explicit Spread(std::size_t bins) : sums_(bins), squares_(bins) {}

  void add(std::size_t bin, double share) {
    sums_[bin] += share;
    squares_[bin] += share * share;
  }
  double variance(double count) const {
    double sum = 0;
    for (std::size_t j = 0; j < sums_.size(); ++j)
      sum += (squares_[j] - sums_[j] * sums_[j] / count) / (count - 1);
    return sum;
  }
  double squared_mean(double count) const {
    double sum = 0;
    for (const double s : sums_) sum += s * s / (count * count);
    return sum;
  }

 private:
  std::vector<double> sums_, squares_;
};

// Where all paths have one weight and one bin nothing differs but by rounding.
double steps_of(double spread, double of_draw, double second_moment, std::uint64_t steps) {
  const bool differs = of_draw > 1e-9 * second_moment;
  return steps_per_draw(differs ? spread / of_draw : 0, static_cast<double>(steps));
}

}  // namespace

Pilot::Border border_of(std::span<const GroupFindings> groups, std::size_t border,
                        const RatioHistogram& states, std::uint64_t steps) {
  const Partition& side = groups.front().parts[border].partition();
  Spread film(groups.front().film->bins()), total(1);
  double count = 0;
  for (const GroupFindings& group : groups) {
    double mass = 0, sum = 0;
    for (std::size_t j = 0; j < group.film->bins(); ++j) mass += group.film->weight(j);
    if (!(mass > 0)) continue;
    ++count;
    const GroupFilm& part = group.parts[border].of_chains();
    for (std::size_t j = 0; j < part.bins(); ++j) {
      film.add(j, part.weight(j) / mass);
      sum += part.weight(j) / mass;
    }
    total.add(0, sum);
  }
  if (count < 2) return {side.c, usual_steps_per_draw, usual_steps_per_draw};
  double mean = 0, second_moment = 0;  // of w_M
  for (int i = states.first(); i < states.end(); ++i)
    if (const auto [number, sum] = states[i]; number > 0) {
      const double weight = side.of_chains(sum / number);
      mean += number * weight / states.count();
      second_moment += number * weight * weight / states.count();
    }
  return {side.c,
          steps_of(film.variance(count), second_moment - film.squared_mean(count), second_moment,
                   steps),
          steps_of(total.variance(count), second_moment - mean * mean, second_moment, steps)};
}

Pilot pilot_of(std::span<const GroupFindings> groups, double rays, std::uint64_t steps) {
  Pilot pilot{.rays = rays};
  for (const GroupFindings& group : groups) {
    pilot.samples += static_cast<double>(group.seeds->samples);
    for (const RatioHistogram& stratum : group.evidence->ratios) pilot.found.add(stratum, 1);
    RatioHistogram& chain = pilot.chains.emplace_back();
    for (const StateRatios& stratum : group.states) chain.add(*stratum.ratios, stratum.weight);
  }
  pilot.steps_per_chain = static_cast<double>(steps);
  if (steps == 0) return pilot;
  const std::span<const PooledParts> parts = groups.front().parts;
  const RatioHistogram states = pilot.states();
  for (std::size_t k = 0; k < parts.size(); ++k)
    pilot.borders.push_back(border_of(groups, k, states, steps));
  return pilot;
}

namespace {

// The light of the chains' part: as states say it, and as samples do but for the one that found most.
struct HardLight {
  double by_states = 0, by_samples = 0;
};
HardLight hard_light(const Pilot& pilot, Partition side) {
  HardLight light;
  double found = 0;
  const RatioHistogram states = pilot.states(), samples = pilot.found.without_largest();
  for (int i = states.first(); i < states.end(); ++i)
    if (const auto [number, sum] = states[i]; number > 0)
      light.by_states += number * side.of_chains(sum / number) / states.count();
  for (int i = samples.first(); i < samples.end(); ++i)
    if (const auto [number, sum] = samples[i]; number > 0) {
      light.by_samples += sum * side.of_chains(sum / number);
      found += sum;
    }
  if (found > 0) light.by_samples /= found;
  return light;
}

// What is above the noise of a pilot.
double above_noise(double share) {
  constexpr double noise = 0.25;
  return std::clamp((share - noise) / (1 - noise), 0.0, 1.0);
}

// What samples found beyond a border and chains did not.
double unvisited(const Pilot& pilot, Partition side) {
  constexpr double fewest = 0.05;
  const HardLight hard = hard_light(pilot, side);
  if (hard.by_samples < fewest) return 0;
  return above_noise(1 - hard.by_states / hard.by_samples) * hard.by_samples;
}

}  // namespace

Pilot extrapolated(const Pilot& early, const Pilot& late, double steps_per_chain) {
  Pilot pilot = late;
  pilot.steps_per_chain = std::max(steps_per_chain, usual_steps_per_draw);
  // Of a budget of time there may have been none for an early pilot.
  const bool has_grown = !early.borders.empty() && late.steps_per_chain > early.steps_per_chain;
  const double so_far = has_grown ? std::log(late.steps_per_chain / early.steps_per_chain) : 0;
  const double to_come = std::log(std::max(1.0, steps_per_chain / late.steps_per_chain));
  double not_seen = 0;  // beyond this border or another after it
  for (std::size_t k = pilot.borders.size(); k-- > 0;) {
    Pilot::Border& border = pilot.borders[k];
    for (double Pilot::Border::*which :
         {&Pilot::Border::steps_per_draw, &Pilot::Border::steps_per_draw_of_total}) {
      double& tau = border.*which;
      const double power = has_grown ? std::log(tau / early.borders[k].*which) / so_far : 0;
      tau = std::min(tau * std::exp(above_noise(power) * to_come), pilot.steps_per_chain);
    }
    not_seen = std::max(not_seen, unvisited(late, {border.c}));
    border.unvisited = not_seen;
  }
  return pilot;
}

}  // namespace wander

#include "mlt/run/pilot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mlt/run/deposit_spread.h"
#include "mlt/run/sample_spread.h"

namespace wander {

std::uint64_t seed_of_pilot(std::uint64_t seed) {
  // Knuth's multiplicative hash: another seed, far from those that are near this one.
  return (seed ^ 0x70696C6F74) * 0x9E3779B97F4A7C15;
}

namespace {

// Where all paths have one weight and one bin nothing differs but by rounding.
double steps_of(double spread, double of_draw, double second_moment, std::uint64_t steps) {
  const bool differs = of_draw > 1e-9 * second_moment;
  return steps_per_draw(differs ? spread / of_draw : 0, static_cast<double>(steps));
}

// Σ weight(bin) w_M over the cells of a histogram.
template <class Weight>
double hard_part(const RatioHistogram& ratios, Partition side, Weight&& weight) {
  double part = 0;
  for (int i = ratios.first(); i < ratios.end(); ++i)
    if (const RatioHistogram::Bin bin = ratios[i]; bin.count > 0)
      part += weight(bin) * side.of_chains(bin.sum / bin.count);
  return part;
}

double hard_states(const RatioHistogram& states, Partition side) {
  return hard_part(states, side, [](const auto& bin) { return bin.count; });
}

// How evenly the chains share what they know of the hard light.
double evenness_of_states(const Pilot& pilot, Partition side) {
  std::vector<double> of_chains;
  for (const RatioHistogram& chain : pilot.chains)
    if (chain.count() > 0) of_chains.push_back(hard_states(chain, side));
  return evenness(of_chains);
}

}  // namespace

std::vector<Pilot::Border> borders_of(std::span<const TrialFindings> groups, const BinWorth& worth,
                                      const Pilot& pilot, std::span<const Partition> borders,
                                      const std::function<bool()>& is_over) {
  const std::vector<DepositSpread> spreads = deposit_spreads(groups, worth, borders);
  const std::vector<double> together = paths_together(groups, worth, borders, is_over);
  const RatioHistogram states = pilot.states();
  const auto steps = static_cast<std::uint64_t>(pilot.steps_per_chain);
  const bool is_long = pilot.steps_in_all >= static_cast<double>(steps_of_long_pilot);
  std::vector<Pilot::Border> found;
  for (std::size_t k = 0; k < borders.size(); ++k) {
    found.push_back({.c = borders[k].c, .end = borders[k].end, .together = together[k]});
    if (spreads.empty()) continue;
    const Partition side = borders[k];
    double mean = 0, second_moment = 0;  // of w_M
    for (int i = states.first(); i < states.end(); ++i)
      if (const auto [number, sum] = states[i]; number > 0) {
        const double weight = side.of_chains(sum / number);
        mean += number * weight / states.count();
        second_moment += number * weight * weight / states.count();
      }
    const DepositSpread& spread = spreads[k];
    const auto variance =
        is_long ? &DepositSpread::Variance::of_all : &DepositSpread::Variance::but_for_one;
    if (is_long) found[k].evenness = std::max(spread.evenness, evenness_of_states(pilot, side));
    found[k].steps_per_draw =
        steps_of(spread.film.*variance, second_moment - spread.squared_mean, second_moment, steps);
    found[k].steps_per_draw_of_total =
        steps_of(spread.total.*variance, second_moment - mean * mean, second_moment, steps);
  }
  return found;
}

namespace {

// What samples found, but for the path that has most of it.
RatioHistogram weighed_samples(std::span<const TrialFindings> groups, const BinWorth& worth) {
  const TrialLog::Found* largest = nullptr;
  double most = 0;
  for (const TrialFindings& group : groups)
    for (const TrialLog::Found& path : group.log->found)
      if (const double light = worth(path.bin) * path.light; light > most) {
        most = light;
        largest = &path;
      }
  RatioHistogram found;
  for (const TrialFindings& group : groups)
    for (const TrialLog::Found& path : group.log->found)
      if (&path != largest) found.add(path.ratio, worth(path.bin) * path.light / path.ratio);
  return found;
}

}  // namespace

Pilot pilot_of(std::span<const TrialFindings> groups, const BinWorth& worth, PilotSteps steps,
               const std::function<bool()>& is_over) {
  Pilot pilot{.steps_per_chain = static_cast<double>(steps.so_far),
              .steps_in_all = static_cast<double>(steps.in_all)};
  for (const TrialFindings& group : groups) {
    pilot.samples += group.log->samples;
    pilot.rays += group.rays;
    for (const TrialLog::Found& path : group.log->found)
      pilot.found.add(path.ratio, path.light / path.ratio);
    RatioHistogram& chain = pilot.chains.emplace_back();
    for (const TrialLog::State& state : group.log->states)
      chain.add(state.ratio, worth(state.bin) * group.light_of_states[state.stratum]);
  }
  if (!worth.is_even()) pilot.weighed = weighed_samples(groups, worth);
  const FilmKind film = worth.is_even() ? FilmKind::curve : FilmKind::image;
  if (steps.so_far > 0)
    pilot.borders = borders_of(groups, worth, pilot, partitions_around(pilot.b(), film), is_over);
  return pilot;
}

namespace {

// The share of the light that is the chains': as states say it, and as samples do but for the one that found
// most.
struct HardLight {
  double by_states = 0, by_samples = 0;
};
HardLight hard_light(const Pilot& pilot, Partition side) {
  const RatioHistogram states = pilot.states(), samples = pilot.light_of_samples();
  const auto light = [](const auto& bin) { return bin.sum; };
  const double found = hard_part(samples, {}, light);
  HardLight share;
  if (states.count() > 0) share.by_states = hard_states(states, side) / states.count();
  if (found > 0) share.by_samples = hard_part(samples, side, light) / found;
  return share;
}

// What is above the noise of a pilot.
double above_noise(double share, double noise = 0.25) {
  return std::clamp((share - noise) / (1 - noise), 0.0, 1.0);
}

// What samples found beyond a border and chains did not, or few of them did.
double unvisited(const Pilot& pilot, const Pilot::Border& border) {
  constexpr double fewest = 0.05;
  const HardLight hard = hard_light(pilot, border.side());
  if (hard.by_samples < fewest) return 0;
  constexpr double noise_between_chains = 0.5;
  return std::max(above_noise(1 - hard.by_states / hard.by_samples),
                  above_noise(1 - border.evenness, noise_between_chains)) *
         hard.by_samples;
}

}  // namespace

Pilot extrapolated(const Pilot& early, const Pilot& late, double steps_per_chain) {
  Pilot pilot = late;
  pilot.steps_per_chain = std::max(steps_per_chain, usual_steps_per_draw);
  // Of a budget of time there may have been none for an early pilot.
  const bool has_grown = !early.borders.empty() && late.steps_per_chain > early.steps_per_chain;
  const double so_far = has_grown ? std::log(late.steps_per_chain / early.steps_per_chain) : 0;
  const double to_come = std::log(std::max(1.0, steps_per_chain) / late.steps_per_chain);
  double not_seen = 0;  // beyond this border or another after it
  for (std::size_t k = pilot.borders.size(); k-- > 0;) {
    Pilot::Border& border = pilot.borders[k];
    for (double Pilot::Border::*which :
         {&Pilot::Border::steps_per_draw, &Pilot::Border::steps_per_draw_of_total}) {
      double& tau = border.*which;
      const double power = has_grown ? std::log(tau / early.borders[k].*which) / so_far : 0;
      tau = std::min(tau * std::exp(above_noise(power) * to_come), pilot.steps_per_chain);
    }
    border.unvisited = unvisited(late, border);
    if (border.side().has_end()) continue;
    border.unvisited = not_seen = std::max(not_seen, border.unvisited);
  }
  return pilot;
}

}  // namespace wander

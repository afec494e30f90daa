#include "mlt/run/partition.h"

#include <limits>

namespace wander {

namespace {

constexpr double enough_effective_samples = 64;

// Σ over the cells of a histogram of f(number of paths, their l).
template <class F>
double sum(const RatioHistogram& ratios, F&& f) {
  double total = 0;
  for (int i = ratios.first(); i < ratios.end(); ++i) {
    const RatioHistogram::Bin bin = ratios[i];
    if (bin.count > 0) total += f(bin.count, bin.sum / bin.count);
  }
  return total;
}

double light(const Pilot& pilot) {
  return sum(pilot.found, [](double paths, double l) { return paths * l; }) / pilot.samples;
}

// b E_π[g(l)]
template <class G>
double light_times(const Pilot& pilot, G&& g) {
  if (pilot.states.count() > 0)
    return light(pilot) *
           sum(pilot.states, [&](double states, double l) { return states * g(l); }) /
           pilot.states.count();
  return sum(pilot.found, [&](double paths, double l) { return paths * l * g(l); }) / pilot.samples;
}

// V(ρ)
double variance(const Pilot& pilot, const Pooling& with, std::size_t bins) {
  const Partition& side = with.partition;
  const double b = light(pilot);
  const double of_samples =
      light_times(pilot, [&](double l) { return l * side.of_samples(l) * side.of_samples(l); }) /
      with.samples_per_step;
  const double of_chains =
      light_times(pilot, [&](double l) { return side.of_chains(l) * side.of_chains(l); });
  const double easy = light_times(pilot, [&](double l) { return side.of_samples(l); });
  return of_samples + pilot.steps_per_draw * b * of_chains +
         b * b * of_samples / (static_cast<double>(bins) * easy * easy);
}

}  // namespace

bool is_telling(const Pilot& pilot) {
  const double all = sum(pilot.found, [](double paths, double l) { return paths * l; });
  const double squares = sum(pilot.found, [](double paths, double l) { return paths * l * l; });
  return squares > 0 && all * all / squares >= enough_effective_samples;
}

Pooling pooling(const Pilot& pilot, double samples_per_step) {
  if (pilot.samples == 0) return {.samples_per_step = samples_per_step};
  return {.partition = {light(pilot) * samples_per_step * pilot.steps_per_draw},
          .samples_per_step = samples_per_step,
          .steps_per_draw = pilot.steps_per_draw,
          .cost_of_sample = pilot.rays / pilot.samples / rays_per_step};
}

Pooling best_pooling(const Pilot& pilot, std::size_t bins) {
  Pooling best = pooling(pilot, fewest_samples_per_step);
  if (!is_telling(pilot)) return best;
  double least = std::numeric_limits<double>::infinity();
  const double cost = best.cost_of_sample;
  for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2) {
    if (rho > fewest_samples_per_step && rho * cost > most_cost) break;
    const Pooling tried = pooling(pilot, rho);
    const double work = variance(pilot, tried, bins) * (1 + rho * cost);
    if (work < least) {
      least = work;
      best = tried;
    }
  }
  return best;
}

}  // namespace wander

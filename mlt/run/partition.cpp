#include "mlt/run/partition.h"

#include <limits>

namespace wander {

namespace {

constexpr double enough_effective_samples = 64;

// f(number of paths per sample, their l) for all cells of the histogram.
template <class F>
void for_each_cell(const Pilot& pilot, F&& f) {
  for (int i = pilot.ratios.first(); i < pilot.ratios.end(); ++i) {
    const RatioHistogram::Bin bin = pilot.ratios[i];
    if (bin.count > 0) f(bin.count / pilot.samples, bin.sum / bin.count);
  }
}

double light(const Pilot& pilot) {
  double b = 0;
  for_each_cell(pilot, [&](double paths, double l) { b += paths * l; });
  return b;
}

// V(ρ)
double variance(const Pilot& pilot, const Pooling& with, std::size_t bins) {
  double of_samples = 0, of_chains = 0, easy = 0;
  for_each_cell(pilot, [&](double paths, double l) {
    const double w_B = with.partition.of_samples(l), w_M = with.partition.of_chains(l);
    of_samples += paths * l * w_B * l * w_B / with.samples_per_step;
    of_chains += paths * l * w_M * w_M;
    easy += paths * l * w_B;
  });
  const double b = light(pilot);
  return of_samples + steps_per_draw * b * of_chains +
         b * b * of_samples / (static_cast<double>(bins) * easy * easy);
}

}  // namespace

bool is_telling(const Pilot& pilot) {
  double sum = 0, squares = 0;
  for_each_cell(pilot, [&](double paths, double l) {
    sum += paths * l;
    squares += paths * l * l;
  });
  return squares > 0 && sum * sum / squares * pilot.samples >= enough_effective_samples;
}

Pooling pooling(const Pilot& pilot, double samples_per_step) {
  return {{light(pilot) * samples_per_step * steps_per_draw}, samples_per_step};
}

Pooling best_pooling(const Pilot& pilot, std::size_t bins) {
  Pooling best = pooling(pilot, fewest_samples_per_step);
  if (!is_telling(pilot)) return best;
  double least = std::numeric_limits<double>::infinity();
  const double cost = pilot.rays / pilot.samples / rays_per_step;
  for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2) {
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

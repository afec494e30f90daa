#include "mlt/run/partition.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wander {

namespace {

constexpr double enough_effective_samples = 64;
constexpr double smallest_border = 0x1p-4, largest_border = 0x1p24;  // over b

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
template <class G>
double mean(const RatioHistogram& states, G&& g) {
  return sum(states, [&](double count, double l) { return count * g(l); }) / states.count();
}

// What V is made of.
class Variance {
 public:
  Variance(const Pilot& pilot, std::size_t bins) : pilot_(pilot), bins_(static_cast<double>(bins)) {
    b_ = sum(pilot.found, [](double paths, double l) { return paths * l; }) / pilot.samples;
    for (const RatioHistogram& states : pilot.states) states_.add(states, 1);
  }

  double b() const { return b_; }
  // V(ρ, c)
  double of(const Partition& side, double samples_per_step) const {
    const auto samples = [&](double l) { return side.of_samples(l); };
    const auto chains = [&](double l) { return side.of_chains(l); };
    const double of_samples =
        light_times([&](double l) { return l * samples(l) * samples(l); }) / samples_per_step;
    const double of_chains = light_times([&](double l) { return chains(l) * chains(l); });
    const double easy = light_times(samples);
    return of_samples + steps_per_draw(side) * b_ * of_chains +
           b_ * b_ * of_samples / (bins_ * easy * easy);
  }
  // τ
  double steps_per_draw(const Partition& side) const {
    return std::max(pilot_.steps_per_draw, steps_per_draw_of_hard_light(side));
  }

 private:
  // b E_π[g(l)]
  template <class G>
  double light_times(G&& g) const {
    if (states_.count() > 0) return b_ * mean(states_, g);
    return sum(pilot_.found, [&](double paths, double l) { return paths * l * g(l); }) /
           pilot_.samples;
  }
  // By how the chains differ in the mean of w_M.
  double steps_per_draw_of_hard_light(const Partition& side) const {
    if (pilot_.states.size() < 2) return 0;
    const auto chains = [&](double l) { return side.of_chains(l); };
    double sum = 0, squares = 0;
    for (const RatioHistogram& states : pilot_.states) {
      const double hard = mean(states, chains);
      sum += hard;
      squares += hard * hard;
    }
    const double n = static_cast<double>(pilot_.states.size());
    const double spread = (squares - sum * sum / n) / (n - 1), all = mean(states_, chains);
    const double of_draw =
        mean(states_, [&](double l) { return chains(l) * chains(l); }) - all * all;
    return wander::steps_per_draw(of_draw > 0 ? spread / of_draw : 0, pilot_.steps);
  }

  const Pilot& pilot_;
  double bins_, b_ = 0;
  RatioHistogram states_;
};

struct Choice {
  Pooling pooling;
  double work = std::numeric_limits<double>::infinity();
};

Choice best_border(const Pilot& pilot, const Variance& variance, double samples_per_step) {
  const double cost = pilot.rays / pilot.samples / rays_per_step;
  Choice best{.pooling = {.samples_per_step = samples_per_step, .cost_of_sample = cost}};
  for (double c = smallest_border; c <= largest_border; c *= 2) {
    const Partition side{c * variance.b()};
    const double work = variance.of(side, samples_per_step) * (1 + samples_per_step * cost);
    if (!(work < best.work)) continue;
    best.work = work;
    best.pooling.partition = side;
    best.pooling.steps_per_draw = variance.steps_per_draw(side);
  }
  return best;
}

}  // namespace

double steps_per_draw(double variance_ratio, double steps) {
  // x by halving the octaves in which it may lie: R falls with x.
  double low = 0.5, high = 2 * steps;
  while (high / low > 1.001) {
    const double x = std::sqrt(low * high);
    (2 * (x - 1 + std::exp(-x)) > variance_ratio * x * x ? low : high) = x;
  }
  return 2 * steps / std::sqrt(low * high);
}

bool is_telling(const Pilot& pilot) {
  const double all = sum(pilot.found, [](double paths, double l) { return paths * l; });
  const double squares = sum(pilot.found, [](double paths, double l) { return paths * l * l; });
  return squares > 0 && all * all / squares >= enough_effective_samples;
}

Pooling pooling(const Pilot& pilot, double samples_per_step, std::size_t bins) {
  const Variance variance(pilot, bins);
  if (!(variance.b() > 0) || !(samples_per_step > 0)) return {.samples_per_step = samples_per_step};
  return best_border(pilot, variance, samples_per_step).pooling;
}

Pooling best_pooling(const Pilot& pilot, std::size_t bins) {
  if (!is_telling(pilot)) return pooling(pilot, fewest_samples_per_step, bins);
  const Variance variance(pilot, bins);
  Choice best;
  for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2) {
    const Choice tried = best_border(pilot, variance, rho);
    if (rho > fewest_samples_per_step && rho * tried.pooling.cost_of_sample > most_cost) break;
    if (tried.work < best.work) best = tried;
  }
  return best.pooling;
}

}  // namespace wander

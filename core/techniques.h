// Techniques (s,t): s vertices sampled from the light, t = n - s from the sensor, and one edge that
// connects them; s = 0 and t = 0 hit a light or the sensor by chance.  Their densities are products
// over the vertices (path.h), so neighbours differ by one ratio,
//   p_{s+1,t-1} / p_{s,t} = from_light_s / from_sensor_s,
// and all weights of a path take linear time [Veach 1997, 10.2].
#pragma once

#include <limits>
#include <span>

#include "core/path.h"

namespace wander {

// The techniques that an estimator combines: a rectangle in (s,t).
struct TechniqueSet {
  static constexpr int any = std::numeric_limits<int>::max();
  int fewest_light = 0, most_light = any;
  int fewest_sensor = 0, most_sensor = any;

  bool holds(int s, int t) const {
    return s >= fewest_light && s <= most_light && t >= fewest_sensor && t <= most_sensor;
  }
  bool operator==(const TechniqueSet&) const = default;
};

inline constexpr TechniqueSet all_techniques{};

// Can technique s sample this path?  A vertex whose direction is fixed by its neighbour cannot be
// connected to, and a camera cannot be hit.
template <class Space, class W>
bool can_sample(const Space& space, const Path<W>& x, int s, const TechniqueSet& set) {
  const int n = x.size();
  if (!set.holds(s, n - s)) return false;
  if (s == 0) return true;
  if (s == n) return space.sensor_can_be_hit();
  return space.can_connect(x[s - 1]) && space.can_connect(x[s]);
}

// How many techniques make paths of n vertices: s = 0 … n - 1, and n where the sensor can be hit.
template <class Space>
int technique_count(const Space& space, int n) {
  return space.sensor_can_be_hit() ? n + 1 : n;
}

// Multiple importance sampling [Veach 1997, 9.2]: w_s ∝ p_s^β, with β = 1 the balance heuristic and
// β = 2 the power heuristic.
enum class Heuristic { balance, power };

inline double raised(double ratio, Heuristic heuristic) {
  return heuristic == Heuristic::balance ? ratio : ratio * ratio;
}

// p_{s,t}(x), with respect to the area product.
template <class W>
Scaled technique_density(const Path<W>& x, int s) {
  Scaled p = 1;
  for (int i = 0; i < x.size(); ++i) p *= double(i < s ? x[i].from_light : x[i].from_sensor);
  return p;
}

// Σ_s w_s q_s, where under Russian roulette the walks of technique s, which go on at all vertices but
// the two that are joined, come to their ends with probability
//   q_s = Π_{i != s-1, s} albedo_i.
template <class Space, class W>
Scaled survival(const Space& space, const Path<W>& x, std::span<const double> weights) {
  Scaled all = 1;
  double sum = 0, before = 1;  // of x_{s-1}
  for (int s = 0; s <= x.size(); ++s) {
    const double here = s < x.size() ? double(space.albedo(x[s])) : 1;
    sum += weights[static_cast<std::size_t>(s)] / (before * here);
    all *= before = here;
  }
  return all * Scaled(sum);
}

// weigh() product by product: where a walk from the sensor could not have come, as by a material that
// scatters one way only, p_{s+1} / p_s is no number.
template <class Space, class W>
void weigh_by_products(const Space& space, Path<W>& x) {
  const int n = x.size();
  auto& weights = x.weights();
  Scaled sum;
  for (int s = 0; s <= n; ++s)
    if (can_sample(space, x, s, all_techniques)) sum += technique_density(x, s);
  for (int s = 0; s <= n; ++s)
    weights[static_cast<std::size_t>(s)] =
        can_sample(space, x, s, all_techniques) ? (technique_density(x, s) / sum).value() : 0;
  x.intensity = sum;
  x.intensity_under_roulette = sum * survival(space, x, weights);
}

// Writes f(x), the intensity Σ_s p_{s,t}(x) over the techniques of a sampler that gives each the
// same chance, without roulette and under it, and the balance weights w_s = p_{s,t} / Σ, s = 0…n,
// into the path.
template <class Space, class W>
void weigh(const Space& space, Path<W>& x) {
  const int n = x.size();
  x.contribution = contribution(x);
  auto& weights = x.weights();  // until the sum is known, the ratios p_{s+1} / p_s
  weights.resize(static_cast<std::size_t>(n) + 1);
  const Scaled first = technique_density(x, 0);
  if (first.is_zero()) return weigh_by_products(space, x);
  Scaled p = first, sum;
  for (int s = 0; s < n; ++s) {
    if (can_sample(space, x, s, all_techniques)) sum += p;
    p *= weights[static_cast<std::size_t>(s)] = double(x[s].from_light) / double(x[s].from_sensor);
  }
  if (can_sample(space, x, n, all_techniques)) sum += p;
  x.intensity = sum;
  p = first / sum;
  for (int s = 0; s <= n; ++s) {
    const double ratio = weights[static_cast<std::size_t>(s)];
    weights[static_cast<std::size_t>(s)] = can_sample(space, x, s, all_techniques) ? p.value() : 0;
    if (s < n) p *= ratio;
  }
  x.intensity_under_roulette = sum * survival(space, x, weights);
}

}  // namespace wander

#include "lab/film_pool.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wander {

namespace {

double squared(double x) { return x * x; }

// Squares of films lit by 1e200 W would overflow: they are formed in units of the largest value.
double unit_of(const std::vector<double>& values) {
  double unit = 0;
  for (const double value : values) unit = std::max(unit, std::abs(value));
  return unit > 0 ? unit : 1;
}

std::vector<double> weights_of(std::span<const Rendering> runs) {
  std::vector<double> weights;
  for (const Rendering& run : runs) weights.push_back(static_cast<double>(run.samples));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

// Variances of the mean, per bin, in squared units.
struct Spread {
  std::vector<double> claimed, observed;
};

Spread spread_of(std::span<const Rendering> runs, const std::vector<double>& weights,
                 const std::vector<double>& mean, double unit) {
  Spread spread{std::vector<double>(mean.size()), std::vector<double>(mean.size())};
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t b = 0; b < mean.size(); ++b) {
      const FilmEstimate& film = runs[i].film;
      spread.claimed[b] += squared(weights[i] * film.standard_error[b] / unit);
      if (runs.size() > 1)
        spread.observed[b] += weights[i] * squared((film.value[b] - mean[b]) / unit) /
                              static_cast<double>(runs.size() - 1);
    }
  return spread;
}

std::vector<double> errors_of(const Spread& spread) {
  double claimed = 0, observed = 0, bins_observed = 0;
  for (std::size_t b = 0; b < spread.claimed.size(); ++b) {
    bins_observed += spread.observed[b];
    if (!std::isfinite(spread.claimed[b])) continue;
    claimed += spread.claimed[b];
    observed += spread.observed[b];
  }
  const double factor = claimed > 0 ? std::max(1.0, observed / claimed) : 1;
  const double of_unknown = bins_observed / static_cast<double>(spread.claimed.size());
  std::vector<double> errors;
  for (const double c : spread.claimed)
    errors.push_back(std::sqrt(std::isfinite(c) ? factor * c : of_unknown));
  return errors;
}

}  // namespace

FilmEstimate pooled_film(std::span<const Rendering> runs) {
  FilmEstimate pool = runs.front().film;
  pool.by_length.clear();
  if (runs.size() == 1) return pool;
  const std::vector<double> weights = weights_of(runs);
  pool.value.assign(pool.value.size(), 0.0);
  pool.reliable.assign(pool.value.size(), true);
  pool.degrees_of_freedom = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const FilmEstimate& film = runs[i].film;
    pool.degrees_of_freedom += film.degrees_of_freedom;
    for (std::size_t b = 0; b < pool.value.size(); ++b) {
      pool.value[b] += weights[i] * film.value[b];
      pool.reliable[b] = pool.reliable[b] && film.reliable[b];
    }
  }
  const double unit = unit_of(pool.value);
  pool.standard_error = errors_of(spread_of(runs, weights, pool.value, unit));
  for (double& error : pool.standard_error) error *= unit;
  return pool;
}

}  // namespace wander

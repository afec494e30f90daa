// Films with error bars by path length, for tests: what an estimator finds, sample by sample, and
// the decisions that hold it against exact values or against another estimator.
#pragma once

#include <cmath>
#include <map>
#include <numeric>
#include <string_view>
#include <vector>

#include "core/rng.h"
#include "lab/estimate.h"
#include "tests/support/statistics.h"

namespace wander::test {

// Mean irradiance of a bin, or mean radiance, with one standard deviation.
struct BinValue {
  double value = 0, error = 0;
};
using BinValues = std::vector<BinValue>;

struct SampledFilm {
  BinValues total;
  std::map<int, BinValues> by_vertices;  // every length, also those that nothing was found of
  BinValue mean;                         // over the film
};

inline const Estimator& find_estimator(std::string_view name) {
  for (const Estimator& e : estimators())
    if (name == e.name) return e;
  throw std::invalid_argument("no such estimator");
}

// Σ and Σ² per bin over samples; zero samples need not be told.
class BinSums {
 public:
  explicit BinSums(std::size_t bins) : current_(bins), sum_(bins), squares_(bins) {}

  void add(std::size_t bin, double value) { current_[bin] += value; }
  void end_sample() {
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      if (current_[i] == 0) continue;
      sum_[i] += current_[i];
      squares_[i] += current_[i] * current_[i];
      current_[i] = 0;
    }
  }
  BinValues values(double samples) const {
    BinValues values;
    const auto bins = static_cast<double>(sum_.size());
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      const double mean = sum_[i] / samples;
      const double variance = std::max(0.0, squares_[i] / samples - mean * mean) / (samples - 1);
      values.push_back({bins * mean, bins * std::sqrt(variance)});
    }
    return values;
  }

 private:
  std::vector<double> current_, sum_, squares_;
};

// `Space` is a Transport, or a wrong twin of one.
template <class Space>
SampledFilm sample_film_in(const Space& space, TechniqueSet techniques, Heuristic heuristic,
                           int samples, std::uint64_t seed) {
  using W = typename Space::Universe;
  PathSampler<Space> sampler(space, techniques, heuristic);
  const auto bins = static_cast<std::size_t>(space.scene().bins());
  BinSums total(bins), mean(1);
  std::vector<BinSums> by_vertices(static_cast<std::size_t>(space.max_vertices()) - 1,
                                   BinSums(bins));
  Rng rng(seed, Purpose::test, 0);
  for (int i = 0; i < samples; ++i) {
    rng.start(static_cast<std::uint64_t>(i));
    sampler.sample(rng, [&](const Path<W>& path, int, double weighted) {
      const auto bin = static_cast<std::size_t>(space.bin(path));
      total.add(bin, weighted);
      mean.add(0, weighted);
      by_vertices[static_cast<std::size_t>(path.size()) - 2].add(bin, weighted);
    });
    total.end_sample();
    mean.end_sample();
    for (BinSums& sums : by_vertices) sums.end_sample();
  }
  SampledFilm film{total.values(samples), {}, mean.values(samples).front()};
  for (std::size_t k = 0; k < by_vertices.size(); ++k)
    film.by_vertices[static_cast<int>(k) + 2] = by_vertices[k].values(samples);
  return film;
}

template <class W>
SampledFilm sample_film(const Scene<W>& scene, const Estimator& estimator, int samples,
                        std::uint64_t seed) {
  return sample_film_in(Transport<W>(scene, estimator.roulette), estimator.techniques,
                        estimator.heuristic, samples, seed);
}

// z of an estimate; where there is no spread, the value must be exact.
inline double z_of(BinValue estimate, double exact) {
  const double off = estimate.value - exact;
  if (estimate.error > 0) return off / estimate.error;
  return std::abs(off) <= 1e-12 * std::abs(exact) ? 0 : std::numeric_limits<double>::infinity();
}

inline Compared compared(BinValue estimate, double exact) {
  return {z_of(estimate, exact), estimate.error, std::abs(exact)};
}

inline Decision matches(const BinValues& film, const std::vector<double>& exact,
                        double false_alarm = usual_false_alarm) {
  std::vector<Compared> family;
  for (std::size_t i = 0; i < film.size(); ++i) family.push_back(compared(film[i], exact.at(i)));
  return largest_z_test(family, false_alarm);
}

// Appends the comparisons of two independent films, bin by bin: errors are relative to the mean of both.
// Where one of the two found nothing, the other must not have found it with certainty either.
inline void append_differences(std::vector<Compared>& family, const BinValues& a,
                               const BinValues& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double error = std::hypot(a[i].error, b[i].error);
    family.push_back(
        {z_of({a[i].value - b[i].value, error}, 0), error, std::abs(a[i].value + b[i].value) / 2});
  }
}

// Two films agree, by length and in total.
inline Decision agree(const SampledFilm& a, const SampledFilm& b,
                      double false_alarm = usual_false_alarm) {
  std::vector<Compared> family;
  append_differences(family, a.total, b.total);
  for (const auto& [n, film] : a.by_vertices) append_differences(family, film, b.by_vertices.at(n));
  return largest_z_test(family, false_alarm);
}

}  // namespace wander::test

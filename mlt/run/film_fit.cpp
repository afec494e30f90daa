#include "mlt/run/film_fit.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "mlt/run/coarse_films.h"
#include "mlt/run/factor_fit.h"
#include "mlt/run/smoothed_film.h"
#include "statistics/jackknife.h"
#include "statistics/squared.h"
#include "work/parallel.h"

namespace wander {

namespace {

using Film = std::vector<double>;

// The variance of a residual may not be less than this part of the mean over the bins.
constexpr double smallest_variance = 1e-3;
// Neighbouring bins are taken together until Σ Var p / Σ p² is no more than this, and than this part of the seed pass's
// relative error, or there are no fewer bins.
constexpr double most_noise = 0.005, most_noise_of_error = 0.25;
constexpr std::size_t fewest_bins = 4;
// Pairs of groups are left out whose numbers are 1, 3, 5 or 7 apart.
constexpr std::size_t most_apart = 8;

double mean_of(const Film& film) {
  double sum = 0;
  for (const double value : film) sum += value;
  return sum / static_cast<double>(film.size());
}

// The groups of a fit that are left out: none, one, or two.
struct LeftOut {
  static constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
  std::size_t first = nobody, second = nobody;
};
constexpr LeftOut none;

// The groups whose number is even, or odd: what is summed over them, with some left out.
class Films {
 public:
  Films(std::span<const FilmFitGroup> groups, std::span<const int> shape)
      : groups_(groups), shape_(shape), bins_(groups.front().found.size()), deposits_(bins_) {
    for (std::size_t parity : {0u, 1u}) found_[parity].assign(bins_, 0);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      samples_[g % 2] += groups[g].samples;
      for (std::size_t j = 0; j < bins_; ++j) {
        found_[g % 2][j] += groups[g].found[j];
        deposits_[j] += groups[g].deposits[j];
      }
    }
  }

  // Mean per bin of the samples of a half, so that the mean over the bins is b.
  Film found(std::size_t half, LeftOut left_out) const {
    double n = samples_[half];
    Film film = found_[half];
    for (const std::size_t g : {left_out.first, left_out.second}) {
      if (g == LeftOut::nobody || g % 2 != half) continue;
      n -= groups_[g].samples;
      for (std::size_t j = 0; j < bins_; ++j) film[j] -= groups_[g].found[j];
    }
    for (double& value : film) value *= static_cast<double>(bins_) / n;
    return film;
  }
  // Of mean one.
  Film shape(LeftOut left_out) const {
    Film film = deposits_;
    for (const std::size_t g : {left_out.first, left_out.second})
      if (g != LeftOut::nobody)
        for (std::size_t j = 0; j < bins_; ++j) film[j] -= groups_[g].deposits[j];
    const double scale = 1 / mean_of(film);
    for (double& value : film) value *= scale;
    return film;
  }

  // Of the film of one half, from the spread of the groups of the other.
  Film variance_of_found(std::size_t half) const {
    const std::size_t other = 1 - half;
    const Film mean = found(other, none);
    Film variance(bins_);
    double count = 0;
    for (std::size_t g = other; g < groups_.size(); g += 2, ++count)
      for (std::size_t j = 0; j < bins_; ++j) {
        const double value = static_cast<double>(bins_) / groups_[g].samples * groups_[g].found[j];
        variance[j] += (value - mean[j]) * (value - mean[j]);
      }
    for (double& v : variance) v /= count * (count - 1);
    return floored(smoothed(variance, shape_));
  }
  // By the jackknife.
  Film variance_of_shape() const {
    Film variance(bins_), whole = shape(none);
    const auto n = static_cast<double>(groups_.size());
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      const Film part = shape({g});
      for (std::size_t j = 0; j < bins_; ++j)
        variance[j] += (part[j] - whole[j]) * (part[j] - whole[j]) * (n - 1) / n;
    }
    return smoothed(variance, shape_);
  }

 private:
  static Film floored(Film film) {
    const double least = smallest_variance * mean_of(film);
    for (double& v : film) v = std::max(v, least);
    return film;
  }

  std::span<const FilmFitGroup> groups_;
  std::span<const int> shape_;
  std::size_t bins_;
  std::array<Film, 2> found_;
  std::array<double, 2> samples_{};
  Film deposits_;
};

// One half's fit, with the variances that belong to it.
class Half {
 public:
  Half(const Films& films, std::size_t half, const Film& shape_variance)
      : films_(films),
        half_(half),
        variance_(films.variance_of_found(half)),
        shape_variance_(shape_variance) {}

  std::optional<Factor> fit() {
    const Film found = films_.found(half_, none), shape = films_.shape(none);
    const double b0 = mean_of(found);
    if (!(b0 > 0) || !all_known(b0)) return std::nullopt;
    const std::optional<Factor> solution = fit_factor(found, shape, variances(), b0);
    if (solution) b_ = solution->b;
    return solution;
  }
  // With the variances of fit().
  double without(LeftOut left_out) const {
    return refined_factor(films_.found(half_, left_out), films_.shape(left_out), variances(), b_);
  }

 private:
  FactorVariances variances() const { return {variance_, shape_variance_}; }
  bool all_known(double b) const {
    for (std::size_t j = 0; j < variance_.size(); ++j)
      if (!(variances().of_residual(j, b) > 0)) return false;
    return true;
  }

  const Films& films_;
  std::size_t half_;
  Film variance_;
  const Film& shape_variance_;
  double b_ = 0;
};

// Σ Var p / Σ p², the share by which noise of the chains would make b smaller.
double noise_of_shape(std::span<const FilmFitGroup> groups, std::span<const int> shape) {
  const Films films(groups, shape);
  const Film whole = films.shape(none), variance = films.variance_of_shape();
  double noise = 0, squares = 0;
  for (std::size_t j = 0; j < whole.size(); ++j) {
    noise += variance[j];
    squares += whole[j] * whole[j];
  }
  return noise / squares;
}

// Of the mean of all samples, from how the groups differ.
double relative_error_of_found(std::span<const FilmFitGroup> groups) {
  const auto light_of = [](const FilmFitGroup& group) {
    return std::accumulate(group.found.begin(), group.found.end(), 0.0);
  };
  double light = 0, samples = 0, squares = 0;
  for (const FilmFitGroup& group : groups) {
    light += light_of(group);
    samples += group.samples;
  }
  for (const FilmFitGroup& group : groups)
    squares += squared(light_of(group) - light / samples * group.samples);
  return std::sqrt(squares) / light;
}

// As few bins as it takes for the chains to know them, and no fewer than `fewest_bins`.
CoarseFilms coarsened(std::span<const FilmFitGroup> groups, std::span<const int> shape) {
  const double noise = std::min(most_noise, most_noise_of_error * relative_error_of_found(groups));
  CoarseFilms coarse{{groups.begin(), groups.end()}, {shape.begin(), shape.end()}};
  while (coarse.groups.front().found.size() >= 2 * fewest_bins &&
         noise_of_shape(coarse.groups, coarse.shape) > noise)
    coarse.halve();
  return coarse;
}

// b of both halves without some groups.
class BothHalves {
 public:
  BothHalves(const Half& even, const Half& odd, std::size_t groups)
      : even_(even), odd_(odd), groups_(groups) {}

  std::vector<double> without_each() const {
    std::vector<double> b(groups_);
    in_parallel(groups_, [&](std::size_t g) { b[g] = without({g}); });
    return b;
  }
  // One group of each half, so that in no half all are left out.
  std::vector<LeftOutPair> without_pairs() const {
    std::vector<LeftOutPair> pairs;
    for (std::size_t apart = 1; apart < most_apart && 2 * apart < groups_; apart += 2)
      for (std::size_t g = 0; g < groups_; ++g) pairs.push_back({g, (g + apart) % groups_, 0});
    in_parallel(pairs.size(), [&](std::size_t k) {
      pairs[k].without = without({pairs[k].first, pairs[k].second});
    });
    return pairs;
  }

 private:
  double without(LeftOut left_out) const {
    return (even_.without(left_out) + odd_.without(left_out)) / 2;
  }

  const Half &even_, &odd_;
  std::size_t groups_;
};

}  // namespace

FilmFit fit_films(std::span<const FilmFitGroup> fine_groups, std::span<const int> fine_shape) {
  FilmFit fit;
  if (fine_groups.size() < 4 || fine_groups.front().found.size() < 2) {
    fit.failure = "it needs four groups and two bins";
    return fit;
  }
  const auto [groups, shape] = coarsened(fine_groups, fine_shape);
  fit.bins = groups.front().found.size();
  const Films films(groups, shape);
  const Film shape_variance = films.variance_of_shape();
  Half even(films, 0, shape_variance), odd(films, 1, shape_variance);
  const auto first = even.fit(), second = odd.fit();
  if (!first || !second) {
    fit.failure =
        "the least squares did not converge, for a half of the seed pass tells too little";
    return fit;
  }
  fit.b = (first->b + second->b) / 2;
  fit.chi2_per_degree = (first->chi2 + second->chi2) / static_cast<double>(2 * (fit.bins - 1));
  const BothHalves both(even, odd, groups.size());
  fit.without = both.without_each();
  count_products_once(fit.without, fit.b, both.without_pairs());
  return fit;
}

}  // namespace wander

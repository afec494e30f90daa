#include "mlt/run/film_fit.h"

#include <ceres/ceres.h>

#include <cmath>
#include <limits>
#include <optional>

#include "mlt/run/coarse_films.h"
#include "mlt/run/solver_log.h"
#include "work/parallel.h"

namespace wander {

namespace {

using Film = std::vector<double>;

// The variance of a residual may not be less than this part of the mean over the bins.
constexpr double smallest_variance = 1e-3;
constexpr int smoothing_radius = 2;  // bins
// Neighbouring bins are taken together until Σ Var p / Σ p² is no more, or there are no fewer bins.
constexpr double most_noise = 0.005;
constexpr std::size_t fewest_bins = 16;

// What is known of the errors of both films.
struct Variances {
  const Film &found, &shape;

  double of_residual(std::size_t j, double b) const { return found[j] + b * b * shape[j]; }
};

// (I_j - b p_j) / √(v_j + b² Var p_j) with b = b_0 e^β, over all bins.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const Film& found, const Film& shape, const Variances& variances, double b0)
      : found_(found), shape_(shape), variances_(variances), b0_(b0) {
    set_num_residuals(static_cast<int>(found.size()));
    mutable_parameter_block_sizes()->push_back(1);
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double b = b0_ * std::exp(parameters[0][0]);
    for (std::size_t j = 0; j < found_.size(); ++j) {
      const double variance = variances_.of_residual(j, b), sigma = std::sqrt(variance);
      residuals[j] = (found_[j] - b * shape_[j]) / sigma;
      if (jacobians && jacobians[0])
        jacobians[0][j] =
            -b * (shape_[j] / sigma + residuals[j] * b * variances_.shape[j] / variance);
    }
    return std::isfinite(b);
  }

 private:
  const Film &found_, &shape_;
  Variances variances_;
  double b0_;
};

struct Solution {
  double b, chi2;
};

std::optional<Solution> solve(const Film& found, const Film& shape, const Variances& variances,
                              double b0) {
  silence_solver();
  ceres::Problem problem;
  double beta = 0;
  problem.AddResidualBlock(new Residuals(found, shape, variances, b0), nullptr, &beta);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.function_tolerance = 1e-15;
  options.parameter_tolerance = 1e-12;
  options.gradient_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const double b = b0 * std::exp(beta);
  if (!summary.IsSolutionUsable() || !std::isfinite(b) || !(b > 0)) return std::nullopt;
  return Solution{b, 2 * summary.final_cost};
}

// The groups whose number is even, or odd: what is summed over them, with one left out.
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

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
  Film found(std::size_t half, std::size_t left_out) const {
    const bool leaves_out = left_out != none && left_out % 2 == half;
    const double n = samples_[half] - (leaves_out ? groups_[left_out].samples : 0);
    Film film(bins_);
    for (std::size_t j = 0; j < bins_; ++j)
      film[j] = static_cast<double>(bins_) / n *
                (found_[half][j] - (leaves_out ? groups_[left_out].found[j] : 0));
    return film;
  }
  // Of mean one.
  Film shape(std::size_t left_out) const {
    Film film = deposits_;
    double total = 0;
    for (std::size_t j = 0; j < bins_; ++j) {
      if (left_out != none) film[j] -= groups_[left_out].deposits[j];
      total += film[j];
    }
    for (double& value : film) value *= static_cast<double>(bins_) / total;
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
      const Film part = shape(g);
      for (std::size_t j = 0; j < bins_; ++j)
        variance[j] += (part[j] - whole[j]) * (part[j] - whole[j]) * (n - 1) / n;
    }
    return smoothed(variance, shape_);
  }

 private:
  static Film floored(Film film) {
    double mean = 0;
    for (const double v : film) mean += v / static_cast<double>(film.size());
    for (double& v : film) v = std::max(v, smallest_variance * mean);
    return film;
  }

  std::span<const FilmFitGroup> groups_;
  std::span<const int> shape_;
  std::size_t bins_;
  std::array<Film, 2> found_;
  std::array<double, 2> samples_{};
  Film deposits_;
};

double mean_of(const Film& film) {
  double sum = 0;
  for (const double value : film) sum += value;
  return sum / static_cast<double>(film.size());
}

// One half's fit, with the variances that belong to it.
class Half {
 public:
  Half(const Films& films, std::size_t half, const Film& shape_variance)
      : films_(films),
        half_(half),
        variance_(films.variance_of_found(half)),
        shape_variance_(shape_variance) {}

  std::optional<Solution> fit() {
    const Film found = films_.found(half_, none), shape = films_.shape(none);
    const double b0 = mean_of(found);
    if (!(b0 > 0) || !all_known(b0)) return std::nullopt;
    const std::optional<Solution> solution = solve(found, shape, variances(), b0);
    if (solution) b_ = solution->b;
    return solution;
  }
  // With the variances of fit().
  double without(std::size_t group) const {
    const auto solution = solve(films_.found(half_, group), films_.shape(group), variances(), b_);
    return solution ? solution->b : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  Variances variances() const { return {variance_, shape_variance_}; }
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

// The smoothing along one axis, of so many bins that lie `stride` apart: Σ instead of the mean.
Film summed_along(const Film& film, int extent, std::size_t stride) {
  Film sums(film.size());
  for (std::size_t j = 0; j < film.size(); ++j) {
    const int at = static_cast<int>(j / stride % static_cast<std::size_t>(extent));
    const int low = std::max(0, at - smoothing_radius);
    const int high = std::min(extent - 1, at + smoothing_radius);
    const std::size_t begin = j - static_cast<std::size_t>(at - low) * stride;
    for (int i = low; i <= high; ++i)
      sums[j] += film[begin + static_cast<std::size_t>(i - low) * stride];
  }
  return sums;
}

}  // namespace

Film smoothed(const Film& film, std::span<const int> shape) {
  Film sums = film, counts(film.size(), 1.0);
  std::size_t stride = 1;
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    sums = summed_along(sums, shape[axis], stride);
    counts = summed_along(counts, shape[axis], stride);
    stride *= static_cast<std::size_t>(shape[axis]);
  }
  for (std::size_t j = 0; j < sums.size(); ++j) sums[j] /= counts[j];
  return sums;
}

namespace {

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

// As few bins as it takes for the chains to know them, and no fewer than `fewest_bins`.
CoarseFilms coarsened(std::span<const FilmFitGroup> groups, std::span<const int> shape) {
  CoarseFilms coarse{{groups.begin(), groups.end()}, {shape.begin(), shape.end()}};
  while (coarse.groups.front().found.size() >= 2 * fewest_bins &&
         noise_of_shape(coarse.groups, coarse.shape) > most_noise)
    coarse.halve();
  return coarse;
}

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
  fit.without.resize(groups.size());
  in_parallel(groups.size(),
              [&](std::size_t g) { fit.without[g] = (even.without(g) + odd.without(g)) / 2; });
  return fit;
}

}  // namespace wander

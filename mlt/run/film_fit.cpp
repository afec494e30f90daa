#include "mlt/run/film_fit.h"

#include <ceres/ceres.h>

#include <cmath>
#include <limits>
#include <optional>

#include "mlt/run/solver_log.h"
#include "work/parallel.h"

namespace wander {

namespace {

using Film = std::vector<double>;

// The variance of a residual may not be less than this part of the mean over the bins.
constexpr double smallest_variance = 1e-3;
constexpr int smoothing_radius = 2;  // bins

// (I_j - b p_j) / σ_j with b = b_0 e^β, over all bins.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const Film& found, const Film& shape, const Film& sigma, double b0)
      : found_(found), shape_(shape), sigma_(sigma), b0_(b0) {
    set_num_residuals(static_cast<int>(found.size()));
    mutable_parameter_block_sizes()->push_back(1);
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double b = b0_ * std::exp(parameters[0][0]);
    for (std::size_t j = 0; j < found_.size(); ++j) {
      residuals[j] = (found_[j] - b * shape_[j]) / sigma_[j];
      if (jacobians && jacobians[0]) jacobians[0][j] = -b * shape_[j] / sigma_[j];
    }
    return std::isfinite(b);
  }

 private:
  const Film &found_, &shape_, &sigma_;
  double b0_;
};

struct Solution {
  double b, chi2;
};

std::optional<Solution> solve(const Film& found, const Film& shape, const Film& sigma, double b0) {
  silence_solver();
  ceres::Problem problem;
  double beta = 0;
  problem.AddResidualBlock(new Residuals(found, shape, sigma, b0), nullptr, &beta);
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
    return variance;
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
    double b0 = mean_of(found);
    std::optional<Solution> solution;
    for (int round = 0; round < 3; ++round) {
      if (!(b0 > 0) || !set_sigma(b0)) return std::nullopt;
      solution = solve(found, shape, sigma_, b0);
      if (!solution) return std::nullopt;
      b0 = solution->b;
    }
    b_ = b0;
    return solution;
  }
  // With the weights of fit().
  double without(std::size_t group) const {
    const auto solution = solve(films_.found(half_, group), films_.shape(group), sigma_, b_);
    return solution ? solution->b : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  bool set_sigma(double b0) {
    sigma_ = variance_;
    for (std::size_t j = 0; j < sigma_.size(); ++j) {
      sigma_[j] = std::sqrt(sigma_[j] + b0 * b0 * shape_variance_[j]);
      if (!(sigma_[j] > 0)) return false;
    }
    return true;
  }

  const Films& films_;
  std::size_t half_;
  Film variance_;
  const Film& shape_variance_;
  Film sigma_;
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

FilmFit fit_films(std::span<const FilmFitGroup> groups, std::span<const int> shape) {
  FilmFit fit;
  if (groups.size() < 4 || groups.front().found.size() < 2) {
    fit.failure = "it needs four groups and two bins";
    return fit;
  }
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
  fit.chi2_per_degree =
      (first->chi2 + second->chi2) / static_cast<double>(2 * (groups.front().found.size() - 1));
  fit.without.resize(groups.size());
  in_parallel(groups.size(),
              [&](std::size_t g) { fit.without[g] = (even.without(g) + odd.without(g)) / 2; });
  return fit;
}

}  // namespace wander

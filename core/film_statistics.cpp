#include "core/film_statistics.h"

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/tint.h"

namespace wander {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Squares of films lit by 1e200 W would overflow: sums of squares are formed in units of the
// largest.
double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values)
    if (std::isfinite(value)) result = std::max(result, std::abs(value));
  return result;
}

double squared(double x) { return x * x; }

// Variances of the two means x and r combine by Welch and Satterthwaite.
double combined_degrees(double error_x, double degrees_x, double error_r, double degrees_r) {
  const double total = squared(squared(error_x) + squared(error_r));
  const double shares =
      squared(squared(error_x)) / degrees_x + squared(squared(error_r)) / degrees_r;
  return shares > 0 ? total / shares : std::numeric_limits<double>::infinity();
}

// Does the 95 % t-interval of a difference hold zero?  Quantiles are slow, and an image has millions
// of numbers: most are decided by what a quantile lies between, for the combined degrees of freedom
// are no fewer than those of either film.
class Coverage {
 public:
  Coverage(double degrees_x, double degrees_r)
      : degrees_x_(degrees_x),
        degrees_r_(degrees_r),
        least_(student_t_95(std::numeric_limits<double>::infinity())),
        most_(student_t_95(std::min(degrees_x, degrees_r)) * (1 + 1e-9)) {}

  bool holds_zero(double difference, double error_x, double error_r) const {
    const double error = std::hypot(error_x, error_r);
    if (difference == 0 || difference <= least_ * error) return true;
    if (difference > most_ * error) return false;
    return difference <= error * student_t_95(combined_degrees(error_x / error, degrees_x_,
                                                               error_r / error, degrees_r_));
  }

 private:
  double degrees_x_, degrees_r_, least_, most_;
};

double relative_rmse(const FilmEstimate& film, const FilmEstimate& reference) {
  const double unit = largest(reference.value);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < film.value.size(); ++i) {
    error += squared((film.value[i] - reference.value[i]) / unit);
    size += squared(reference.value[i] / unit);
  }
  return size > 0 ? std::sqrt(error / size) : unknown;
}

double luminance_of_means(const FilmEstimate& film) {
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < film.value.size(); ++i) sums[i % 3] += film.value[i];
  return luminance(sums) * 3 / static_cast<double>(film.value.size());
}

bool is_reliable(const FilmEstimate& film, std::size_t bin) {
  return (film.reliable.empty() || film.reliable[bin]) && std::isfinite(film.standard_error[bin]);
}

}  // namespace

double mean_value(const FilmEstimate& film) {
  if (channels_of(film.shape) == 3) return luminance_of_means(film);
  const double sum = std::accumulate(film.value.begin(), film.value.end(), 0.0);
  return film.value.empty() ? unknown : sum / static_cast<double>(film.value.size());
}

double relative_error(const FilmEstimate& film) {
  const double unit = largest(film.value);
  double variance = 0, size = 0;
  for (std::size_t i = 0; i < film.value.size(); ++i) {
    if (!std::isfinite(film.standard_error[i])) continue;
    variance += squared(film.standard_error[i] / unit);
    size += squared(film.value[i] / unit);
  }
  return size > 0 ? std::sqrt(variance / size) : unknown;
}

bool is_dark(const FilmEstimate& film) {
  return std::ranges::none_of(film.value, [](double x) { return x > 0; });
}

std::size_t reliable_bins(const FilmEstimate& film) {
  return static_cast<std::size_t>(std::count(film.reliable.begin(), film.reliable.end(), true));
}

FilmComparison film_comparison(const FilmEstimate& film, const FilmEstimate& reference) {
  FilmComparison result;
  result.relative_rmse = relative_rmse(film, reference);
  const Coverage coverage(film.degrees_of_freedom, reference.degrees_of_freedom);
  std::size_t covered = 0, measured = 0;
  double chi2 = 0;
  for (std::size_t i = 0; i < film.value.size(); ++i) {
    if (!is_reliable(film, i) || !is_reliable(reference, i)) continue;
    ++result.bins;
    const double difference = std::abs(film.value[i] - reference.value[i]);
    const double error = std::hypot(film.standard_error[i], reference.standard_error[i]);
    if (coverage.holds_zero(difference, film.standard_error[i], reference.standard_error[i]))
      ++covered;
    if (!(error > 0)) continue;
    ++measured;
    const double z = difference / error;
    chi2 += z * z;
    result.largest_z = std::max(result.largest_z, z);
  }
  const auto share = [](double sum, std::size_t n) {
    return n > 0 ? sum / static_cast<double>(n) : unknown;
  };
  result.chi2_per_degree = share(chi2, measured);
  result.covered_share = share(static_cast<double>(covered), result.bins);
  return result;
}

double student_t_95(double degrees_of_freedom) {
  if (!(degrees_of_freedom >= 1)) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 0.975);
}

}  // namespace wander

#include "lab/compare/yardstick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "statistics/squared.h"
#include "statistics/sum.h"

namespace wander::compare {

namespace {

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values)
    if (std::isfinite(value)) result = std::max(result, std::abs(value));
  return result > 0 ? result : 1;
}

double over_bins(const Sum& sum, std::size_t bins) {
  return bins > 0 ? sum.value() / static_cast<double>(bins) : not_known;
}

void weigh(Yardstick& yardstick) {
  if (!(yardstick.mean_square > 0)) return;
  for (const double value : yardstick.value)
    yardstick.weight.push_back(1 / (squared(value) + squared(0.01 * yardstick.mean)));
}

}  // namespace

Yardstick::Yardstick(const Reference& reference) : film(reference.film) {
  const std::size_t bins = film.value.size();
  if (!(film.degrees_of_freedom >= 1))
    film.degrees_of_freedom = std::numeric_limits<double>::infinity();
  degrees = film.degrees_of_freedom;
  film.standard_error.resize(bins, 0);
  unit = largest(film.value);
  Sum sum, squares, errors, square_errors, weighted;
  for (const double x : film.value) {
    value.push_back(x / unit);
    sum += value.back();
    squares += squared(value.back());
  }
  mean = over_bins(sum, bins);
  mean_square = over_bins(squares, bins);
  weigh(*this);
  for (std::size_t j = 0; j < bins; ++j) {
    const double error = film.standard_error[j] / unit;
    if (!std::isfinite(error)) {
      ++bins_of_unknown_error;
      continue;
    }
    errors += error;
    square_errors += squared(error);
    if (!weight.empty()) weighted += weight[j] * squared(error);
  }
  noise = over_bins(square_errors, bins);
  noise_of_mean = over_bins(errors, bins);
  weighted_noise = over_bins(weighted, bins);
}

Distance distance(const FilmEstimate& film, const Yardstick& yardstick) {
  const std::size_t bins = yardstick.value.size();
  if (film.value.size() != bins)
    throw std::invalid_argument("a film and its reference differ in their number of bins");
  Sum square, absolute, weighted, mean;
  for (std::size_t j = 0; j < bins; ++j) {
    if (!std::isfinite(film.value[j])) return {};
    const double error = film.value[j] / yardstick.unit - yardstick.value[j];
    square += squared(error);
    absolute += std::abs(error);
    mean += error;
    if (!yardstick.weight.empty()) weighted += yardstick.weight[j] * squared(error);
  }
  return {over_bins(square, bins), over_bins(absolute, bins),
          yardstick.weight.empty() ? not_known : over_bins(weighted, bins), over_bins(mean, bins)};
}

RunErrors errors_of(const FilmEstimate& film, const Yardstick& yardstick) {
  const Distance d = distance(film, yardstick);
  if (!std::isfinite(d.square)) return {};
  const bool lit = yardstick.mean_square > 0;
  RunErrors errors;
  const double mse = d.square - yardstick.noise;
  errors.relative_mse = lit ? mse / yardstick.mean_square : not_known;
  errors.relative_rmse = lit ? std::sqrt(std::max(errors.relative_mse, 0.0)) : not_known;
  errors.rmse = yardstick.unit * std::sqrt(std::max(mse, 0.0));
  errors.mae = yardstick.unit * d.absolute;
  errors.rel_mse = d.weighted - yardstick.weighted_noise;
  errors.mean = yardstick.unit * (yardstick.mean + d.mean);
  errors.relative_error_of_mean = yardstick.mean != 0 ? d.mean / yardstick.mean : not_known;
  if (film.standard_error.size() != film.value.size()) return errors;
  errors.claimed_relative_error = relative_error(film);
  const FilmComparison against = film_comparison(film, yardstick.film);
  errors.coverage = against.covered_share;
  errors.reliable_share = film.reliable.empty() ? not_known
                                                : static_cast<double>(reliable_bins(film)) /
                                                      static_cast<double>(film.value.size());
  return errors;
}

}  // namespace wander::compare

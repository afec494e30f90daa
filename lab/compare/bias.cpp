#include "lab/compare/bias.h"

#include <algorithm>
#include <cmath>

#include "statistics/decision.h"
#include "statistics/sum.h"

namespace wander::compare {

namespace {

// y_r in one bin, in the yardstick's units.
double deviation(const Run& run, const Yardstick& yardstick, std::size_t bin) {
  return run.film.value[bin] / yardstick.unit - yardstick.value[bin];
}

double signed_root(double x) { return std::copysign(std::sqrt(std::abs(x)), x); }

}  // namespace

PairedSquare paired_square(const CellRuns& cell, const Yardstick& yardstick) {
  const std::size_t count = cell.runs.size(), bins = yardstick.value.size();
  if (count < 2 || bins == 0) return {};
  Sum total;                                     // |S|²
  std::vector<Sum> own(count), with_all(count);  // |y_r|², y_r S
  std::vector<double> y(count);
  for (std::size_t j = 0; j < bins; ++j) {
    double sum = 0;
    for (std::size_t r = 0; r < count; ++r) sum += y[r] = deviation(*cell.runs[r], yardstick, j);
    total += sum * sum;
    for (std::size_t r = 0; r < count; ++r) {
      own[r] += y[r] * y[r];
      with_all[r] += y[r] * sum;
    }
  }
  const auto n = static_cast<double>(count), size = static_cast<double>(bins);
  double diagonal = 0;
  for (const Sum& square : own) diagonal += square.value();
  PairedSquare result{(total.value() - diagonal) / (n * (n - 1)) / size, not_known};
  if (count < 3) return result;
  Moments without;  // U of all replicates but one: |S - y_r|² = |S|² - 2 y_r S + |y_r|²
  for (std::size_t r = 0; r < count; ++r) {
    const double rest = total.value() - 2 * with_all[r].value() + own[r].value();
    without.add((rest - (diagonal - own[r].value())) / ((n - 1) * (n - 2)) / size);
  }
  result.standard_error = (n - 1) * without.standard_error();  // √((n-1)/n Σ (U_(r) - mean)²)
  return result;
}

Measured relative_bias(const PairedSquare& pairs, std::size_t replicates,
                       const Yardstick& yardstick) {
  if (!(yardstick.mean_square > 0) || std::isnan(pairs.value)) return {};
  const double square = pairs.value - yardstick.noise;
  const auto root = [&](double x) { return signed_root(x / yardstick.mean_square); };
  if (std::isnan(pairs.standard_error)) return {root(square), {}};
  const double spread =
      student_threshold(0.05, static_cast<double>(replicates - 1)) * pairs.standard_error;
  // The reference's error is t² mean e², from 0 to the quantile 0.975 of t².
  const double worst = std::pow(student_threshold(0.025, yardstick.degrees), 2);
  const double t = student_threshold(0.05, yardstick.degrees);
  const double common = 2 * t * std::sqrt(yardstick.noise * std::max(square, 0.0));
  const double below = std::hypot(spread, (worst - 1) * yardstick.noise, common);
  const double above = std::hypot(spread, yardstick.noise, common);
  // The spread of a square grows with it: (√u + h/(2√u))² = u + h + h²/(4u), for a small h.
  const double growth = square > 0 ? std::min(square, above * above / (4 * square)) : 0;
  // |bias|² is not negative.
  return {root(square), {root(square - below), root(std::max(square + above + growth, 0.0))}};
}

Measured error_of_mean(const CellRuns& cell, const Yardstick& yardstick) {
  Moments errors;
  for (const RunErrors* run : cell.errors) errors.add(run->relative_error_of_mean);
  if (errors.count() == 0 || !std::isfinite(errors.mean())) return {};
  if (errors.count() < 2) return {errors.mean(), {}};
  const double spread =
      student_threshold(0.05, static_cast<double>(errors.count() - 1)) * errors.standard_error();
  const double reference = student_threshold(0.05, yardstick.degrees) * yardstick.noise_of_mean /
                           std::abs(yardstick.mean);
  const double reach = std::hypot(spread, reference);
  return {errors.mean(), {errors.mean() - reach, errors.mean() + reach}};
}

}  // namespace wander::compare

// How often each interval of a comparison holds what it is about, and how long it is beside the spread
// of its estimate, over simulated comparisons of two methods.
#pragma once

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <map>
#include <numbers>
#include <string>

#include "lab/compare/measurements.h"
#include "statistics/decision.h"
#include "tests/lab/compare/coverage.h"

namespace wander::test {

struct IntervalTrials {
  std::size_t replicates = 8;
  ErrorLaw law = error_laws()[0];
  double reference_error = 0;  // over the error of the better method at the last budget
  bool common_reference = false;
  double bias = 0;  // the same, of the better method
  std::uint64_t trials = 100, seed = 1;
};

// Errors 0.1 and 0.2 at one second: 4 times the square error, always.
inline constexpr double better = 0.1, worse = 0.2;

// In which the estimates of a quantity spread evenly about it.
using Scale = double (*)(double);
inline double linear(double x) { return x; }
inline double logarithmic(double x) { return std::log(x); }

struct Kept {
  Coverage coverage;
  Moments estimate, claimed_variance;  // on the scale; of intervals with both bounds

  void add(const compare::Measured& measured, double truth, Scale scale) {
    const auto& [low, high] = measured.interval;
    ++coverage.trials;
    // A bound that is not known excludes nothing.
    if (!(low > truth) && !(high < truth)) ++coverage.hits;
    const double deviation =
        (scale(high) - scale(low)) / (2 * quantile(boost::math::normal(), 0.975));
    if (!std::isfinite(deviation)) return;
    estimate.add(scale(measured.value));
    claimed_variance.add(deviation * deviation);
  }
  // The standard deviation that a normal error with such intervals has, over the true one.
  double claimed_over_true() const {
    return std::sqrt(claimed_variance.mean() / estimate.variance());
  }
};
using AllKept = std::map<std::string, Kept>;

// The median of the mean square of the errors of so many bins, of mean square 1.
inline double median_of_squares(const ErrorLaw& law, std::size_t bins) {
  const double degrees = law.name == error_laws()[1].name ? 1 : static_cast<double>(bins);
  return quantile(boost::math::chi_squared(degrees), 0.5) / degrees;
}

inline void keep_cell(AllKept& kept, const compare::Cell& cell, double unit, double bias) {
  const double square = unit * unit + bias * bias;
  kept["relative_rmse"].add(cell.relative_rmse, std::sqrt(square), logarithmic);
  kept["rmse"].add(cell.rmse, std::sqrt(square), logarithmic);
  kept["bias"].add(cell.bias, bias, linear);
  kept["mean"].add(cell.relative_error_of_mean, bias, linear);
  kept["efficiency"].add(cell.efficiency, 1 / (square * cell.seconds.value), logarithmic);
}

inline AllKept intervals_of(const IntervalTrials& options) {
  AllKept result;
  Generator random(options.seed);
  const double last = 16, unit = better / std::sqrt(last), bias = options.bias * unit;
  MadeScene scene{.replicates = options.replicates, .seconds = {1, 4, last}};
  scene.reference_error = options.reference_error * unit;
  if (options.common_reference) scene.reference_errors = common_errors;
  const double median = median_of_squares(options.law, scene.bins);
  for (std::uint64_t i = 0; i < options.trials; ++i) {
    const compare::Comparison c = compare::summarize(made_runs(
        scene, {{"better", better, bias, options.law.draw}, {"worse", worse, 0, options.law.draw}},
        random));
    keep_cell(result, c.cells[2], unit, bias);
    if (bias > 0) continue;
    if (options.reference_error == 0) {
      result["mae"].add(c.cells[2].mae, unit * std::sqrt(2 / std::numbers::pi), logarithmic);
      result["median"].add(c.cells[2].median_relative_rmse, unit * std::sqrt(median), logarithmic);
    }
    result["slope"].add(c.curves[0].slope_time, -0.5, linear);
    result["seconds_to_target"].add(c.curves[1].seconds_to_target,
                                    worse * worse / (c.target * c.target), logarithmic);
    const bool right = c.crossings[0].ahead == 0;
    result["speedup"].add(c.crossings[0].speedup, right ? 4 : 0.25, logarithmic);
  }
  return result;
}

// Of a method without bias that gets ahead of one that has some: errors 0.2/√t, and 0.1/√t with a bias of 0.1.
// The square errors meet at 3 s; between the budgets, where they are taken for straight over logarithms, a
// little later.
struct Meeting {
  double bias = better;
  std::vector<double> seconds{0.5, 1, 4, 16, 64};

  double square(double error, double of_bias, double t) const {
    return error * error / t + of_bias * of_bias;
  }
  compare::Path path(double error, double of_bias) const {
    compare::Path result;
    for (const double t : seconds)
      result.push_back({std::log(t), std::log(square(error, of_bias, t))});
    return result;
  }
  double time() const { return compare::seconds_ahead(path(worse, 0), path(better, bias)); }
};

inline Kept crossing_times_of(const IntervalTrials& options) {
  Kept kept;
  Generator random(options.seed);
  const Meeting meeting;
  const double truth = meeting.time();
  for (std::uint64_t i = 0; i < options.trials; ++i) {
    const compare::Comparison c =
        compare::summarize(made_runs({.replicates = options.replicates, .seconds = meeting.seconds},
                                     {{"biased", better, meeting.bias, options.law.draw},
                                      {"unbiased", worse, 0, options.law.draw}},
                                     random));
    kept.add(c.crossings[0].seconds, truth, logarithmic);
  }
  return kept;
}

// How often two methods of the same error are called different.
inline Coverage false_alarms_of(const IntervalTrials& options, const ErrorLaw& other) {
  Coverage alarms{0, options.trials};
  Generator random(options.seed);
  for (std::uint64_t i = 0; i < options.trials; ++i) {
    const MadeScene scene{.replicates = options.replicates, .seconds = {1}};
    const compare::Comparison c = compare::summarize(made_runs(
        scene, {{"a", better, 0, options.law.draw}, {"b", better, 0, other.draw}}, random));
    if (c.crossings[0].significant) ++alarms.hits;
  }
  return alarms;
}

}  // namespace wander::test

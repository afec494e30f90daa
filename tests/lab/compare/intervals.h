// How often each interval of a comparison holds what it is about, over simulated comparisons of two
// methods whose errors cross at a known time.
#pragma once

#include <map>
#include <string>

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

inline void count(std::map<std::string, Coverage>& all, const std::string& what,
                  const compare::Interval& interval, double truth) {
  Coverage& coverage = all[what];
  ++coverage.trials;
  // A bound that is not known excludes nothing.
  if (!(interval.low > truth) && !(interval.high < truth)) ++coverage.hits;
}

inline std::map<std::string, Coverage> coverages_of(const IntervalTrials& options) {
  std::map<std::string, Coverage> result;
  Generator random(options.seed);
  const double last = 16, unit = better / std::sqrt(last), bias = options.bias * unit;
  for (std::uint64_t i = 0; i < options.trials; ++i) {
    MadeScene scene{.replicates = options.replicates, .seconds = {1, 4, last}};
    scene.reference_error = options.reference_error * unit;
    if (options.common_reference) scene.reference_errors = common_errors;
    const compare::Comparison c = compare::summarize(made_runs(
        scene, {{"better", better, bias, options.law.draw}, {"worse", worse, 0, options.law.draw}},
        random));
    const compare::Cell& cell = c.cells[2];
    const double square = unit * unit + bias * bias;
    count(result, "relative_rmse", cell.relative_rmse.interval, std::sqrt(square));
    count(result, "bias", cell.bias.interval, bias);
    count(result, "mean", cell.relative_error_of_mean.interval, bias);
    count(result, "efficiency", cell.efficiency.interval, 1 / (square * last));
    if (bias > 0) continue;
    count(result, "slope", c.curves[0].slope_time.interval, -0.5);
    count(result, "seconds_to_target", c.curves[1].seconds_to_target.interval,
          worse * worse / (c.target * c.target));
    const bool right = c.crossings[0].ahead == 0;
    count(result, "speedup", c.crossings[0].speedup.interval, right ? 4 : 0.25);
  }
  return result;
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

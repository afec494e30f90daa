// How often an interval of the mean square error holds it, over simulated comparisons.
#pragma once

#include <algorithm>
#include <functional>

#include "lab/compare/plausible.h"
#include "tests/lab/compare/made_runs.h"

namespace wander::test {

struct Coverage {
  std::uint64_t hits = 0, trials = 0;
  double share() const { return static_cast<double>(hits) / static_cast<double>(trials); }
};

struct Trials {
  std::size_t replicates = 8, bins = 64;
  std::uint64_t trials = 200, seed = 1;
};

using IntervalOf = std::function<compare::Interval(const std::vector<double>&, Generator&)>;

inline double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

inline compare::Interval interval_by_draws(const std::vector<double>& squares, Generator& random) {
  const auto stream = static_cast<std::uint32_t>(random.bits());
  return compare::interval_of(compare::draws_of_mean(squares, stream), mean_of(squares));
}

// The wrong twin: the quantiles of means of resampled replicates.
inline compare::Interval interval_by_bootstrap(const std::vector<double>& squares,
                                               Generator& random) {
  std::vector<double> means;
  for (int i = 0; i < 1000; ++i) {
    double sum = 0;
    for (std::size_t r = 0; r < squares.size(); ++r) {
      const double u = random.uniform();
      sum += squares[static_cast<std::size_t>(u * static_cast<double>(squares.size()))];
    }
    means.push_back(sum / static_cast<double>(squares.size()));
  }
  std::sort(means.begin(), means.end());
  return {means[25], means[974]};
}

// Errors of mean square 1.
inline Coverage coverage_of(const IntervalOf& interval_of, const ErrorLaw& law,
                            const Trials& trials) {
  Generator random(trials.seed);
  Coverage coverage{0, trials.trials};
  for (std::uint64_t i = 0; i < trials.trials; ++i) {
    std::vector<double> squares;
    for (std::size_t r = 0; r < trials.replicates; ++r) {
      std::vector<double> errors = law.draw(random, trials.bins);
      for (double& error : errors) error *= error;
      squares.push_back(mean_of(errors));
    }
    const compare::Interval interval = interval_of(squares, random);
    if (interval.low <= 1 && 1 <= interval.high) ++coverage.hits;
  }
  return coverage;
}

}  // namespace wander::test

// How the error of a contender falls with time, and how long it takes to a given error.
//
// Slope: weighted least squares of log relative RMSE = s log t + c over cells, a cell weighing the
// inverse variance of its draws; the interval is that of the same fit to draws.  An estimator
// without bias has s = -1/2, and then m t is a constant c of all cells, log c their weighted mean.
// Along it the time to an error may lie beyond the longest run: that is extrapolated, said to be so
// wherever it is told, and told up to a few times that run only.
#pragma once

#include <optional>

#include "lab/compare/measurements.h"

namespace wander::compare {

inline constexpr double farthest = 4;  // times the longest run, that a time is extrapolated to

// Seconds, of the cells of a contender that have an error; not known where there are none.
double longest_run(const Comparison& comparison, std::size_t contender);
double shortest_run(const Comparison& comparison, std::size_t contender);
// The time to the target lies beyond the longest run.
bool is_extrapolated(const Comparison& comparison, const Curve& curve);

// The least of 1, 2, 5, 10 ... that is not below the least error of the cells of one budget.
double round_target(const Measurements& all, std::size_t budget);

Curve measure_curve(const Measurements& all, std::size_t contender, double target);

// A run of a replicate: relative MSE and seconds.
struct ReplicatePoint {
  double relative_mse, seconds;
};
// Each replicate by itself: under a constant, its seconds to the target are mean(m_r t_r) /
// target²; else its own curve is interpolated.  Replicates that cannot tell have no entry.
// `replicates` holds the runs of each.
Profile measure_profile(const std::vector<std::vector<ReplicatePoint>>& replicates,
                        const Curve& curve, double target);

}  // namespace wander::compare

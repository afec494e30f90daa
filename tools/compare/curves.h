// How the error of a contender falls with time, and how long it takes to a given error.
//
// Slope: weighted least squares of log relative RMSE = s log t + c over cells, a cell weighing the
// inverse variance of its draws; the interval is that of the same fit to draws.  An estimator
// without bias has s = -1/2, and then m t is a constant c of all cells, log c their weighted mean.
#pragma once

#include <optional>

#include "tools/compare/measurements.h"

namespace wander::compare {

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

// All cells of a comparison with their draws: what curves, crossings and profiles are made of.
#pragma once

#include "lab/compare/cells.h"

namespace wander::compare {

struct Measurements {
  std::size_t contenders = 0, budgets = 0;
  std::vector<MeasuredCell> cells{};  // [contender][budget]

  const MeasuredCell& at(std::size_t contender, std::size_t budget) const {
    return cells[contender * budgets + budget];
  }
};

// A point of a curve that has a logarithm.
struct Point {
  double log_seconds, log_samples, log_mse;  // of the relative MSE
  const MeasuredCell* cell;
};
// Of a contender, by ascending time; cells without a positive error are left out.
std::vector<Point> points_of(const Measurements& all, std::size_t contender);

// Relative MSE over time between the points, linear in logarithms.
struct Knot {
  double log_seconds, log_mse;
};
using Path = std::vector<Knot>;  // by strictly ascending time
Path path_of(const std::vector<Point>& points);
// The same for draw i; empty if a point has no draws, or its draw no logarithm.
Path path_of(const std::vector<Point>& points, std::size_t draw);
double log_mse_at(const Path& path, double log_seconds);  // between its ends

// The time from which a path stays below `log_mse`: 0 if it always does, infinity if it does not at
// its end, NaN for an empty path.
double seconds_below(const Path& path, double log_mse);
// The time from which `ahead` stays below `behind`, where both are known; likewise.
double seconds_ahead(const Path& ahead, const Path& behind);

}  // namespace wander::compare

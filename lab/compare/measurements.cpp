#include "lab/compare/measurements.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wander::compare {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
// Runs of one time budget differ a little in time: curves that miss each other by less, in the
// logarithm, are held against each other where they are nearest.
constexpr double nearly = 0.1;

template <class Height>
Path path_with(const std::vector<Point>& points, Height height) {
  Path path;
  for (const Point& point : points) {
    if (!path.empty() && point.log_seconds <= path.back().log_seconds) continue;
    const double y = height(point);
    if (!std::isfinite(y)) return {};
    path.push_back({point.log_seconds, y});
  }
  return path;
}

// Where the last change of sign from above zero to below ends, of a path of differences.
double seconds_below_zero(const Path& difference) {
  if (difference.empty()) return not_known;
  if (!(difference.back().log_mse < 0)) return never;
  for (std::size_t i = difference.size() - 1; i > 0; --i) {
    const Knot &before = difference[i - 1], &after = difference[i];
    if (before.log_mse < 0) continue;
    const double share = before.log_mse / (before.log_mse - after.log_mse);
    return std::exp(before.log_seconds + share * (after.log_seconds - before.log_seconds));
  }
  return 0;
}

}  // namespace

std::vector<Point> points_of(const Measurements& all, std::size_t contender) {
  std::vector<Point> points;
  for (std::size_t b = 0; b < all.budgets; ++b) {
    const MeasuredCell& cell = all.at(contender, b);
    if (cell.relative_mse > 0 && cell.cell.seconds.value > 0)
      points.push_back({std::log(cell.cell.seconds.value), std::log(cell.cell.samples.value),
                        std::log(cell.relative_mse), &cell});
  }
  std::ranges::stable_sort(points, {}, &Point::log_seconds);
  return points;
}

Path path_of(const std::vector<Point>& points) {
  return path_with(points, [](const Point& point) { return point.log_mse; });
}

Path path_of(const std::vector<Point>& points, std::size_t draw) {
  return path_with(points, [draw](const Point& point) {
    const Draws& draws = point.cell->draws;
    return draws.empty() ? not_known : std::log(draws[draw]);
  });
}

double log_mse_at(const Path& path, double log_seconds) {
  const auto above = std::ranges::lower_bound(path, log_seconds, {}, &Knot::log_seconds);
  if (above == path.begin()) return path.front().log_mse;
  if (above == path.end()) return path.back().log_mse;
  const Knot &before = *(above - 1), &after = *above;
  const double share =
      (log_seconds - before.log_seconds) / (after.log_seconds - before.log_seconds);
  return before.log_mse + share * (after.log_mse - before.log_mse);
}

double seconds_below(const Path& path, double log_mse) {
  Path difference = path;
  for (Knot& knot : difference) knot.log_mse -= log_mse;
  return seconds_below_zero(difference);
}

double seconds_ahead(const Path& ahead, const Path& behind) {
  if (ahead.empty() || behind.empty()) return not_known;
  const double begin = std::max(ahead.front().log_seconds, behind.front().log_seconds);
  const double end = std::min(ahead.back().log_seconds, behind.back().log_seconds);
  std::vector<double> times{begin, end};
  for (const Path* path : {&ahead, &behind})
    for (const Knot& knot : *path)
      if (begin < knot.log_seconds && knot.log_seconds < end) times.push_back(knot.log_seconds);
  if (begin > end + nearly) return not_known;
  std::ranges::sort(times);
  Path difference;
  for (const double time : times)
    difference.push_back({time, log_mse_at(ahead, time) - log_mse_at(behind, time)});
  return seconds_below_zero(difference);
}

}  // namespace wander::compare

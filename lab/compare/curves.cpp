#include "lab/compare/curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statistics/decision.h"

namespace wander::compare {

namespace {

constexpr double slope_of_unbiased = -0.5;
constexpr double near_enough = 0.1;  // to it, whatever the interval

// 1 / variance of log relative RMSE, of its draws; alike where nothing is known.
double weight_of(const Point& point) {
  Moments logs;
  for (const double draw : point.cell->draws)
    if (draw > 0 && std::isfinite(draw)) logs.add(std::log(draw) / 2);
  constexpr double least_variance = 1e-8;
  return logs.count() < 2 ? 1 : 1 / std::max(logs.variance(), least_variance);
}

// The fit is linear in the heights: slope = Σ coefficient y.  None if all x are alike.
std::vector<double> slope_coefficients(const std::vector<double>& x,
                                       const std::vector<double>& weights) {
  double sum = 0, mean = 0, spread = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += weights[i];
    mean += weights[i] * x[i];
  }
  mean /= sum;
  std::vector<double> coefficients;
  for (std::size_t i = 0; i < x.size(); ++i) {
    coefficients.push_back(weights[i] * (x[i] - mean));
    spread += weights[i] * (x[i] - mean) * (x[i] - mean);
  }
  if (!(spread > 1e-12 * sum)) return {};
  for (double& c : coefficients) c /= spread;
  return coefficients;
}

// A linear function of log m of the points, with its draws.
struct Linear {
  double value = not_known;
  Draws draws{};
};
Linear applied(const std::vector<Point>& points, const std::vector<double>& coefficients) {
  if (coefficients.empty()) return {};
  Linear result{0, {}};
  bool drawn = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.value += coefficients[i] * points[i].log_mse;
    drawn = drawn && !points[i].cell->draws.empty();
  }
  if (!drawn) return result;
  result.draws.assign(draw_count, 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t d = 0; d < draw_count; ++d)
      result.draws[d] += coefficients[i] * std::log(points[i].cell->draws[d]);
  for (double& draw : result.draws)
    if (!std::isfinite(draw)) draw = not_known;
  return result;
}

Measured slope_over(const std::vector<Point>& points, const std::vector<double>& weights,
                    double Point::*x) {
  std::vector<double> abscissae;
  for (const Point& point : points) abscissae.push_back(point.*x);
  if (abscissae.empty()) return {};
  std::vector<double> coefficients = slope_coefficients(abscissae, weights);
  for (double& c : coefficients) c /= 2;  // log RMSE = log m / 2
  const Linear slope = applied(points, coefficients);
  return measured(slope.value, slope.draws);
}

bool compatible(const Measured& slope) {
  if (std::isnan(slope.value)) return true;  // a single budget says nothing against it
  if (std::abs(slope.value - slope_of_unbiased) <= near_enough) return true;
  return slope.interval.low <= slope_of_unbiased && slope_of_unbiased <= slope.interval.high;
}

// What runs of `first` to `last` seconds can tell of a time: 0 if the first is enough.
double within_reach(double seconds, double first, double last) {
  if (seconds <= first) return 0;
  return seconds <= farthest * last ? seconds : std::numeric_limits<double>::infinity();
}

template <class Better>
double run_of(const Comparison& comparison, std::size_t contender, Better better) {
  double found = not_known;
  for (const Cell& cell : comparison.cells)
    if (cell.contender == contender && cell.relative_rmse.value > 0 && cell.seconds.value > 0)
      found = better(found, cell.seconds.value);
  return found;
}

Measured by_constant(const std::vector<Point>& points, const std::vector<double>& weights,
                     double target) {
  double sum = 0, mean_log_seconds = 0;
  for (const double weight : weights) sum += weight;
  std::vector<double> coefficients;
  for (std::size_t i = 0; i < points.size(); ++i) {
    coefficients.push_back(weights[i] / sum);
    mean_log_seconds += coefficients[i] * points[i].log_seconds;
  }
  const Linear log_mse = applied(points, coefficients);
  const double first = std::exp(points.front().log_seconds);
  const double last = std::exp(points.back().log_seconds);
  const auto seconds = [&](double log_m) {
    return std::isnan(log_m)
               ? log_m
               : within_reach(std::exp(log_m + mean_log_seconds) / (target * target), first, last);
  };
  Draws draws = log_mse.draws;
  for (double& draw : draws) draw = seconds(draw);
  return measured(seconds(log_mse.value), draws);
}

Measured by_interpolation(const std::vector<Point>& points, double target) {
  const double log_target = 2 * std::log(target);
  Draws draws;
  if (std::ranges::none_of(points, [](const Point& p) { return p.cell->draws.empty(); }))
    for (std::size_t d = 0; d < draw_count; ++d)
      draws.push_back(seconds_below(path_of(points, d), log_target));
  return measured(seconds_below(path_of(points), log_target), draws);
}

double replicate_seconds(const std::vector<ReplicatePoint>& points, const Curve& curve,
                         double target) {
  double constant = 0, last = 0, first = std::numeric_limits<double>::infinity();
  Path path;
  for (const ReplicatePoint& p : points) {
    constant += p.relative_mse * p.seconds / static_cast<double>(points.size());
    first = std::min(first, p.seconds);
    last = std::max(last, p.seconds);
    if (p.relative_mse > 0) path.push_back({std::log(p.seconds), std::log(p.relative_mse)});
  }
  if (curve.inverse_root)
    return within_reach(std::max(constant, 0.0) / (target * target), first, last);
  std::ranges::sort(path, {}, &Knot::log_seconds);
  return seconds_below(path, 2 * std::log(target));
}

}  // namespace

double longest_run(const Comparison& comparison, std::size_t contender) {
  return run_of(comparison, contender, [](double a, double b) { return std::fmax(a, b); });
}

double shortest_run(const Comparison& comparison, std::size_t contender) {
  return run_of(comparison, contender, [](double a, double b) { return std::fmin(a, b); });
}

bool is_extrapolated(const Comparison& comparison, const Curve& curve) {
  return curve.seconds_to_target.value > longest_run(comparison, curve.contender);
}

double round_target(const Measurements& all, std::size_t budget) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < all.contenders; ++c) {
    const double error = all.at(c, budget).cell.relative_rmse.value;
    if (error > 0) least = std::min(least, error);
  }
  if (!std::isfinite(least)) return not_known;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= least) return step * power;
  return 10 * power;
}

Curve measure_curve(const Measurements& all, std::size_t contender, double target) {
  Curve curve;
  curve.contender = contender;
  const std::vector<Point> points = points_of(all, contender);
  std::vector<double> weights;
  for (const Point& point : points) weights.push_back(weight_of(point));
  curve.slope_time = slope_over(points, weights, &Point::log_seconds);
  curve.slope_samples = slope_over(points, weights, &Point::log_samples);
  curve.inverse_root = compatible(curve.slope_time);
  if (points.empty() || std::isnan(target)) return curve;
  curve.seconds_to_target =
      curve.inverse_root ? by_constant(points, weights, target) : by_interpolation(points, target);
  return curve;
}

Profile measure_profile(const std::vector<std::vector<ReplicatePoint>>& replicates,
                        const Curve& curve, double target) {
  Profile profile;
  profile.contender = curve.contender;
  std::size_t measured = 0;
  for (const auto& points : replicates) {
    if (points.empty()) continue;
    ++measured;
    const double seconds = replicate_seconds(points, curve, target);
    if (std::isfinite(seconds)) profile.seconds.push_back(seconds);
  }
  std::ranges::sort(profile.seconds);
  for (std::size_t i = 0; i < profile.seconds.size(); ++i)
    profile.share.push_back(static_cast<double>(i + 1) / static_cast<double>(measured));
  return profile;
}

}  // namespace wander::compare

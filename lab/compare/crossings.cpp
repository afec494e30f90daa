#include "lab/compare/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wander::compare {

namespace {

constexpr double significance = 0.05;

// Ties count for both sides; the estimate itself is one more draw.
double p_value(const Draws& ratios) {
  if (ratios.empty()) return not_known;
  std::size_t at_most = 1, at_least = 1;
  for (const double ratio : ratios) {
    if (!(ratio > 1)) ++at_most;
    if (!(ratio < 1)) ++at_least;
  }
  const auto smaller = static_cast<double>(std::min(at_most, at_least));
  return std::min(1.0, 2 * smaller / static_cast<double>(ratios.size() + 1));
}

Draws ratios_of(const Draws& above, const Draws& below) {
  if (above.empty() || below.empty()) return {};
  Draws ratios(above.size());
  for (std::size_t i = 0; i < ratios.size(); ++i)
    ratios[i] = above[i] == below[i] ? 1 : above[i] / below[i];
  return ratios;
}

Measured time_ahead(const std::vector<Point>& ahead, const std::vector<Point>& behind) {
  const double value = seconds_ahead(path_of(ahead), path_of(behind));
  if (!std::isfinite(value)) return {};
  Draws draws;
  for (std::size_t d = 0; d < draw_count; ++d)
    draws.push_back(seconds_ahead(path_of(ahead, d), path_of(behind, d)));
  return measured(value, draws);
}

Crossing measure_pair(const Measurements& all, const std::vector<std::vector<Point>>& points,
                      std::size_t ahead, std::size_t behind, std::size_t budget) {
  Crossing crossing;
  crossing.ahead = ahead;
  crossing.behind = behind;
  crossing.seconds = time_ahead(points[ahead], points[behind]);
  const MeasuredCell &a = all.at(ahead, budget), &b = all.at(behind, budget);
  // Black films are all alike, and say nothing of how far those of a longer run are off.
  if (a.cell.is_dark || b.cell.is_dark) return crossing;
  Draws ratios = ratios_of(b.draws, a.draws);
  crossing.p_value = p_value(ratios);
  if (!(a.relative_mse > 0)) return crossing;
  const double ratio = std::max(b.relative_mse, 0.0) / a.relative_mse;
  const double times = b.cell.seconds.value / a.cell.seconds.value;
  crossing.speedup = measured(ratio, ratios);
  for (double& r : ratios) r *= times;
  crossing.efficiency = measured(ratio * times, ratios);
  return crossing;
}

}  // namespace

std::vector<std::size_t> ranking_at(const Measurements& all, std::size_t budget) {
  std::vector<std::size_t> ranking(all.contenders);
  std::iota(ranking.begin(), ranking.end(), std::size_t{0});
  const auto error = [&](std::size_t contender) {
    const MeasuredCell& cell = all.at(contender, budget);
    if (cell.cell.is_dark)
      return std::numeric_limits<double>::max();  // behind all that found light
    // Of a dark reference there are no relative errors.
    const double square = std::isnan(cell.relative_mse) ? cell.cell.rmse.value : cell.relative_mse;
    return std::isnan(square) ? std::numeric_limits<double>::infinity() : square;
  };
  std::ranges::stable_sort(ranking, {}, error);
  return ranking;
}

std::vector<double> holm(const std::vector<double>& p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto known = [&](std::size_t i) { return std::isnan(p_values[i]) ? 1 : p_values[i]; };
  std::ranges::stable_sort(order, {}, known);
  std::vector<double> adjusted = p_values;
  double largest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto left = static_cast<double>(order.size() - k);
    largest = std::max(largest, std::min(1.0, left * known(order[k])));
    if (!std::isnan(p_values[order[k]])) adjusted[order[k]] = largest;
  }
  return adjusted;
}

std::vector<Crossing> measure_crossings(const Measurements& all,
                                        const std::vector<std::size_t>& ranking,
                                        std::size_t budget) {
  std::vector<std::vector<Point>> points;
  for (std::size_t c = 0; c < all.contenders; ++c) points.push_back(points_of(all, c));
  std::vector<Crossing> crossings;
  std::vector<double> p_values;
  for (std::size_t i = 0; i < ranking.size(); ++i)
    for (std::size_t j = i + 1; j < ranking.size(); ++j) {
      crossings.push_back(measure_pair(all, points, ranking[i], ranking[j], budget));
      p_values.push_back(crossings.back().p_value);
    }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    crossings[i].p_value = adjusted[i];
    crossings[i].significant = adjusted[i] <= significance;
  }
  return crossings;
}

}  // namespace wander::compare

#include "draw/report/bins.h"

#include <algorithm>
#include <cmath>

#include "draw/figure/film_series.h"

namespace wander::report {
namespace {

double mean_of(std::span<const double> values, std::span<const double> weights, double least_weight,
               std::size_t first, std::size_t end) {
  double sum = 0, weight = 0;
  for (std::size_t k = first; k < end; ++k) {
    const double w = weights.empty() ? 1 : weights[k];
    if (!std::isfinite(values[k]) || !(w > 0)) continue;
    sum += w * values[k];
    weight += w;
  }
  return weight > 0 && weight >= least_weight ? sum / weight : not_known;
}

}  // namespace

figure::Dimension film_dimension(const Subject& subject) {
  const figure::FilmAxes axes = figure::film_axes(subject.scene);
  return {.quantity = axes.position, .range = axes.extent};
}

std::vector<figure::Point> steps_over_film(const Subject& subject, std::span<const double> values,
                                           std::span<const double> weights, double least_weight,
                                           std::size_t most) {
  const figure::Range extent = figure::film_axes(subject.scene).extent;
  const std::size_t bins = values.size();
  const std::size_t per_step = std::max<std::size_t>(1, (bins + most - 1) / most);
  const auto place = [&](std::size_t bin) {
    return extent.low + extent.width() * static_cast<double>(bin) / static_cast<double>(bins);
  };
  std::vector<figure::Point> points;
  for (std::size_t first = 0; first < bins; first += per_step) {
    const std::size_t end = std::min(bins, first + per_step);
    const double mean = mean_of(values, weights, least_weight, first, end);
    // Both ends of the step, so that it has its width even where a gap follows.
    points.push_back({.x = place(first), .y = mean});
    points.push_back({.x = place(end), .y = mean});
  }
  return points;
}

std::vector<figure::Point> steps_over_film(const Subject& subject, std::span<const double> values,
                                           std::size_t most) {
  return steps_over_film(subject, values, {}, 0, most);
}

}  // namespace wander::report

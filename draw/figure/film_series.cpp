#include "draw/figure/film_series.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/film_statistics.h"
#include "draw/figure/curve.h"

namespace wander::figure {
namespace {

struct Sums {
  double value = 0, half_width = 0;
  std::size_t values = 0, widths = 0, reliable = 0;
};

Sums sum_bins(const FilmEstimate& film, std::size_t first, std::size_t end, double quantile) {
  Sums sums;
  for (std::size_t k = first; k < end; ++k) {
    if (!std::isfinite(film.value[k])) continue;
    sums.value += film.value[k];
    ++sums.values;
    const double half_width = quantile * film.standard_error[k];
    if (std::isfinite(half_width)) {
      sums.half_width += half_width;
      ++sums.widths;
    }
    if (film.reliable.empty() || film.reliable[k]) ++sums.reliable;
  }
  return sums;
}

Bar mean_bar(const Sums& sums, Range position) {
  const auto count = static_cast<double>(sums.values);
  Bar bar{position, sums.value / count, std::nullopt, Trust::unreliable};
  if (sums.widths == sums.values) bar.half_width = sums.half_width / count;
  if (bar.half_width && sums.reliable == sums.values) bar.trust = Trust::reliable;
  return bar;
}

double high_end(const Bar& bar) { return bar.value + bar.half_width.value_or(0); }
double low_end(const Bar& bar) { return bar.value - bar.half_width.value_or(0); }

std::vector<Bar> reliable_bars(const std::vector<Bar>& film) {
  std::vector<Bar> bars;
  std::copy_if(film.begin(), film.end(), std::back_inserter(bars),
               [](const Bar& bar) { return bar.trust == Trust::reliable; });
  return bars;
}

std::vector<Bar> without_highest_tenth(std::vector<Bar> bars) {
  std::sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) { return a.value < b.value; });
  bars.resize(bars.size() - bars.size() / 10);
  return bars;
}

// When nothing is trusted: up to the value that one bar in ten exceeds, and half as much again.
Range range_of_unreliable(std::span<const std::vector<Bar>> films) {
  std::vector<double> values;
  for (const std::vector<Bar>& film : films)
    for (const Bar& bar : film) values.push_back(bar.value);
  if (values.empty()) return {0, 1};
  const auto most =
      values.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), most, values.end());
  const double largest = *std::max_element(values.begin(), values.end());
  return {0, *most > 0 ? std::min(largest, 1.5 * *most) : largest};
}

// Of all that is drawn, what a tenth lies below and what a tenth lies above.
Range tenths(std::span<const std::vector<Bar>> films) {
  std::vector<double> values;
  for (const std::vector<Bar>& film : films)
    for (const Bar& bar : film) values.push_back(bar.value);
  if (values.empty()) return {INFINITY, -INFINITY};
  std::ranges::sort(values);
  const std::size_t tenth = values.size() / 10;
  return {values[tenth], values[values.size() - 1 - tenth]};
}

}  // namespace

std::size_t bins_per_bar(std::size_t bins, std::size_t most) {
  return std::max<std::size_t>(1, (bins + most - 1) / most);
}

double mean_half_width(std::span<const Bar> bars) {
  double sum = 0;
  std::size_t count = 0;
  for (const Bar& bar : bars) {
    sum += bar.half_width.value_or(0);
    count += bar.half_width ? 1 : 0;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

std::vector<Bar> bars_of(const FilmEstimate& film, Range position, std::size_t most) {
  const std::size_t bins = film.value.size(), per_bar = bins_per_bar(bins, most);
  const double quantile = student_t_95(film.degrees_of_freedom);
  const auto place = [&](std::size_t bin) {
    return position.low + position.width() * static_cast<double>(bin) / static_cast<double>(bins);
  };
  std::vector<Bar> bars;
  for (std::size_t first = 0; first < bins; first += per_bar) {
    const std::size_t end = std::min(bins, first + per_bar);
    const Sums sums = sum_bins(film, first, end, quantile);
    if (sums.values > 0) bars.push_back(mean_bar(sums, {place(first), place(end)}));
  }
  return bars;
}

Range value_range(std::span<const std::vector<Bar>> films, std::span<const Bar> reference) {
  std::vector<Bar> shown(reference.begin(), reference.end()), expected = shown;
  for (const std::vector<Bar>& film : films) {
    const std::vector<Bar> trusted = reliable_bars(film);
    const std::vector<Bar> usual = reference.empty() ? trusted : without_highest_tenth(trusted);
    shown.insert(shown.end(), trusted.begin(), trusted.end());
    expected.insert(expected.end(), usual.begin(), usual.end());
  }
  if (shown.empty()) return range_of_unreliable(films);

  Range values{INFINITY, -INFINITY}, bands = values;
  for (const Bar& bar : expected)
    values = {std::min(values.low, bar.value), std::max(values.high, bar.value)};
  for (const Bar& bar : shown)
    bands = {std::min(bands.low, low_end(bar)), std::max(bands.high, high_end(bar))};
  // A very wide band is cut: the values are what the figure is about.
  const double room = 0.4 * values.high;
  Range range{std::max(bands.low, values.low - room), std::min(bands.high, values.high + room)};
  // Where more than a tenth of all that is drawn lies beyond the axis, the axis is longer, but not
  // so long that the best known film becomes a line.
  const Range most = tenths(films);
  range = {std::min(range.low, most.low), std::clamp(most.high, range.high, 2 * range.high)};
  // Zero belongs to the axis of a non-negative quantity, unless that would squash all there is.
  const bool near_zero = range.low < 0.6 * range.high;
  const double headroom = 0.04 * (range.high - (near_zero ? 0 : range.low));
  return {near_zero ? std::min(0., values.low) : range.low - headroom, range.high + headroom};
}

Range log_value_range(std::span<const std::vector<Bar>> films, std::span<const Bar> reference) {
  Range all{INFINITY, -INFINITY}, trusted = all;
  const auto include = [](Range& range, double value) {
    if (!(value > 0)) return;
    range = {std::min(range.low, value), std::max(range.high, value)};
  };
  const auto include_bars = [&](std::span<const Bar> bars) {
    for (const Bar& bar : bars) {
      include(all, bar.value);
      if (bar.trust == Trust::reliable) include(trusted, high_end(bar));
    }
  };
  include_bars(reference);
  for (const std::vector<Bar>& film : films) include_bars(film);
  if (all.low > all.high) return {0.1, 1};
  const double high = trusted.low < trusted.high ? trusted.high : all.high;
  constexpr double depth = 1e6, room = 1.2;
  return {std::clamp(all.low, high / depth, high / 10) / room, high * room};
}

FilmAxes film_axes(const description::Scene& scene) {
  if (scene.dimension == 3)
    return {
        {"position on the sensor", ""},
        scene.camera ? Quantity{"mean radiance", "W/(m²·sr)"} : Quantity{"mean irradiance", "W/m²"},
        {0, 1}};
  if (scene.camera) return {{"position on the sensor", ""}, {"mean radiance", "W/(m·rad)"}, {0, 1}};
  double size = 0;
  for (const description::Shape& shape : scene.shapes) {
    if (!shape.sensor) continue;
    for (const Curve& curve : curves(shape.kind)) size += length(curve);
  }
  return {{"position on the sensor", "m"}, {"mean irradiance", "W/m"}, {0, size}};
}

}  // namespace wander::figure

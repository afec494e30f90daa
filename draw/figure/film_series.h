// A film made ready for drawing: bars over positions, 95 % intervals, and the range of values that
// shows it best.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/description.h"
#include "draw/figure/axis.h"
#include "records/rendering.h"

namespace wander::figure {

enum class Trust { reliable, unreliable };

// One bin, or several that the page could not tell apart.
struct Bar {
  Range position;
  double value = 0;
  std::optional<double> half_width;  // of the 95 % t-interval; nothing when it cannot be told
  Trust trust = Trust::reliable;
};

// Bars from left to right over `position`; bins without a finite value are left out.  At most
// `most`: neighbours are merged into their mean, with the mean of their half widths, which is
// right for errors that go together and wide for errors that do not.
inline constexpr std::size_t most_bars = 600;
std::size_t bins_per_bar(std::size_t bins, std::size_t most = most_bars);
std::vector<Bar> bars_of(const FilmEstimate& film, Range position, std::size_t most = most_bars);

// Of the bars whose half width is known; 0 when there is none.
double mean_half_width(std::span<const Bar> bars);

// From the reliable bars: what is not trusted must not flatten the rest.  Where a reference tells
// what to expect, the highest tenth of a film stretches the axis by little.
Range value_range(std::span<const std::vector<Bar>> films, std::span<const Bar> reference);
// The same for a logarithmic axis: all that is above zero, up to six powers of ten deep.
Range log_value_range(std::span<const std::vector<Bar>> films, std::span<const Bar> reference);

// What the axes of a film mean.
struct FilmAxes {
  Quantity position{"position on the sensor", ""}, value{"value", ""};
  Range extent{0, 1};  // of the positions
};
FilmAxes film_axes(const description::Scene& scene);

}  // namespace wander::figure

// A quantity over the plane as a picture, on a logarithmic scale that its legend shows: light falls
// off with distance and loses a share at every reflection, so equal ratios are to be equal steps.
//
// The picture is an image within the figure, one pixel to a cell.
#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/plane_grid.h"
#include "draw/figure/axis.h"
#include "draw/figure/colour_map.h"

namespace wander::figure {

// Values from `low` to `high` on a logarithmic scale; what is beyond has the colour of the end.
struct ToneScale {
  Range domain;

  // The index of a colour; 0 also for what is no light.
  std::uint8_t tone(double value) const;
};

// From the values that few cells exceed, down by three powers of ten at most and one at least.
ToneScale tone_scale(std::span<const double> values);

// `low` and `high` are the lower left and the upper right corner of the grid on the page.
void draw_tones(Svg& svg, std::span<const double> values, const PlaneGrid& grid,
                const ToneScale& scale, const ColourMap& colours, Vector low, Vector high);

// The legend: all colours side by side over an axis.
inline constexpr double tone_legend_height = 36;
void draw_tone_legend(Svg& svg, const ToneScale& scale, const ColourMap& colours,
                      const Quantity& quantity, Vector top_left, double width);

}  // namespace wander::figure

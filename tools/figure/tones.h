// A quantity over the plane as a raster of tones, on a logarithmic scale that its legend shows.
//
// The raster is vector: one path for each tone, a stroke of horizontal runs of cells, so that it
// needs no image format, stays sharp, and is small.
#pragma once

#include <span>

#include "core/plane_grid.h"
#include "tools/figure/axis.h"
#include "tools/figure/style.h"

namespace wander::figure {

inline constexpr int tone_count = 20;

// Values from `low` to `high` on a logarithmic scale; what is beyond has the tone of the end.
struct ToneScale {
  Range domain;

  int tone(double value) const;  // of a cell, 0 … tone_count - 1; 0 also for what is no light
};

// From the values that few cells exceed, down by three powers of ten at most and one at least.
ToneScale tone_scale(std::span<const double> values);

// `low` and `high` are the lower left and the upper right corner of the grid on the page.
void draw_tones(Svg& svg, std::span<const double> values, const PlaneGrid& grid,
                const ToneScale& scale, const style::Shading& shading, Vector low, Vector high);

// The legend: all tones side by side over an axis.
inline constexpr double tone_legend_height = 36;
void draw_tone_legend(Svg& svg, const ToneScale& scale, const style::Shading& shading,
                      const Quantity& quantity, Vector top_left, double width);

}  // namespace wander::figure

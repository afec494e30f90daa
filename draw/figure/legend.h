// A legend: samples of the marks of a figure, each with a few words.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "draw/figure/svg.h"

namespace wander::figure {

inline constexpr double swatch_width = 18;

struct LegendEntry {
  // Draws a sample `swatch_width` wide, given the middle of its left edge.
  std::function<void(Svg&, Vector)> draw_swatch;
  std::string text;
};

// Entries in columns, one column after the other, in as few rows as the width allows.
double legend_height(const std::vector<LegendEntry>& entries, double width);
void draw_legend(Svg& svg, const std::vector<LegendEntry>& entries, Vector top_left, double width);

}  // namespace wander::figure

// One panel of a film figure: films as step lines with shaded intervals, over shared axes.
//
// Bins that are not to be trusted have a hatched band and a hollow dot; where a value lies beyond
// the axis an arrow head stands at the edge.
#pragma once

#include <span>
#include <vector>

#include "draw/figure/chart_axes.h"
#include "draw/figure/film_series.h"
#include "draw/figure/style.h"

namespace wander::figure {

struct Trace {
  std::vector<Bar> bars;
  style::Stroke stroke;
};

struct Panel {
  LinearScale x;
  ChartAxis y;
  Range values;  // from end to end of y

  bool is_above(double value) const { return value > values.high; }
  bool is_below(double value) const { return value < values.low; }
  bool is_beyond(double value) const { return is_above(value) || is_below(value); }
  // On the page, kept near the panel however large the value: the clip path cuts the rest.
  double height(double value) const;
};

void define_hatching(Svg& svg, std::span<const style::Stroke> strokes);

void draw_traces(Svg& svg, const Panel& panel, std::span<const Trace> traces,
                 std::span<const Bar> reference);

// Samples for the legend, from the middle of their left edge.
void draw_trace_swatch(Svg& svg, Vector left, const style::Stroke& stroke);
void draw_band_swatch(Svg& svg, Vector left, const style::Stroke& stroke);
void draw_reference_swatch(Svg& svg, Vector left);
void draw_unreliable_swatch(Svg& svg, Vector left, const style::Stroke& stroke);
void draw_above_swatch(Svg& svg, Vector left, const style::Stroke& stroke);
void draw_below_swatch(Svg& svg, Vector left, const style::Stroke& stroke);

}  // namespace wander::figure

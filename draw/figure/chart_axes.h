// The axes of a chart: ranges that hold the data, linear or logarithmic.
#pragma once

#include "draw/figure/chart.h"

namespace wander::figure {

// An axis with its spacing: where a value lies on the page, if the axis can show it at all.
struct ChartAxis {
  Axis axis;
  Spacing spacing = Spacing::linear;

  bool shows(double value) const;
  double operator()(double value) const;  // within a little of the page, however large
};

Range x_range(const Chart& chart);
Range y_range(const Chart& chart);
ChartAxis chart_axis(const Dimension& dimension, Range range, Range page, int at_most_ticks);

}  // namespace wander::figure

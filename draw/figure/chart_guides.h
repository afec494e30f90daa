// The guides of a chart: dashed lines at a value, with a few words.
#pragma once

#include "draw/figure/chart_axes.h"

namespace wander::figure {

void draw_guide(Svg& svg, Vector from, Vector to);

// Vertical guides run through all panels.  Their labels stand above the panels, one below the
// other, and take this height.
double guides_height(const Chart& chart, const ChartAxis& x);
void draw_vertical_guides(Svg& svg, const Chart& chart, const ChartAxis& x, double top,
                          double bottom);

}  // namespace wander::figure

// What of a line lies within a rectangle of the page.
#pragma once

#include <string>
#include <vector>

#include "draw/figure/svg.h"

namespace wander::figure {

// A part of the page, in points.
struct Window {
  Vector low, high;

  Vector size() const { return high - low; }
};

bool holds(const Window& window, Vector point);
// The last point of the line from a, which lies within, towards b that still does.
Vector last_within(Vector a, Vector b, const Window& window);
// Path data of the parts of a polyline that lie within.
std::string clipped(const std::vector<Vector>& line, const Window& window);

}  // namespace wander::figure

// Axes: ticks at 1, 2 or 5 times a power of ten, a linear scale, and titles with units.
//
// Quantities of any size: values beyond 10^4 or below 10^-2 are labelled in a power of ten that the
// title names ("x, 10⁻⁹ m"), and a range far from zero is labelled from an offset that the title
// names too ("x − 1000000, m").
#pragma once

#include <string>
#include <vector>

#include "draw/figure/svg.h"

namespace wander::figure {

struct Range {
  double low = 0, high = 1;
  double width() const { return high - low; }
};

// The same range where it can carry ticks; widened where it is empty or too narrow for doubles.
Range usable(Range range);

struct Ticks {
  double step = 1;
  std::vector<double> values;  // multiples of `step` in the range, ascending
};

// As many ticks as possible, but no more than `at_most` (at least 2).
Ticks nice_ticks(Range range, int at_most);

struct LinearScale {
  Range domain, page;
  double operator()(double value) const {
    return page.low + (value - domain.low) / domain.width() * page.width();
  }
};

struct Quantity {
  std::string name, unit;  // no unit: a pure number
};

struct Axis {
  LinearScale scale;
  std::vector<double> ticks;
  std::vector<std::string> labels;  // one for each tick
  std::string title;

  double label_width() const;  // of the widest
};
Axis make_axis(const Quantity& quantity, Range domain, Range page, int at_most_ticks);

// Labels at the powers of ten, and between them at 2 and 5 where there is room; the scale takes
// log10 of a value.  The range is positive.
Axis make_log_axis(const Quantity& quantity, Range domain, Range page);

// The line, its ticks and labels, on the page at height `y` (labels below) or at `x` (labels left).
void draw_bottom_axis(Svg& svg, const Axis& axis, double y);
void draw_left_axis(Svg& svg, const Axis& axis, double x);
// Titles stand alone, because several panels may share one.
void draw_bottom_title(Svg& svg, const Axis& axis, double y);
void draw_left_title(Svg& svg, const Axis& axis, double x);

// Room, in points, for the labels and the title of the bottom axis; for ticks and gaps of the left.
inline constexpr double bottom_axis_height = 26;
inline constexpr double left_axis_gap = 17;

}  // namespace wander::figure

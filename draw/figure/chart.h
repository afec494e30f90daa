// A chart: series of points with intervals in one panel, or in several over one another that share
// their horizontal axis.  Linear or logarithmic axes; points that an axis cannot show are left out,
// and break the line.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "draw/figure/axis.h"
#include "draw/figure/block.h"
#include "draw/figure/marker.h"

namespace wander::figure {

struct Point {
  double x = 0, y = 0;
  std::optional<Range> x_interval{}, y_interval{};
};

// A staircase keeps the height of a point up to the next.  A distribution is one that comes from
// zero at the left end of the axis, and goes on to its right end.
enum class Connection { none, line, staircase, distribution };
enum class Marks { none, each_point };

struct Series {
  std::string label{};  // empty: not in the legend
  std::vector<Point> points{};
  Look look{};
  Connection connection = Connection::line;
  Marks marks = Marks::each_point;
  double width = 1.1;  // of the line
  // What lies beyond this x is extrapolated: dotted, with open marks.
  double measured_to = INFINITY;
};

// A line across at a value, with a few words at its end.
struct Guide {
  double at = 0;
  std::string label{};
};

// Whole: linear, with ticks at whole numbers only.
enum class Spacing { linear, whole, logarithmic };

// No range: what the points and guides need, with some room.
struct Dimension {
  Quantity quantity{};
  Spacing spacing = Spacing::linear;
  std::optional<Range> range{};
};

struct ChartPanel {
  std::string heading{};  // empty: none
  std::vector<Series> series{};
  std::vector<Guide> guides{};  // horizontal
  std::optional<Range> band{};  // shaded: heights where points are expected
  std::string empty_note{};     // written where nothing can be drawn
};

struct Chart {
  Dimension x{}, y{};  // y: of all panels
  std::vector<ChartPanel> panels{};
  std::vector<Guide> guides{};  // vertical, through all panels
  double panel_height = 170;
  double label_room = 0;  // for y's labels at least, so that charts one below the other are in line
};

Block chart_block(Chart chart, double width);

}  // namespace wander::figure

// Numbers with intervals, one below the other over a shared axis, in groups with a heading each:
// what several estimates of one thing say.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/figure/chart.h"

namespace wander::figure {

struct IntervalRow {
  std::string label;
  double value = 0;  // not finite: nothing is drawn but the note
  std::optional<Range> interval{};
  Look look{};
  std::string note{};  // at the right, such as the number in figures
};

struct IntervalGroup {
  std::string heading;
  std::vector<IntervalRow> rows{};
};

struct IntervalRows {
  Dimension x;
  std::vector<IntervalGroup> groups{};
  std::optional<Range> band{};  // shaded through all rows: what they are held against
  std::string band_label{};
};

Block interval_block(IntervalRows rows, double width);

}  // namespace wander::figure

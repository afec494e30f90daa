#include "draw/figure/legend.h"

#include <algorithm>

#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double swatch_gap = 4, column_gap = 8, row_height = 12.5, line_height = 8.5;

struct Columns {
  std::size_t rows = 1;
  std::vector<double> widths;  // of the widest entry, the gap to the next column included

  double width() const {
    double sum = -column_gap;
    for (const double w : widths) sum += w;
    return sum;
  }
};

Columns columns_of(const std::vector<LegendEntry>& entries, std::size_t rows) {
  Columns columns{rows, {}};
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k % rows == 0) columns.widths.push_back(0);
    const double width =
        swatch_width + swatch_gap + column_gap + text_width(entries[k].text, style::small_size);
    columns.widths.back() = std::max(columns.widths.back(), width);
  }
  return columns;
}

Columns arrange(const std::vector<LegendEntry>& entries, double width) {
  for (std::size_t rows = 1; rows < entries.size(); ++rows)
    if (Columns columns = columns_of(entries, rows); columns.width() <= width) return columns;
  Columns single = columns_of(entries, std::max<std::size_t>(1, entries.size()));
  for (double& w : single.widths) w = std::min(w, width + column_gap);
  return single;
}

double room_for_text(double column_width) {
  // Half a point more, for sums that do not add up to the last bit.
  return column_width - swatch_width - swatch_gap - column_gap + 0.5;
}

std::vector<std::string> lines_of(const LegendEntry& entry, double column_width) {
  return wrapped(entry.text, style::small_size, room_for_text(column_width));
}

double height_of(const LegendEntry& entry, double column_width) {
  return row_height + line_height * static_cast<double>(lines_of(entry, column_width).size() - 1);
}

void draw_entry(Svg& svg, const LegendEntry& entry, Vector top_left, double column_width) {
  Vector left = top_left + Vector{0, row_height / 2};
  entry.draw_swatch(svg, left);
  left += Vector{swatch_width + swatch_gap, 0.36 * style::small_size};
  for (const std::string& line : lines_of(entry, column_width)) {
    svg.text(left, line, {.size = style::small_size});
    left.y += line_height;
  }
}

}  // namespace

// Only a single column is ever too narrow for a text.
double legend_height(const std::vector<LegendEntry>& entries, double width) {
  if (entries.empty()) return 0;
  const Columns columns = arrange(entries, width);
  if (columns.widths.size() > 1) return row_height * static_cast<double>(columns.rows);
  double height = 0;
  for (const LegendEntry& entry : entries) height += height_of(entry, columns.widths.front());
  return height;
}

void draw_legend(Svg& svg, const std::vector<LegendEntry>& entries, Vector top_left, double width) {
  const auto scope = svg.group("legend");
  if (entries.empty()) return;
  const Columns columns = arrange(entries, width);
  Vector at = top_left;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::size_t column = k / columns.rows;
    if (k % columns.rows == 0 && column > 0) at = {at.x + columns.widths[column - 1], top_left.y};
    draw_entry(svg, entries[k], at, columns.widths[column]);
    at.y += height_of(entries[k], columns.widths[column]);
  }
}

}  // namespace wander::figure

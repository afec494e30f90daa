#include "tools/figure/legend.h"

#include <algorithm>

#include "tools/figure/style.h"

namespace wander::figure {
namespace {

constexpr double swatch_gap = 4, column_gap = 8, row_height = 12.5;

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

}  // namespace

double legend_height(const std::vector<LegendEntry>& entries, double width) {
  return entries.empty() ? 0 : row_height * static_cast<double>(arrange(entries, width).rows);
}

void draw_legend(Svg& svg, const std::vector<LegendEntry>& entries, Vector top_left, double width) {
  const auto scope = svg.group("legend");
  const Columns columns = arrange(entries, width);
  Vector left = top_left;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::size_t column = k / columns.rows, row = k % columns.rows;
    if (row == 0 && column > 0) left.x += columns.widths[column - 1];
    left.y = top_left.y + (static_cast<double>(row) + 0.5) * row_height;
    entries[k].draw_swatch(svg, left);
    // Half a point more, for sums that do not add up to the last bit.
    const double room = columns.widths[column] - swatch_width - swatch_gap - column_gap + 0.5;
    svg.text(left + Vector{swatch_width + swatch_gap, 0.36 * style::small_size},
             shortened(entries[k].text, style::small_size, room), {.size = style::small_size});
  }
}

}  // namespace wander::figure

#include "draw/figure/interval_rows.h"

#include <algorithm>
#include <cmath>

#include "draw/figure/chart_axes.h"
#include "draw/figure/legend.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double row_height = 12, heading_height = 14, column_gap = 8, most_label_width = 130;
constexpr double legend_gap = 3;

// The points of a chart know how to find their range.
Range range_of(const IntervalRows& rows) {
  Series all;
  for (const IntervalGroup& group : rows.groups)
    for (const IntervalRow& row : group.rows)
      all.points.push_back({.x = row.value, .x_interval = row.interval});
  if (rows.band) all.points.push_back({.x = rows.band->low, .x_interval = rows.band});
  Chart chart;
  chart.x = rows.x;
  chart.panels = {ChartPanel{.series = {std::move(all)}}};
  return x_range(chart);
}

double widest(const IntervalRows& rows, std::string IntervalRow::*text) {
  double width = 0;
  for (const IntervalGroup& group : rows.groups)
    for (const IntervalRow& row : group.rows)
      width = std::max(width, text_width(row.*text, style::small_size));
  return width;
}

double rows_height(const IntervalRows& rows) {
  double height = 0;
  for (const IntervalGroup& group : rows.groups)
    height += heading_height + row_height * static_cast<double>(group.rows.size());
  return height;
}

std::vector<LegendEntry> legend_of(const IntervalRows& rows) {
  if (!rows.band) return {};
  return {{[](Svg& svg, Vector left) {
             svg.element("rect", {{"x", left.x},
                                  {"y", left.y - 4},
                                  {"width", swatch_width},
                                  {"height", 8},
                                  {"fill", style::neutral.colour},
                                  {"fill-opacity", 0.25}});
           },
           rows.band_label}};
}

void draw_row(Svg& svg, const IntervalRow& row, const ChartAxis& x, double y) {
  const auto scope = svg.group("row");
  const Range page = x.axis.scale.page;
  svg.line({page.low, y}, {page.high, y}, {{"stroke", style::faint}, {"stroke-width", 0.4}});
  if (!x.shows(row.value)) return;
  if (row.interval) {
    const auto end = [&](double value, double edge) {
      return x.shows(value) ? std::clamp(x(value), page.low, page.high) : edge;
    };
    svg.line({end(row.interval->low, page.low), y}, {end(row.interval->high, page.high), y},
             {{"class", "interval"}, {"stroke", row.look.stroke.colour}, {"stroke-width", 1.4}});
  }
  draw_marker(svg, {x(row.value), y}, row.look);
}

void draw_band(Svg& svg, const IntervalRows& rows, const ChartAxis& x, double top, double height) {
  if (!rows.band || !x.shows(rows.band->low) || !x.shows(rows.band->high)) return;
  // A line at least, where the interval is a point.
  const double left = x(rows.band->low), width = std::max(0.8, x(rows.band->high) - left);
  svg.element("rect", {{"class", "expected"},
                       {"x", left},
                       {"y", top},
                       {"width", width},
                       {"height", height},
                       {"fill", style::neutral.colour},
                       {"fill-opacity", 0.25}});
}

void draw(Svg& svg, const IntervalRows& rows, Vector top_left, double width) {
  const double labels = std::min(most_label_width, widest(rows, &IntervalRow::label));
  const double notes = widest(rows, &IntervalRow::note);
  const Range page{top_left.x + labels + 2 * column_gap, top_left.x + width - notes - column_gap};
  const ChartAxis x =
      chart_axis(rows.x, range_of(rows), page, std::max(2, static_cast<int>(page.width() / 45)));
  draw_band(svg, rows, x, top_left.y, rows_height(rows));
  const TextStyle small{.size = style::small_size};
  const double drop = 0.36 * style::small_size;
  double y = top_left.y;
  for (const IntervalGroup& group : rows.groups) {
    y += heading_height;
    svg.text({top_left.x, y - 4},
             shortened(group.heading, style::bold_width * style::small_size, width),
             {.size = style::small_size, .weight = "bold"});
    for (const IntervalRow& row : group.rows) {
      draw_row(svg, row, x, y + row_height / 2);
      svg.text({top_left.x + column_gap, y + row_height / 2 + drop},
               shortened(row.label, style::small_size, most_label_width), small);
      svg.text({top_left.x + width, y + row_height / 2 + drop}, row.note,
               {.size = style::small_size, .anchor = "end"});
      y += row_height;
    }
  }
  draw_bottom_axis(svg, x.axis, y + 3);
  draw_bottom_title(svg, x.axis, y + 3);
  draw_legend(svg, legend_of(rows), {page.low, y + 3 + bottom_axis_height + legend_gap},
              top_left.x + width - page.low);
}

}  // namespace

Block interval_block(IntervalRows rows, double width) {
  const double height = rows_height(rows) + 3 + bottom_axis_height + legend_gap +
                        legend_height(legend_of(rows), width);
  return {"", height, [=, rows = std::move(rows)](Svg& svg, Vector top_left) {
            draw(svg, rows, top_left, width);
          }};
}

}  // namespace wander::figure

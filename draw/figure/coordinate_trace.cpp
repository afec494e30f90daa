#include "draw/figure/coordinate_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "draw/figure/axis.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double panel_height = 44, rug_height = 7, rug_gap = 2, panel_gap = 13;
constexpr double row_height = panel_height + rug_gap + rug_height + panel_gap;
// Beyond this many steps several share a column.
constexpr int most_columns = 900;
constexpr double points_per_tick = 60;
// For half of the last label of the axis.
constexpr double right_room = 12;

constexpr std::array coordinates_of_film{style::accepted, style::rejected};

std::size_t axes_of(const Steps& steps) {
  return static_cast<std::size_t>(steps.trajectory().dimension - 1);
}

// The steps of one column of one chain.
struct Column {
  double first, last;  // draws, `last` not included
  double low = INFINITY, high = -INFINITY;
  double rejected = 0;  // share
};

std::vector<Column> columns_of(const Steps& steps, int chain, std::size_t axis) {
  const int draws = steps.draws(), count = std::min(draws, most_columns);
  const Trajectory& t = steps.trajectory();
  const auto axes = static_cast<std::size_t>(t.dimension - 1);
  std::vector<Column> columns;
  for (int c = 0; c < count; ++c) {
    const auto edge = [&](int k) {
      return steps.first() + static_cast<int>(std::int64_t{k} * draws / count);
    };
    Column column{static_cast<double>(edge(c)), static_cast<double>(edge(c + 1))};
    for (int draw = edge(c); draw < edge(c + 1); ++draw) {
      const std::size_t index = steps.index(chain, draw);
      const double u = t.state.film[index * axes + axis];
      if (std::isfinite(u)) {
        column.low = std::min(column.low, u);
        column.high = std::max(column.high, u);
      }
      if (t.accepted[index] == 0) column.rejected += 1;
    }
    column.rejected /= column.last - column.first;
    columns.push_back(column);
  }
  return columns;
}

struct Panel {
  LinearScale x, y;
  double rug;  // height on the page where the marks stand
};

// A step line; where a column holds several values, a bar between the extremes.
std::string line_data(const std::vector<Column>& columns, const Panel& panel) {
  std::string data;
  bool connected = false;
  for (const Column& column : columns) {
    if (column.low > column.high) {
      connected = false;
      continue;
    }
    const std::string low = number(panel.y(column.low)), high = number(panel.y(column.high));
    const std::string left = number(panel.x(column.first));
    data += connected ? "V" + low : "M" + left + " " + low;
    if (high != low) data += "V" + high;
    data += "H" + number(panel.x(column.last));
    connected = true;
  }
  return data;
}

std::string rug_data(const std::vector<Column>& columns, const Panel& panel) {
  std::string data;
  for (const Column& column : columns)
    if (column.rejected > 0)
      data += "M" + coordinates({panel.x((column.first + column.last) / 2), panel.rug}) + "v" +
              number(-rug_height * column.rejected);
  return data;
}

void draw_chain(Svg& svg, const Steps& steps, int chain, const Panel& panel) {
  const auto scope = svg.group("trace");
  const std::vector<Column> columns = columns_of(steps, chain, 0);
  for (std::size_t axis = 0; axis < axes_of(steps); ++axis)
    svg.path(line_data(columns_of(steps, chain, axis), panel),
             {{"class", "coordinate"},
              {"stroke", coordinates_of_film[axis].colour},
              {"stroke-dasharray", coordinates_of_film[axis].dashes},
              {"stroke-width", 0.7},
              {"fill", "none"}});
  const double step =
      panel.x.page.width() / std::max<double>(1, static_cast<double>(columns.size()));
  svg.path(rug_data(columns, panel), {{"class", "rejections"},
                                      {"stroke", style::rejected.colour},
                                      {"stroke-width", std::clamp(0.6 * step, 0.3, 1.2)},
                                      {"fill", "none"}});
  svg.text({panel.x.page.high, panel.y.page.high - 2}, fmt::format("chain {}", chain),
           {.size = style::small_size, .anchor = "end"});
}

Range steps_range(const Steps& steps) {
  return {steps.number(steps.first()), steps.number(steps.first() + std::max(1, steps.draws()))};
}

std::string heading_of(const Steps& steps, std::size_t shown) {
  std::string text =
      fmt::format("Position on the {}, {}; marks below: rejections",
                  axes_of(steps) > 1 ? "film, x solid and y dashed" : "sensor", in_words(steps));
  if (shown < steps.chains().size()) text += fmt::format(" (the first {} chains)", shown);
  return text;
}

}  // namespace

Block coordinate_trace(const Steps& steps, double width, int most_chains) {
  const std::vector<int> all(steps.chains().begin(), steps.chains().end());
  const std::vector<int> chains(all.begin(),
                                all.begin() + std::min(most_chains, static_cast<int>(all.size())));
  const double rows = static_cast<double>(chains.size()) * row_height;
  return {
      heading_of(steps, chains.size()), rows + bottom_axis_height, [=](Svg& svg, Vector top_left) {
        const double left = top_left.x + left_axis_gap + 16;
        const Range page{left, top_left.x + width - right_room};
        double top = top_left.y + panel_gap;
        const LinearScale draws{{static_cast<double>(steps.first()),
                                 static_cast<double>(steps.first() + std::max(1, steps.draws()))},
                                page};
        for (const int chain : chains) {
          const Axis y = make_axis({"u", ""}, {0, 1}, {top + panel_height, top}, 3);
          draw_left_axis(svg, y, left - 3);
          draw_left_title(svg, y, left - 3);
          draw_chain(svg, steps, chain,
                     {draws, y.scale, top + panel_height + rug_gap + rug_height});
          top += row_height;
        }
        const Range range = steps_range(steps);
        const double most_ticks = std::min(page.width() / points_per_tick, range.width() + 1);
        const Axis x =
            make_axis({"step of the chain", ""}, range, page, static_cast<int>(most_ticks));
        draw_bottom_axis(svg, x, top - panel_gap + 2);
        draw_bottom_title(svg, x, top - panel_gap + 2);
      }};
}

}  // namespace wander::figure

#include "draw/figure/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "draw/figure/chart_axes.h"
#include "draw/figure/chart_guides.h"
#include "draw/figure/legend.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double header = 12, panel_gap = 7, right_room = 10, legend_gap = 3;
constexpr double points_per_tick = 17;
constexpr double room = 3;

constexpr std::string_view extrapolated_dashes = "0.9 2.2";

struct Frame {
  ChartAxis x, y;
};

// The panel, with room for marks at its edge.
Range across(const Frame& frame) {
  const Range page = frame.x.axis.scale.page;
  return {page.low - room, page.high + room};
}

std::string define_clip(Svg& svg, const Frame& frame, Range x) {
  const Range y = frame.y.axis.scale.page;
  const std::string id =
      fmt::format("clip-{}-{}-{}", number(x.low), number(y.high), number(x.width()));
  if (!svg.is_new(id)) return id;
  const auto scope = svg.open("clipPath", {{"id", id}});
  svg.element("rect", {{"x", x.low},
                       {"y", y.high - room},
                       {"width", x.width()},
                       {"height", y.low - y.high + 2 * room}});
  return id;
}

std::string path_data(const Series& series, const Frame& frame) {
  const bool stairs = series.connection != Connection::line;
  const Range x = frame.x.axis.scale.page;
  std::string data;
  bool drawing = series.connection == Connection::distribution;
  if (drawing) data = "M" + coordinates({x.low, frame.y(0)});
  for (const Point& point : series.points) {
    const bool shown = frame.x.shows(point.x) && frame.y.shows(point.y);
    if (shown) {
      const Vector at{frame.x(point.x), frame.y(point.y)};
      if (drawing && stairs)
        data += "H" + number(at.x) + "V" + number(at.y);
      else
        data += (drawing ? "L" : "M") + coordinates(at);
    }
    drawing = shown;
  }
  if (series.connection == Connection::distribution) data += "H" + number(x.high);
  return data;
}

void draw_line(Svg& svg, const Series& series, const Frame& frame) {
  if (series.connection == Connection::none) return;
  const std::string data = path_data(series, frame);
  if (data.empty()) return;
  const auto draw = [&](std::string_view dashes) {
    svg.path(data, {{"stroke", series.look.stroke.colour},
                    {"stroke-width", series.width},
                    {"stroke-dasharray", dashes},
                    {"stroke-linejoin", "round"},
                    {"fill", "none"}});
  };
  const Range page = across(frame);
  if (!frame.x.shows(series.measured_to)) return draw(series.look.stroke.dashes);
  const double end = std::clamp(frame.x(series.measured_to), page.low, page.high);
  const auto within = [&](Range part, std::string_view dashes) {
    const std::string clip = define_clip(svg, frame, part);
    const auto scope = svg.open("g", {{"clip-path", fmt::format("url(#{})", clip)}});
    draw(dashes);
  };
  within({page.low, end}, series.look.stroke.dashes);
  within({end, page.high}, extrapolated_dashes);
}

// Ends that the axis cannot show run off its edge.
Range on_page(const ChartAxis& axis, Range interval) {
  const Range page = axis.axis.scale.page;
  return {axis.shows(interval.low) ? axis(interval.low) : page.low,
          axis.shows(interval.high) ? axis(interval.high) : page.high};
}

void draw_intervals(Svg& svg, const Series& series, const Frame& frame) {
  const auto draw = [&](Vector from, Vector to) {
    svg.line(from, to,
             {{"class", "interval"}, {"stroke", series.look.stroke.colour}, {"stroke-width", 0.8}});
  };
  for (const Point& point : series.points) {
    if (!frame.x.shows(point.x) || !frame.y.shows(point.y)) continue;
    const Vector at{frame.x(point.x), frame.y(point.y)};
    if (point.x_interval) {
      const Range ends = on_page(frame.x, *point.x_interval);
      draw({ends.low, at.y}, {ends.high, at.y});
    }
    if (point.y_interval) {
      const Range ends = on_page(frame.y, *point.y_interval);
      draw({at.x, ends.low}, {at.x, ends.high});
    }
  }
}

void draw_series(Svg& svg, const Series& series, const Frame& frame) {
  const auto scope = svg.group("series");
  draw_line(svg, series, frame);
  draw_intervals(svg, series, frame);
  if (series.marks == Marks::none) return;
  for (const Point& point : series.points)
    if (frame.x.shows(point.x) && frame.y.shows(point.y)) {
      const auto draw = point.x > series.measured_to ? draw_open_marker : draw_marker;
      draw(svg, {frame.x(point.x), frame.y(point.y)}, series.look);
    }
}

void draw_grid(Svg& svg, const Frame& frame) {
  const auto scope = svg.group("grid");
  const Range x = frame.x.axis.scale.page;
  for (const double tick : frame.y.axis.ticks)
    svg.line({x.low, frame.y.axis.scale(tick)}, {x.high, frame.y.axis.scale(tick)},
             {{"stroke", style::faint}, {"stroke-width", 0.4}});
}

void draw_band(Svg& svg, const Frame& frame, Range band) {
  const Range x = frame.x.axis.scale.page, ends = on_page(frame.y, band);
  svg.element("rect", {{"class", "expected"},
                       {"x", x.low},
                       {"y", ends.high},
                       {"width", x.width()},
                       {"height", ends.low - ends.high},
                       {"fill", style::neutral.colour},
                       {"fill-opacity", 0.18}});
}

void draw_level(Svg& svg, const Frame& frame, const Guide& guide) {
  if (!frame.y.shows(guide.at)) return;
  const Range x = frame.x.axis.scale.page;
  const double y = frame.y(guide.at);
  draw_guide(svg, {x.low, y}, {x.high, y});
  svg.text({x.low + 4, y - 2.5}, guide.label, {.size = style::small_size});
}

bool is_empty(const ChartPanel& panel, const Frame& frame) {
  return std::ranges::none_of(panel.series, [&](const Series& series) {
    return std::ranges::any_of(series.points, [&](const Point& point) {
      return frame.x.shows(point.x) && frame.y.shows(point.y);
    });
  });
}

void draw_panel(Svg& svg, const ChartPanel& panel, const Frame& frame) {
  const Range x = frame.x.axis.scale.page, y = frame.y.axis.scale.page;
  if (!panel.heading.empty())
    svg.text({x.low, y.high - 4}, shortened(panel.heading, style::small_size, x.width()),
             {.size = style::small_size});
  draw_grid(svg, frame);
  draw_left_axis(svg, frame.y.axis, x.low - 3);
  if (is_empty(panel, frame)) {
    svg.text({(x.low + x.high) / 2, (y.low + y.high) / 2 + 2.5}, panel.empty_note,
             {.size = style::label_size, .anchor = "middle"});
    return;
  }
  const std::string clip = define_clip(svg, frame, across(frame));
  const auto scope = svg.open("g", {{"clip-path", fmt::format("url(#{})", clip)}});
  if (panel.band) draw_band(svg, frame, *panel.band);
  for (const Guide& guide : panel.guides) draw_level(svg, frame, guide);
  for (const Series& series : panel.series) draw_series(svg, series, frame);
}

// A label and how it looks, each once.
std::vector<LegendEntry> legend_of(const Chart& chart) {
  std::vector<LegendEntry> entries;
  std::set<std::string> known;
  for (const ChartPanel& panel : chart.panels)
    for (const Series& series : panel.series) {
      if (series.label.empty() || !known.insert(series.label).second) continue;
      Series sample = series;
      sample.points.clear();
      entries.push_back({[sample](Svg& svg, Vector left) {
                           if (sample.connection != Connection::none)
                             svg.line(left, left + Vector{swatch_width, 0},
                                      {{"stroke", sample.look.stroke.colour},
                                       {"stroke-width", sample.width},
                                       {"stroke-dasharray", sample.look.stroke.dashes}});
                           if (sample.marks != Marks::none)
                             draw_marker(svg, left + Vector{swatch_width / 2, 0}, sample.look);
                         },
                         series.label});
    }
  return entries;
}

struct Layout {
  double left = 0, first_top = 0, step = 0, panels_height = 0;
  double legend = 0, height = 0;
};

double header_of(const Chart& chart) {
  return std::ranges::any_of(chart.panels, [](const ChartPanel& p) { return !p.heading.empty(); })
             ? header
             : 4;
}

ChartAxis horizontal_axis(const Chart& chart, Range page) {
  return chart_axis(chart.x, x_range(chart), page, static_cast<int>(page.width() / 40));
}

Layout lay_out(const Chart& chart, const std::vector<LegendEntry>& entries, double width) {
  Layout layout;
  const int ticks = std::max(3, static_cast<int>(chart.panel_height / points_per_tick));
  const ChartAxis y = chart_axis(chart.y, y_range(chart), {chart.panel_height, 0}, ticks);
  layout.left = left_axis_gap + std::max(y.axis.label_width(), chart.label_room);
  const ChartAxis x = horizontal_axis(chart, {layout.left, width - right_room});
  layout.first_top = guides_height(chart, x);
  const double top = header_of(chart);
  layout.step = top + chart.panel_height + panel_gap;
  layout.panels_height =
      layout.first_top + static_cast<double>(chart.panels.size()) * layout.step - panel_gap;
  layout.legend = layout.panels_height + 3 + bottom_axis_height + legend_gap;
  layout.height = layout.legend + legend_height(entries, width - layout.left);
  return layout;
}

void draw_chart(Svg& svg, const Chart& chart, const Layout& layout,
                const std::vector<LegendEntry>& entries, Vector top_left, double width) {
  const auto scope = svg.group("chart");
  const Range page{top_left.x + layout.left, top_left.x + width - right_room};
  const ChartAxis x = horizontal_axis(chart, page);
  const Range y = y_range(chart);
  const int ticks = std::max(3, static_cast<int>(chart.panel_height / points_per_tick));
  const double bottom = top_left.y + layout.panels_height;
  draw_vertical_guides(svg, chart, x, top_left.y, bottom);
  double top = top_left.y + layout.first_top + header_of(chart);
  for (const ChartPanel& panel : chart.panels) {
    draw_panel(svg, panel, {x, chart_axis(chart.y, y, {top + chart.panel_height, top}, ticks)});
    top += layout.step;
  }
  draw_bottom_axis(svg, x.axis, bottom + 3);
  draw_bottom_title(svg, x.axis, bottom + 3);
  const ChartAxis all = chart_axis(chart.y, y, {bottom, top_left.y + layout.first_top}, ticks);
  Axis title = all.axis;
  title.labels =
      chart_axis(chart.y, y, {chart.panel_height, 0}, ticks).axis.labels;  // as wide as the panels'
  draw_left_title(svg, title, page.low - 3);
  draw_legend(svg, entries, top_left + Vector{layout.left, layout.legend}, width - layout.left);
}

}  // namespace

Block chart_block(Chart chart, double width) {
  const std::vector<LegendEntry> entries = legend_of(chart);
  const Layout layout = lay_out(chart, entries, width);
  return {"", layout.height, [=, chart = std::move(chart)](Svg& svg, Vector top_left) {
            draw_chart(svg, chart, layout, entries, top_left, width);
          }};
}

}  // namespace wander::figure

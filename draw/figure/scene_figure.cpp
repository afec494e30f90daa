#include "draw/figure/scene_figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "draw/figure/axis.h"
#include "draw/figure/block.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/scene_legend.h"
#include "draw/figure/style.h"

namespace wander::figure {
namespace {

constexpr double greatest_drawing_height = 300;
// Between the drawing and its axes: the marks of lights and sensors stand out by about that much.
constexpr double gap = 8;
constexpr double points_per_tick = 26;

struct Page {
  PageMap map;
  Range x, y;  // of the drawing, on the page, y downwards
  double height = 0;
};

Page lay_out(const Extent& extent, double page_width, double left, double top, double below) {
  const double width = page_width - left - style::margin - 2 * gap;
  const double height =
      std::min(width * extent.size().y / extent.size().x, greatest_drawing_height);
  const Vector low{left + gap, top + gap}, high = low + Vector{width, height};
  const PageMap map = fit(extent, low, high);
  const Vector bottom_left = map(extent.low), top_right = map(extent.high);
  return {map, {bottom_left.x, top_right.x}, {top_right.y, bottom_left.y}, high.y + gap + below};
}

int ticks_in(double page_length) {
  return std::max(2, static_cast<int>(page_length / points_per_tick));
}

Axis x_axis(const Extent& extent, const Page& page) {
  return make_axis({"x", "m"}, {extent.low.x, extent.high.x}, page.x, ticks_in(page.x.width()));
}
// The page's y grows downwards.
Axis y_axis(const Extent& extent, const Page& page) {
  return make_axis({"y", "m"}, {extent.low.y, extent.high.y}, {page.y.high, page.y.low},
                   ticks_in(page.y.width()));
}

std::string spoken(const std::vector<LegendEntry>& entries) {
  std::string text = "Two-dimensional scene with";
  for (const LegendEntry& entry : entries)
    text += (&entry == &entries[0] ? " " : "; ") + entry.text;
  return text;
}

}  // namespace

std::string scene_figure(const description::Scene& scene, const SceneFigureOptions& options) {
  const std::string title = !options.title.empty() ? options.title : scene.name;
  const Extent extent = extent_of(scene);
  const std::vector<LegendEntry> entries = legend_of(scene);
  const double legend_width = block_width(options.width) - 8;
  const double text_room = block_width(options.width);
  const double top = style::margin + title_height(title, text_room);
  const double below =
      bottom_axis_height + 4 + legend_height(entries, legend_width) + style::margin;

  // The labels of the y axis say how wide the drawing can be; they hardly depend on it.
  const Page draft = lay_out(extent, options.width, 40, top, below);
  const double left = style::margin + left_axis_gap + y_axis(extent, draft).label_width();
  const Page page = lay_out(extent, options.width, left, top, below);
  const Axis x = x_axis(extent, page), y = y_axis(extent, page);

  Svg svg({options.width, page.height}, title.empty() ? "Scene" : title, spoken(entries));
  draw_title(svg, title, {options.width / 2, style::margin}, text_room);
  const double bottom_axis = page.y.high + gap;
  draw_left_axis(svg, y, page.x.low - gap);
  draw_left_title(svg, y, page.x.low - gap);
  draw_bottom_axis(svg, x, bottom_axis);
  draw_bottom_title(svg, x, bottom_axis);
  draw_scene(svg, scene, page.map);
  draw_legend(svg, entries, {style::margin + 8, bottom_axis + bottom_axis_height + 4},
              legend_width);
  return std::move(svg).finish();
}

}  // namespace wander::figure

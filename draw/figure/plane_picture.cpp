#include "draw/figure/plane_picture.h"

#include <algorithm>

#include "draw/figure/on_dark.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/style.h"
#include "draw/figure/tones.h"

namespace wander::figure {
namespace {

// Around the picture: the marks of lights and sensors stand out by about that much.
constexpr double gap = 7, points_per_tick = 28, legend_gap = 6;

struct Frame {
  PageMap map;
  Range x, y;  // of the picture, on the page; y.high is its lower edge
};

int ticks_in(double page_length) {
  return std::max(2, static_cast<int>(page_length / points_per_tick));
}

Axis x_axis(const PlaneGrid& grid, const Frame& frame) {
  return make_axis({"x", "m"}, {grid.low().x, grid.high().x}, frame.x, ticks_in(frame.x.width()));
}
Axis y_axis(const PlaneGrid& grid, const Frame& frame) {
  return make_axis({"y", "m"}, {grid.low().y, grid.high().y}, {frame.y.high, frame.y.low},
                   ticks_in(frame.y.width()));
}

Frame frame_at(const PlaneGrid& grid, Vector top_left, Vector size, double left) {
  const Vector low = top_left + Vector{left + gap, gap}, high = low + size;
  const PageMap map = fit({grid.low(), grid.high()}, low, high);
  const Vector bottom_left = map(grid.low()), top_right = map(grid.high());
  return {map, {bottom_left.x, top_right.x}, {top_right.y, bottom_left.y}};
}

void draw_marks(Svg& svg, const PlanePicture& picture, const PageMap& map) {
  if (picture.ground == Ground::light) return draw_outlines(svg, picture.scene, map);
  define_on_dark(svg);
  for (const std::string_view kind : {dark_rim, on_dark}) {
    const auto scope = svg.group(kind);
    draw_outlines(svg, picture.scene, map);
  }
}

void draw(Svg& svg, const PlanePicture& picture, const Frame& frame) {
  const PlaneGrid& grid = picture.grid;
  const ToneScale scale = tone_scale(picture.values);
  draw_tones(svg, picture.values, grid, scale, picture.colours, {frame.x.low, frame.y.high},
             {frame.x.high, frame.y.low});
  draw_marks(svg, picture, frame.map);
  const Axis x = x_axis(grid, frame), y = y_axis(grid, frame);
  const double bottom = frame.y.high + gap;
  draw_left_axis(svg, y, frame.x.low - gap);
  draw_left_title(svg, y, frame.x.low - gap);
  draw_bottom_axis(svg, x, bottom);
  draw_bottom_title(svg, x, bottom);
  draw_tone_legend(svg, scale, picture.colours, picture.quantity,
                   {frame.x.low, bottom + bottom_axis_height + legend_gap}, frame.x.width());
}

}  // namespace

PlaneGrid grid_over(const description::Scene& scene, int columns) {
  const Extent extent = extent_of(scene);
  return {extent.low, extent.high, columns};
}

Block picture_block(PlanePicture picture, double width, double most_height) {
  const Vector extent = picture.grid.high() - picture.grid.low();
  const auto size_beside = [=](double left) {
    const double room = width - left - 2 * gap - style::margin;
    return Vector{room, std::min(room * extent.y / extent.x, most_height)};
  };
  // The labels of the y axis say how wide the picture can be; they hardly depend on it.
  const Frame draft = frame_at(picture.grid, {0, 0}, size_beside(40), 40);
  const double left = left_axis_gap + y_axis(picture.grid, draft).label_width();
  const Vector size = size_beside(left);
  const double height = size.y + 2 * gap + bottom_axis_height + legend_gap + tone_legend_height;
  return {"", height, [=, picture = std::move(picture)](Svg& svg, Vector top_left) {
            draw(svg, picture, frame_at(picture.grid, top_left, size, left));
          }};
}

}  // namespace wander::figure

#include "draw/figure/path_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "draw/figure/legend.h"
#include "draw/figure/path_frame.h"
#include "draw/figure/path_zoom.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/style.h"
#include "statistics/number_text.h"

namespace wander::figure {
namespace {

constexpr int most_columns = 3;
constexpr double least_column = 100;
constexpr double gap = 10, padding = 7, line_height = 9.2;
// Below a drawing: the caption, and to its right the enlarged part.
constexpr double zoom_side = 50, strip_height = zoom_side + 9;
constexpr double legend_gap = 3, most_aspect = 1.3, caption_size = style::small_size;

// Where the drawings stand.
struct Grid {
  int columns = 1, rows = 1;
  Vector cell, drawing;  // the drawing is the upper part of its cell

  Vector place(std::size_t k) const {
    return Vector{static_cast<double>(k % static_cast<std::size_t>(columns)),
                  static_cast<double>(k / static_cast<std::size_t>(columns))} *
           (cell + Vector{gap, gap});
  }
  double height() const { return rows * cell.y + (rows - 1) * gap; }
};

Grid grid_for(std::size_t frames, const Extent& extent, double width) {
  Grid grid;
  const int fit =
      std::clamp(static_cast<int>((width + gap) / (least_column + gap)), 2, most_columns);
  grid.columns = std::clamp(static_cast<int>(frames), 2, fit);
  grid.rows = std::max(1, (static_cast<int>(frames) + grid.columns - 1) / grid.columns);
  const double across = (width - (grid.columns - 1) * gap) / grid.columns;
  const double aspect = std::min(extent.size().y / extent.size().x, most_aspect);
  grid.drawing = {across, (across - 2 * padding) * aspect + 2 * padding};
  grid.cell = grid.drawing + Vector{0, strip_height};
  return grid;
}

void draw_caption(Svg& svg, const PathFrame& frame, Vector at, double width) {
  const auto line = [&](const std::string& text, std::string_view weight) {
    at.y += line_height;
    const double wide = weight == "bold" ? style::bold_width : 1;
    svg.text(at, shortened(text, wide * caption_size, width),
             {.size = caption_size, .weight = weight});
  };
  line(frame.title, "bold");
  line(frame.outcome, "normal");
  line(frame.classes, "normal");
}

std::vector<LegendEntry> legend() {
  const auto entry = [](PathKind kind, std::string text) {
    return LegendEntry{[kind](Svg& svg, Vector left) {
                         draw_line(svg, kind, "swatch",
                                   "M" + coordinates(left) + "h" + number(swatch_width));
                       },
                       std::move(text)};
  };
  return {entry(PathKind::current, "path before the step"),
          entry(PathKind::accepted, "accepted proposal (solid)"),
          entry(PathKind::rejected, "rejected proposal (dashed)"),
          entry(PathKind::failed, "failed: as far as it came (dotted)")};
}

// The whole scene with the paths, and below it the caption and what has to be enlarged.
void draw_frame(Svg& svg, const PathFrame& frame, const Grid& grid, const description::Scene& scene,
                const PageMap& map) {
  const Window window{{0, 0}, grid.drawing};
  draw_paths(svg, frame, map, window);
  const auto zoom = zoom_of(frame, map.scale);
  if (zoom) draw_zoom_frame(svg, *zoom, map);
  draw_failure(svg, frame, map, window);
  const double beside = zoom ? zoom_side + 4 : 0;
  draw_caption(svg, frame, {padding - 4, grid.drawing.y - 3}, grid.cell.x - padding + 4 - beside);
  if (zoom)
    draw_zoom(svg, frame, scene, *zoom, map,
              {grid.cell.x - padding - zoom_side, grid.drawing.y - 1}, zoom_side);
}

// The scene is drawn once and used again in every frame.
void draw_frames(Svg& svg, const std::vector<PathFrame>& frames, const Grid& grid,
                 const description::Scene& scene, Vector top_left) {
  const PageMap map =
      fit(extent_of(scene), Vector{padding, padding}, grid.drawing - Vector{padding, padding});
  {
    const auto definitions = svg.open("defs", {});
    const auto drawing = svg.open("g", {{"id", "sequence-scene"}});
    draw_scene(svg, scene, map);
  }
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Vector place = top_left + grid.place(k);
    const auto frame = svg.open(
        "g", {{"class", "step"},
              {"transform", fmt::format("translate({} {})", number(place.x), number(place.y))}});
    svg.use("sequence-scene");
    draw_frame(svg, frames[k], grid, scene, map);
  }
}

}  // namespace

Block path_sequence(const Steps& steps, const description::Scene& scene, double width, int most) {
  auto frames = std::make_shared<std::vector<PathFrame>>();
  std::size_t count = 0;
  steps.each([&](const Step& step) {
    if (count++ < static_cast<std::size_t>(most)) frames->push_back(path_frame(steps, step));
  });
  const Grid grid = grid_for(frames->size(), extent_of(scene), width);
  const std::vector<LegendEntry> entries = legend();
  std::string heading = fmt::format("Mutated paths, {}", in_words(steps));
  if (count > frames->size())
    heading += fmt::format(": the first {} of {} steps", frames->size(), count);
  if (count == 0) heading += ": no step was chosen";
  const double above = legend_height(entries, width) + legend_gap;
  const double below = frames->empty() ? 0 : grid.height();
  return {heading, above + below, [=](Svg& svg, Vector top_left) {
            const auto scope = svg.group("path-sequence");
            draw_legend(svg, entries, top_left, width);
            draw_frames(svg, *frames, grid, scene, top_left + Vector{0, above});
          }};
}

}  // namespace wander::figure

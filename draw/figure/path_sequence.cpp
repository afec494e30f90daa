#include "draw/figure/path_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
constexpr double zoom_side = 50, zoom_gap = 4, zoom_height = zoom_side + 9;
constexpr double below_caption = 4;
constexpr double legend_gap = 3, most_aspect = 1.3, caption_size = style::small_size;

// A step as it is drawn.
struct Cell {
  PathFrame frame;
  std::optional<Zoom> zoom;
  std::vector<std::string> title, text;  // lines of the caption

  double height_below() const {
    const auto lines = static_cast<double>(title.size() + text.size());
    return std::max(zoom ? zoom_height : 0, line_height * lines + below_caption);
  }
};

// Where the drawings stand.
struct Grid {
  std::size_t columns = 1;
  Vector drawing;            // the upper part of its cell
  std::vector<double> tops;  // of the rows, and where the next would begin

  Vector place(std::size_t k) const {
    return {static_cast<double>(k % columns) * (drawing.x + gap), tops[k / columns]};
  }
  double height() const { return std::max(0.0, tops.back() - gap); }
  PageMap map(const Extent& extent) const {
    return fit(extent, Vector{padding, padding}, drawing - Vector{padding, padding});
  }
};

Grid grid_for(std::size_t frames, const Extent& extent, double width) {
  const int fit =
      std::clamp(static_cast<int>((width + gap) / (least_column + gap)), 1, most_columns);
  const int columns = std::clamp(static_cast<int>(frames), std::min(2, fit), fit);
  const double across = (width - (columns - 1) * gap) / columns;
  const double aspect = std::min(extent.size().y / extent.size().x, most_aspect);
  return {static_cast<std::size_t>(columns),
          {across, (across - 2 * padding) * aspect + 2 * padding},
          {0}};
}

// A row is as high as what stands in it needs.
void place_rows(Grid& grid, const std::vector<Cell>& cells) {
  for (std::size_t first = 0; first < cells.size(); first += grid.columns) {
    double below = 0;
    for (std::size_t k = first; k < std::min(cells.size(), first + grid.columns); ++k)
      below = std::max(below, cells[k].height_below());
    grid.tops.push_back(grid.tops.back() + grid.drawing.y + below + gap);
  }
}

Cell cell_of(PathFrame frame, const Stage& stage, const Grid& grid, const PageMap& map) {
  Cell cell{std::move(frame), {}, {}, {}};
  if (stage.plane != nullptr) cell.zoom = zoom_of(cell.frame, map.scale);
  const double beside = cell.zoom ? zoom_side + zoom_gap : 0;
  const double width = grid.drawing.x - padding + 4 - beside;
  cell.title = wrapped(cell.frame.title, style::bold_width * caption_size, width);
  for (const std::string& text : {cell.frame.outcome, cell.frame.classes})
    for (std::string& line : wrapped(text, caption_size, width))
      cell.text.push_back(std::move(line));
  return cell;
}

void draw_caption(Svg& svg, const Cell& cell, Vector at) {
  const auto draw = [&](const std::vector<std::string>& lines, std::string_view weight) {
    for (const std::string& line : lines) {
      at.y += line_height;
      svg.text(at, line, {.size = caption_size, .weight = weight});
    }
  };
  draw(cell.title, "bold");
  draw(cell.text, "normal");
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
void draw_cell(Svg& svg, const Cell& cell, const Grid& grid, const Stage& stage,
               const PageMap& map) {
  const Window window{{0, 0}, grid.drawing};
  draw_paths(svg, cell.frame, map, window);
  if (cell.zoom) draw_zoom_frame(svg, *cell.zoom, map);
  draw_failure(svg, cell.frame, map, window);
  draw_caption(svg, cell, {padding - 4, grid.drawing.y - 3});
  if (cell.zoom)
    draw_zoom(svg, cell.frame, *stage.plane, *cell.zoom, map,
              {grid.drawing.x - padding - zoom_side, grid.drawing.y - 1}, zoom_side);
}

// The scene is drawn once and used again in every frame.
void draw_cells(Svg& svg, const std::vector<Cell>& cells, const Grid& grid, const Stage& stage,
                Vector top_left) {
  const PageMap map = grid.map(stage.extent);
  {
    const auto definitions = svg.open("defs", {});
    const auto drawing = svg.open("g", {{"id", "sequence-scene"}});
    stage.draw(svg, map);
  }
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Vector place = top_left + grid.place(k);
    const auto frame = svg.open(
        "g", {{"class", "step"},
              {"transform", fmt::format("translate({} {})", number(place.x), number(place.y))}});
    svg.use("sequence-scene");
    draw_cell(svg, cells[k], grid, stage, map);
  }
}

}  // namespace

Block path_sequence(const Steps& steps, const Stage& stage, double width, int most) {
  std::vector<PathFrame> frames;
  std::size_t count = 0;
  steps.each([&](const Step& step) {
    if (count++ < static_cast<std::size_t>(most)) frames.push_back(path_frame(steps, step));
  });
  Grid grid = grid_for(frames.size(), stage.extent, width);
  const PageMap map = grid.map(stage.extent);
  auto cells = std::make_shared<std::vector<Cell>>();
  for (PathFrame& frame : frames) cells->push_back(cell_of(std::move(frame), stage, grid, map));
  place_rows(grid, *cells);
  const std::vector<LegendEntry> entries = legend();
  std::string heading = fmt::format("Mutated paths, {}", in_words(steps));
  if (count > frames.size())
    heading += fmt::format(": the first {} of {} steps", frames.size(), count);
  if (count == 0) heading += ": no step was chosen";
  const double above = legend_height(entries, width) + legend_gap;
  const double below = grid.height();
  return {heading, above + below, [=](Svg& svg, Vector top_left) {
            const auto scope = svg.group("path-sequence");
            draw_legend(svg, entries, top_left, width);
            draw_cells(svg, *cells, grid, stage, top_left + Vector{0, above});
          }};
}

}  // namespace wander::figure

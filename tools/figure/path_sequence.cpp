#include "tools/figure/path_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/number_text.h"
#include "tools/figure/legend.h"
#include "tools/figure/scene_drawing.h"
#include "tools/figure/style.h"

namespace wander::figure {
namespace {

constexpr int most_columns = 4;
constexpr double gap = 10, padding = 7, caption_height = 31, line_height = 9.2;
constexpr double legend_gap = 3, most_aspect = 1.3, caption_size = style::small_size;
constexpr double current_width = 0.7, proposal_width = 2, dot_radius = 1.1;

struct Frame {
  std::vector<Vector> current, proposed;  // in the scene; empty: none
  bool accepted = false;
  std::string title, outcome, classes;
};

std::string probability_text(double a) { return number_text(a, a >= 0.01 ? 2 : 1); }

// "occluded" for occluded; "missed scene" for missed_scene.
std::string spoken(std::string_view name) {
  std::string text(name);
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string outcome_of(const Steps& steps, const Step& step) {
  const double a = steps.trajectory().acceptance[step.index];
  if (steps.accepted(step)) return fmt::format("accepted, a = {}", probability_text(a));
  if (steps.reason(step) == "metropolis")
    return fmt::format("rejected, a = {}", probability_text(a));
  return "failed: " + spoken(steps.reason(step));
}

std::string classes_of(const Steps& steps, const Step& step) {
  const Trajectory& t = steps.trajectory();
  const auto before = steps.before(step);
  const std::string from(before ? steps.path_class(t.state, *before) : "not recorded");
  if (t.proposed.vertices[step.index] == 0) return from;
  const std::string to(steps.path_class(t.proposed, step.index));
  return from == to ? from : from + " → " + to;
}

Frame frame_of(const Steps& steps, const Step& step) {
  const Trajectory& t = steps.trajectory();
  const auto before = steps.before(step);
  return {before ? steps.path(t.state, *before) : std::vector<Vector>{},
          steps.path(t.proposed, step.index),
          steps.accepted(step),
          fmt::format("step {}: {}", steps.number(step.draw), spoken(steps.mutation(step))),
          outcome_of(steps, step),
          classes_of(steps, step)};
}

std::string data_of(const std::vector<Vector>& path, const PageMap& map) {
  std::string data;
  for (const Vector& v : path) data += (data.empty() ? "M" : "L") + coordinates(map(v));
  return data;
}

void stroke_path(Svg& svg, std::string_view kind, const std::string& data,
                 const style::Stroke& stroke, double width) {
  svg.path(data, {{"class", kind},
                  {"stroke", stroke.colour},
                  {"stroke-width", width},
                  {"stroke-dasharray", stroke.dashes},
                  {"stroke-linejoin", "round"},
                  {"fill", "none"}});
}

const style::Stroke& proposal_stroke(const Frame& frame) {
  return frame.accepted ? style::accepted : style::rejected;
}

void draw_paths(Svg& svg, const Frame& frame, const PageMap& map) {
  if (frame.proposed.size() > 1)
    stroke_path(svg, frame.accepted ? "accepted" : "rejected", data_of(frame.proposed, map),
                proposal_stroke(frame), proposal_width);
  if (frame.current.size() > 1)
    stroke_path(svg, "current", data_of(frame.current, map), {style::ink, "none"}, current_width);
  const auto dots = [&](const std::vector<Vector>& path, std::string_view fill, double radius) {
    for (const Vector& v : path)
      svg.element("circle", {{"cx", map(v).x}, {"cy", map(v).y}, {"r", radius}, {"fill", fill}});
  };
  dots(frame.proposed, proposal_stroke(frame).colour, 1.5 * dot_radius);
  dots(frame.current, style::ink, dot_radius);
}

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
  grid.columns = std::clamp(static_cast<int>(frames), 2, most_columns);
  grid.rows = std::max(1, (static_cast<int>(frames) + grid.columns - 1) / grid.columns);
  const double across = (width - (grid.columns - 1) * gap) / grid.columns;
  const double aspect = std::min(extent.size().y / extent.size().x, most_aspect);
  grid.drawing = {across, (across - 2 * padding) * aspect + 2 * padding};
  grid.cell = grid.drawing + Vector{0, caption_height};
  return grid;
}

void draw_caption(Svg& svg, const Frame& frame, Vector at, double width) {
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
  const auto entry = [](const style::Stroke& stroke, double width, std::string text) {
    return LegendEntry{[=](Svg& svg, Vector left) {
                         stroke_path(svg, "swatch",
                                     "M" + coordinates(left) + "h" + number(swatch_width), stroke,
                                     width);
                       },
                       std::move(text)};
  };
  return {entry({style::ink, "none"}, current_width, "path before the step"),
          entry(style::accepted, proposal_width, "accepted proposal (solid)"),
          entry(style::rejected, proposal_width, "rejected proposal (dashed)")};
}

// The scene is drawn once and used again in every frame.
void draw_frames(Svg& svg, const std::vector<Frame>& frames, const Grid& grid,
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
    svg.element("use", {{"href", "#sequence-scene"}});
    draw_paths(svg, frames[k], map);
    draw_caption(svg, frames[k], {padding - 4, grid.drawing.y - 3}, grid.cell.x - padding + 4);
  }
}

}  // namespace

Block path_sequence(const Steps& steps, const description::Scene& scene, double width, int most) {
  auto frames = std::make_shared<std::vector<Frame>>();
  std::size_t count = 0;
  steps.each([&](const Step& step) {
    if (count++ < static_cast<std::size_t>(most)) frames->push_back(frame_of(steps, step));
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

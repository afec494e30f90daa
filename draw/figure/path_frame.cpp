#include "draw/figure/path_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "statistics/number_text.h"

namespace wander::figure {
namespace {

constexpr double dot_radius = 1.1, cross_size = 2.6;

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
  const std::string from(before ? steps.path_class(*before->paths, before->index) : "not recorded");
  if (t.proposed.vertices[step.index] == 0) return from;
  const std::string to(steps.path_class(t.proposed, step.index));
  return from == to ? from : from + " → " + to;
}

style::Stroke stroke_of(PathKind kind) {
  switch (kind) {
    case PathKind::current:
      return {style::ink, "none"};
    case PathKind::accepted:
      return style::accepted;
    case PathKind::rejected:
      return style::rejected;
    case PathKind::failed:
      return style::failed;
  }
  return style::neutral;
}

std::string_view name_of(PathKind kind) {
  switch (kind) {
    case PathKind::current:
      return "current";
    case PathKind::accepted:
      return "accepted";
    case PathKind::rejected:
      return "rejected";
    case PathKind::failed:
      return "failed";
  }
  return "";
}

std::string data_of(const PolyLine& line, const PageMap& map, const Window& window) {
  PolyLine on_page;
  std::string data;
  for (const Vector& v : line) {
    if (!std::isnan(v.x)) {
      on_page.push_back(map(v));
      continue;
    }
    data += clipped(on_page, window);
    on_page.clear();
  }
  return data + clipped(on_page, window);
}

void dots(Svg& svg, const PolyLine& path, PathKind kind, const PageMap& map, const Window& window) {
  const double radius = kind == PathKind::current ? dot_radius : 1.5 * dot_radius;
  for (const Vector& v : path)
    if (holds(window, map(v)))
      svg.element(
          "circle",
          {{"cx", map(v).x}, {"cy", map(v).y}, {"r", radius}, {"fill", stroke_of(kind).colour}});
}

void strokes(Svg& svg, const std::string& data) {
  svg.path(data, {{"stroke", style::failed.colour}, {"stroke-width", 1.3}, {"fill", "none"}});
}

void draw_cross(Svg& svg, Vector at) {
  const Vector a{cross_size, cross_size}, b{cross_size, -cross_size};
  strokes(svg, "M" + coordinates(at - a) + "L" + coordinates(at + a) + "M" + coordinates(at - b) +
                   "L" + coordinates(at + b));
}

// Of a ray that leaves.
void draw_arrow_head(Svg& svg, Vector tip, Vector along) {
  const Vector across{-along.y, along.x}, back = tip - 4.5 * along;
  strokes(svg, "M" + coordinates(back + 2.2 * across) + "L" + coordinates(tip) + "L" +
                   coordinates(back - 2.2 * across));
}

// Beside the spot, and within the window.
void draw_reason(Svg& svg, const std::string& reason, Vector spot, const Window& window) {
  constexpr double size = 6;
  const double width = text_width(reason, size);
  const Vector beside = spot + Vector{cross_size + 2, -2.5};
  const Vector at{std::clamp(beside.x, window.low.x, std::max(window.low.x, window.high.x - width)),
                  std::clamp(beside.y, window.low.y + size, window.high.y - 1)};
  svg.element("rect", {{"x", at.x - 1},
                       {"y", at.y - 0.85 * size},
                       {"width", width + 2},
                       {"height", 1.15 * size},
                       {"fill", style::paper},
                       {"fill-opacity", 0.8}});
  svg.text(at, reason, {.size = size});
}

}  // namespace

PathFrame path_frame(const Steps& steps, const Step& step) {
  const auto before = steps.before(step);
  return {
      .current = before ? steps.path(*before->paths, before->index) : PolyLine{},
      .proposed = steps.path(steps.trajectory().proposed, step.index),
      .attempt = steps.attempt(step),
      .failure = steps.failure(step),
      .reason = spoken(steps.reason(step)),
      .accepted = steps.accepted(step),
      .title = fmt::format("step {}: {}", steps.number(step.draw), spoken(steps.mutation(step))),
      .outcome = outcome_of(steps, step),
      .classes = classes_of(steps, step)};
}

PathKind proposal_kind(const PathFrame& frame) {
  if (frame.proposed.empty()) return PathKind::failed;
  return frame.accepted ? PathKind::accepted : PathKind::rejected;
}

double width_of(PathKind kind) {
  if (kind == PathKind::current) return 0.7;
  return kind == PathKind::failed ? 1.4 : 2;
}

void draw_line(Svg& svg, PathKind kind, std::string_view name, std::string_view data) {
  const style::Stroke stroke = stroke_of(kind);
  svg.path(data, {{"class", name},
                  {"stroke", stroke.colour},
                  {"stroke-width", width_of(kind)},
                  {"stroke-dasharray", stroke.dashes},
                  {"stroke-linejoin", "round"},
                  {"fill", "none"}});
}

void draw_paths(Svg& svg, const PathFrame& frame, const PageMap& map, const Window& window) {
  const PathKind kind = proposal_kind(frame);
  std::string attempt;
  for (const PolyLine& line : frame.attempt) attempt += data_of(line, map, window);
  if (frame.proposed.size() > 1)
    draw_line(svg, kind, name_of(kind), data_of(frame.proposed, map, window));
  if (!attempt.empty()) draw_line(svg, PathKind::failed, "failed", attempt);
  if (frame.current.size() > 1)
    draw_line(svg, PathKind::current, "current", data_of(frame.current, map, window));
  dots(svg, frame.proposed, kind, map, window);
  for (const PolyLine& line : frame.attempt) dots(svg, line, PathKind::failed, map, window);
  dots(svg, frame.current, PathKind::current, map, window);
}

void draw_failure(Svg& svg, const PathFrame& frame, const PageMap& map, const Window& window) {
  if (!frame.failure) return;
  const auto scope = svg.group("failure");
  Vector spot = map(*frame.failure);
  const PolyLine* last = frame.attempt.empty() ? nullptr : &frame.attempt.back();
  if (holds(window, spot)) {
    draw_cross(svg, spot);
  } else if (last != nullptr && last->size() > 1) {
    const Vector from = map(last->end()[-2]);
    spot = last_within(from, spot, window);
    if (spot != from) draw_arrow_head(svg, spot, glm::normalize(spot - from));
  }
  draw_reason(svg, frame.reason, spot, window);
}

}  // namespace wander::figure

#include "draw/figure/path_zoom.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "draw/figure/marks.h"

namespace wander::figure {
namespace {

// In points: a move that is longer is seen.
constexpr double visible_move = 7;
// The enlarged square is so many moves wide, and no more times as large as coordinates allow.
constexpr double moves_across = 3.2, most_zoom = 1e5;
constexpr double frame_width = 0.7, least_frame = 2.5;

struct Move {
  Vector from, to;
  double length() const { return glm::distance(from, to); }
};

// What the proposal made of vertex k, or came to.
std::vector<Move> moves_of(const PathFrame& frame) {
  std::vector<Move> moves;
  if (frame.proposed.size() == frame.current.size())
    for (std::size_t k = 0; k < frame.current.size(); ++k)
      moves.push_back({frame.current[k], frame.proposed[k]});
  if (!frame.proposed.empty()) return moves;
  for (const PolyLine& line : frame.attempt)
    for (const Vector& p : line) {
      const auto nearest = std::ranges::min_element(
          frame.current, {}, [&](const Vector& v) { return glm::distance(v, p); });
      if (nearest != frame.current.end()) moves.push_back({*nearest, p});
    }
  return moves;
}

// Straight pieces of a curve, as fine as the page shows, that may lie in the window.
void add_pieces(const Curve& curve, const PageMap& map, const Window& window, double from,
                double to, int depth, std::string& data) {
  const Vector a = map(spot(curve, from).position), b = map(spot(curve, to).position);
  const Vector middle = map(spot(curve, (from + to) / 2).position);
  const double reach = length(curve) * (to - from) * map.scale;
  const Vector centre = (window.low + window.high) / 2.;
  if (glm::distance(middle, centre) > reach + glm::length(window.size())) return;
  const bool is_straight = glm::distance(middle, (a + b) / 2.) < 0.05;
  if (depth == 0 || (is_straight && reach < 100 * glm::length(window.size()))) {
    data += clipped({a, b}, window);
    return;
  }
  add_pieces(curve, map, window, from, (from + to) / 2, depth - 1, data);
  add_pieces(curve, map, window, (from + to) / 2, to, depth - 1, data);
}

void draw_shape(Svg& svg, const description::Scene& scene, const description::Shape& shape,
                const PageMap& map, const Window& window) {
  constexpr int most_halvings = 40;
  std::string data;
  for (const Curve& curve : curves(shape.kind))
    add_pieces(curve, map, window, 0, 1, most_halvings, data);
  if (data.empty()) return;
  if (const auto surface = surface_of(scene, shape)) draw_surface(svg, *surface, data);
  const auto line = [&](std::string_view colour) {
    svg.path(data, {{"stroke", colour}, {"stroke-width", 1.9}, {"fill", "none"}});
  };
  if (shape.light) line(style::light);
  if (shape.sensor) line(style::sensor);
}

std::string factor_in_words(double factor) {
  const double unit = std::pow(10, std::floor(std::log10(factor)) - 1);
  return fmt::format("× {}", std::max(unit, 1.) * std::round(factor / std::max(unit, 1.)));
}

void square(Svg& svg, Vector middle, double half, std::string_view fill) {
  svg.element("rect", {{"x", middle.x - half},
                       {"y", middle.y - half},
                       {"width", 2 * half},
                       {"height", 2 * half},
                       {"fill", fill},
                       {"stroke", style::zoom},
                       {"stroke-width", frame_width}});
}

}  // namespace

std::optional<Zoom> zoom_of(const PathFrame& frame, double scale) {
  const std::vector<Move> moves = moves_of(frame);
  const auto farthest = std::ranges::max_element(moves, {}, &Move::length);
  if (farthest == moves.end()) return std::nullopt;
  const double move = farthest->length();
  if (!(move > 0) || move * scale > visible_move) return std::nullopt;
  return Zoom{(farthest->from + farthest->to) / 2., moves_across * move / 2};
}

void draw_zoom_frame(Svg& svg, const Zoom& zoom, const PageMap& map) {
  const auto scope = svg.group("zoom-frame");
  square(svg, map(zoom.middle), std::max(least_frame, zoom.half * map.scale), "none");
}

void draw_zoom(Svg& svg, const PathFrame& frame, const description::Scene& scene, const Zoom& zoom,
               const PageMap& whole, Vector top_left, double side) {
  const double scale = std::min(side / (2 * zoom.half), most_zoom * whole.scale);
  const Vector middle = top_left + Vector{side, side} / 2.;
  const PageMap map{zoom.middle, middle, scale};
  const Window window{top_left, top_left + Vector{side, side}};
  const auto scope = svg.group("zoom");
  square(svg, middle, side / 2, style::paper);
  for (const description::Shape& shape : scene.shapes) draw_shape(svg, scene, shape, map, window);
  draw_paths(svg, frame, map, window);
  svg.text({window.high.x, window.high.y + 7}, factor_in_words(scale / whole.scale),
           {.size = 6, .anchor = "end"});
}

}  // namespace wander::figure

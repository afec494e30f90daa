#include "draw/figure/curve.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace wander::figure {
namespace {

constexpr double pi = std::numbers::pi, full_turn = 2 * pi;

Vector flat(const description::Coordinates& p) { return {p[0], p[1]}; }
Vector towards(double angle) { return {std::cos(angle), std::sin(angle)}; }

// From one angle to the other, counter-clockwise; equal ends are a full turn.
double extent_between(double from_degrees, double to_degrees) {
  const double turn = std::fmod(to_degrees - from_degrees, 360);
  return (turn > 0 ? turn : turn + 360) * pi / 180;
}

Curve curve_of(const description::Segment& s) { return Line{flat(s.from), flat(s.to)}; }
Curve curve_of(const description::Arc& a) {
  return Bend{flat(a.center), a.radius, std::fmod(a.from_degrees, 360) * pi / 180,
              extent_between(a.from_degrees, a.to_degrees), a.flip ? -1. : 1.};
}

Vector normal(const Line& line) {
  const Vector along = line.to - line.from;
  const double size = glm::length(along);
  return size > 0 ? left_of(along / size) : Vector(0, 1);
}

// A, once or (an ellipse arc cannot be a full turn) twice.  The page turns counter-clockwise, SVG's
// sweep 0, as the scene does.
std::string arc_commands(const Bend& b, const PageMap& map, double radius, Direction direction) {
  const bool along = direction == Direction::along;
  const double start = along ? b.start : b.start + b.extent;
  const double extent = along ? b.extent : -b.extent;
  const int parts = b.extent > 0.99 * full_turn ? 2 : 1;
  const char large = b.extent / parts > pi ? '1' : '0', sweep = along ? '0' : '1';
  const std::string radii = number(radius * map.scale) + ' ' + number(radius * map.scale);
  std::string data;
  for (int k = 1; k <= parts; ++k) {
    const Vector end = b.center + radius * towards(start + extent * k / parts);
    data += "A" + radii + " 0 " + large + ' ' + sweep + ' ' + coordinates(map(end));
  }
  return data;
}

std::string data(const Line& line, const PageMap& map, double offset) {
  const Vector shift = offset / map.scale * normal(line);
  return "M" + coordinates(map(line.from + shift)) + "L" + coordinates(map(line.to + shift));
}

std::string data(const Bend& b, const PageMap& map, double offset) {
  const double radius = std::max(0., b.radius + b.facing * offset / map.scale);
  const Vector start = b.center + radius * towards(b.start);
  const bool whole = b.extent >= full_turn;
  return "M" + coordinates(map(start)) + arc_commands(b, map, radius, Direction::along) +
         (whole ? "Z" : "");
}

}  // namespace

std::vector<Curve> curves(const description::ShapeKind& shape) {
  std::vector<Curve> found;
  for (const auto& stroke : outline_of(shape))
    found.push_back(std::visit([](const auto& s) { return curve_of(s); }, stroke));
  return found;
}

bool is_closed(const std::vector<Curve>& outline) {
  if (outline.size() == 1) {
    const Bend* bend = std::get_if<Bend>(&outline.front());
    return bend && bend->extent >= full_turn;
  }
  return spot(outline.back(), 1).position == spot(outline.front(), 0).position;
}

Spot spot(const Curve& curve, double fraction) {
  if (const Line* line = std::get_if<Line>(&curve))
    return {glm::mix(line->from, line->to, fraction), normal(*line)};
  const Bend& b = std::get<Bend>(curve);
  const Vector outward = towards(b.start + fraction * b.extent);
  return {b.center + b.radius * outward, b.facing * outward};
}

double length(const Curve& curve) {
  if (const Line* line = std::get_if<Line>(&curve)) return glm::length(line->to - line->from);
  const Bend& b = std::get<Bend>(curve);
  return b.radius * b.extent;
}

void Extent::include(Vector point) {
  low = glm::min(low, point);
  high = glm::max(high, point);
}

void Extent::include(const Curve& curve) {
  include(spot(curve, 0).position);
  include(spot(curve, 1).position);
  const Bend* b = std::get_if<Bend>(&curve);
  if (!b) return;
  // Where the arc runs through a multiple of a right angle it is farthest out.
  const int first = static_cast<int>(std::ceil(b->start / (pi / 2)));
  const int last = static_cast<int>(std::floor((b->start + b->extent) / (pi / 2)));
  for (int k = first; k <= last; ++k) include(b->center + b->radius * towards(k * pi / 2));
}

std::string outline(const description::ShapeKind& shape, const PageMap& map) {
  const std::vector<Curve> sides = curves(shape);
  if (sides.size() == 1) return outline(sides.front(), map, 0);
  const bool closed = is_closed(sides);
  std::string path = "M" + coordinates(map(spot(sides.front(), 0).position));
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const bool drawn_by_closing =
        closed && k + 1 == sides.size() && std::holds_alternative<Line>(sides[k]);
    if (!drawn_by_closing) path += continuation(sides[k], map, Direction::along);
  }
  return path + (closed ? "Z" : "");
}

std::string outline(const Curve& curve, const PageMap& map, double offset) {
  return std::visit([&](const auto& c) { return data(c, map, offset); }, curve);
}

std::string continuation(const Curve& curve, const PageMap& map, Direction direction) {
  if (const Bend* b = std::get_if<Bend>(&curve)) return arc_commands(*b, map, b->radius, direction);
  return "L" + coordinates(map(spot(curve, direction == Direction::along ? 1 : 0).position));
}

}  // namespace wander::figure

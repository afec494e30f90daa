#include "draw/figure/curve.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

namespace wander::figure {
namespace {

constexpr double pi = std::numbers::pi, full_turn = 2 * pi;

template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

Vector flat(const description::Coordinates& p) { return {p[0], p[1]}; }
Vector towards(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Circles and arcs alike.
double facing(const auto& curve) { return curve.flip ? -1 : 1; }

// From one angle to the other, counter-clockwise; equal ends are a full turn.
double extent_between(double from_degrees, double to_degrees) {
  const double turn = std::fmod(to_degrees - from_degrees, 360);
  return (turn > 0 ? turn : turn + 360) * pi / 180;
}

Bend bend(const description::Circle& c) {
  return {flat(c.center), c.radius, 0, full_turn, facing(c)};
}
Bend bend(const description::Arc& a) {
  return {flat(a.center), a.radius, std::fmod(a.from_degrees, 360) * pi / 180,
          extent_between(a.from_degrees, a.to_degrees), facing(a)};
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

std::string data(const description::Polyline& polyline, const PageMap& map) {
  std::string result;
  for (const auto& point : polyline.points)
    result += (result.empty() ? "M" : "L") + coordinates(map(flat(point)));
  return result + (polyline.closed ? "Z" : "");
}

}  // namespace

std::vector<Curve> curves(const description::ShapeKind& shape) {
  using Curves = std::vector<Curve>;
  return visit_known(
      Overloaded{[](const description::Segment& s) {
                   return Curves{Line{flat(s.from), flat(s.to)}};
                 },
                 [](const description::Circle& c) { return Curves{bend(c)}; },
                 [](const description::Arc& a) { return Curves{bend(a)}; },
                 [](const description::Polyline& p) {
                   Curves sides;
                   for (std::size_t k = 0; k + 1 < p.points.size(); ++k)
                     sides.push_back(Line{flat(p.points[k]), flat(p.points[k + 1])});
                   if (p.closed && p.points.size() > 2)
                     sides.push_back(Line{flat(p.points.back()), flat(p.points.front())});
                   return sides;
                 }},
      shape);
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
  if (const auto* polyline = std::get_if<description::Polyline>(&shape))
    return data(*polyline, map);
  return outline(curves(shape).front(), map, 0);
}

std::string outline(const Curve& curve, const PageMap& map, double offset) {
  return std::visit([&](const auto& c) { return data(c, map, offset); }, curve);
}

std::string continuation(const Curve& curve, const PageMap& map, Direction direction) {
  if (const Bend* b = std::get_if<Bend>(&curve)) return arc_commands(*b, map, b->radius, direction);
  return "L" + coordinates(map(spot(curve, direction == Direction::along ? 1 : 0).position));
}

}  // namespace wander::figure

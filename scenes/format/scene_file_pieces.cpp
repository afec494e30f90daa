#include "scenes/format/scene_file_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wander {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

glm::dvec2 vector(const description::Coordinates& c) { return {c[0], c[1]}; }
double length_of(glm::dvec2 v) { return std::hypot(v.x, v.y); }
double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }
glm::dvec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

double positive_turn(double radians) {
  const double turn = std::fmod(radians, full_turn);
  return turn < 0 ? turn + full_turn : turn;
}

// Of an arc: its ends, and those of its four extreme points that it reaches.
void bound(Piece& piece) {
  piece.low = glm::min(piece.from, piece.to);
  piece.high = glm::max(piece.from, piece.to);
  if (piece.carrier == Piece::Carrier::line) return;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double angle = quarter * std::numbers::pi / 2;
    if (positive_turn(angle - piece.start) > piece.extent) continue;
    const glm::dvec2 point = piece.center + piece.radius * direction(angle);
    piece.low = glm::min(piece.low, point);
    piece.high = glm::max(piece.high, point);
  }
}

// Cuts one shape into pieces that carry its roles.
struct Cutter {
  std::vector<Piece>& pieces;
  Piece blank;

  void line(glm::dvec2 from, glm::dvec2 to) {
    Piece piece = blank;
    piece.from = from;
    piece.to = to;
    add(piece);
  }
  void circle(glm::dvec2 center, double radius, double start, double extent, double facing) {
    Piece piece = blank;
    piece.carrier = Piece::Carrier::circle;
    piece.center = center;
    piece.radius = radius;
    piece.start = start;
    piece.extent = extent;
    piece.facing = facing;
    piece.from = center + radius * direction(start);
    piece.to = extent < full_turn ? center + radius * direction(start + extent) : piece.from;
    add(piece);
  }
  void add(Piece& piece) {
    bound(piece);
    pieces.push_back(piece);
  }

  void operator()(const description::Segment& s) { line(vector(s.from), vector(s.to)); }
  void operator()(const description::Arc& s) {
    const double radian = std::numbers::pi / 180;
    const double turn = std::fmod(s.to_degrees - s.from_degrees, 360.0);
    const double extent = turn > 0 ? turn * radian : turn * radian + full_turn;
    circle(vector(s.center), s.radius, s.from_degrees * radian, extent, s.flip ? -1 : 1);
  }
};

}  // namespace

double Piece::length() const {
  return carrier == Carrier::line ? length_of(to - from) : radius * extent;
}

glm::dvec2 Piece::at(double u) const {
  if (carrier == Carrier::line) return from + u * (to - from);
  return center + radius * direction(start + u * extent);
}

glm::dvec2 Piece::normal(glm::dvec2 point) const {
  if (carrier == Carrier::circle) return facing * (point - center) / length_of(point - center);
  const glm::dvec2 along = (to - from) / length();
  return {-along.y, along.x};
}

glm::dvec2 Piece::nearest(glm::dvec2 point) const {
  if (carrier == Carrier::line) {
    const glm::dvec2 along = (to - from) / length();
    const double t = glm::dot(point - from, along);
    return t <= 0 ? from : t >= length() ? to : from + t * along;
  }
  const glm::dvec2 offset = point - center;
  const double angle = std::atan2(offset.y, offset.x);
  if (positive_turn(angle - start) <= extent) return center + radius * direction(angle);
  return length_of(point - from) < length_of(point - to) ? from : to;
}

double Piece::distance(glm::dvec2 point) const { return length_of(point - nearest(point)); }

double Piece::side(glm::dvec2 point) const {
  if (carrier == Carrier::circle) return length_of(point - center) - radius;
  return cross((to - from) / length(), point - from);
}

Pieces pieces_of(const description::Scene& scene) {
  Pieces result;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const description::Shape& shape = scene.shapes[i];
    Cutter cutter{result.pieces, {}};
    cutter.blank.shape = i;
    cutter.blank.is_light = shape.light.has_value();
    cutter.blank.is_sensor = shape.sensor.has_value();
    for (const auto& stroke : outline_of(shape.kind)) std::visit(cutter, stroke);
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  glm::dvec2 low(infinity), high(-infinity);
  for (const Piece& piece : result.pieces) {
    low = glm::min(low, piece.low);
    high = glm::max(high, piece.high);
  }
  if (result.pieces.empty()) return result;
  const glm::dvec2 middle = result.middle = low / 2.0 + high / 2.0;
  const double diameter = result.diameter = length_of(high - low);
  result.remoteness = std::max({-low.x, -low.y, high.x, high.y}) / diameter;
  for (Piece& piece : result.pieces) {
    for (glm::dvec2* point : {&piece.from, &piece.to, &piece.center, &piece.low, &piece.high})
      *point = (*point - middle) / diameter;
    piece.radius /= diameter;
  }
  return result;
}

}  // namespace wander

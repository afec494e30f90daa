// Points and segments of the plane, for exact answers only: they share no code with light
// transport, so that each can be held against the other.
//
// As in the scene format, a segment's normal is its direction turned left, and its front is the
// side of the normal.
#pragma once

#include <algorithm>
#include <cmath>

namespace wander::exact {

struct PlanePoint {
  double x = 0, y = 0;
};

constexpr PlanePoint operator+(PlanePoint a, PlanePoint b) { return {a.x + b.x, a.y + b.y}; }
constexpr PlanePoint operator-(PlanePoint a, PlanePoint b) { return {a.x - b.x, a.y - b.y}; }
constexpr PlanePoint operator*(double k, PlanePoint a) { return {k * a.x, k * a.y}; }
constexpr double dot(PlanePoint a, PlanePoint b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(PlanePoint a, PlanePoint b) { return a.x * b.y - a.y * b.x; }
inline double length(PlanePoint a) { return std::sqrt(dot(a, a)); }

struct PlaneSegment {
  PlanePoint from, to;

  constexpr PlanePoint at(double position) const { return from + position * (to - from); }
};

inline double length(const PlaneSegment& s) { return length(s.to - s.from); }

inline PlanePoint normal(const PlaneSegment& s) {
  const PlanePoint d = s.to - s.from;
  return (1 / length(d)) * PlanePoint{-d.y, d.x};
}

// Where on the segment, in [0, 1], the point nearest to p lies.
inline double nearest_position(PlanePoint p, const PlaneSegment& s) {
  const PlanePoint d = s.to - s.from;
  return std::clamp(dot(p - s.from, d) / dot(d, d), 0.0, 1.0);
}

inline double distance(PlanePoint p, const PlaneSegment& s) {
  return length(p - s.at(nearest_position(p, s)));
}

enum class Side { front, back };

constexpr double sign_of(Side side) { return side == Side::front ? 1 : -1; }

// A place that gathers light: from the half plane that its unit normal points into.
struct Receiver {
  PlanePoint position, normal;
};

}  // namespace wander::exact

// The curves of the plane as scene files name them.  A kind of shape offers
//   name        in scene files
//   fields()    its keys
//   flaws()     what the schema cannot say against it
//   outline()   its course, in its direction: for figures, records and doubts, not for rays
//   length()    of the whole curve
// and, beside the curves that rays meet, add_curves<World>(kind, add), which adds them.
#pragma once

#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "core/shape_description.h"

namespace wander::description {

struct Segment;
struct Arc;
// Straight lines and circular arcs, one after the other.
using Outline = std::vector<std::variant<Segment, Arc>>;

struct Segment {
  static constexpr std::string_view name = "segment";
  static constexpr auto fields() {
    return std::tuple(Field{"from", &Segment::from}, Field{"to", &Segment::to});
  }

  Coordinates from{}, to{};

  Flaws flaws() const;
  Outline outline() const;
  double length() const;
};

struct Polyline {
  static constexpr std::string_view name = "polyline";
  static constexpr auto fields() {
    return std::tuple(Field{"points", &Polyline::points}, Field{"closed", &Polyline::closed});
  }

  std::vector<Coordinates> points;
  bool closed = false;

  // Calls visit(from, to) for each.
  template <class Visitor>
  void for_each_side(Visitor&& visit) const {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) visit(points[i], points[i + 1]);
    if (closed) visit(points.back(), points.front());
  }
  Flaws flaws() const;
  Outline outline() const;
  double length() const;
};

struct Circle {
  static constexpr std::string_view name = "circle";
  static constexpr auto fields() {
    return std::tuple(Field{"center", &Circle::center}, Field{"radius", &Circle::radius},
                      Field{"flip", &Circle::flip});
  }

  Coordinates center{};
  double radius = 0;
  bool flip = false;

  Flaws flaws() const;
  Outline outline() const;
  double length() const;
};

// Counter-clockwise; equal ends are a full turn.
struct Arc {
  static constexpr std::string_view name = "arc";
  static constexpr auto fields() {
    return std::tuple(Field{"center", &Arc::center}, Field{"radius", &Arc::radius},
                      Field{"from_deg", &Arc::from_degrees}, Field{"to_deg", &Arc::to_degrees},
                      Field{"flip", &Arc::flip});
  }

  Coordinates center{};
  double radius = 0, from_degrees = 0, to_degrees = 0;
  bool flip = false;

  // Above 0, and at most 360.
  double degrees_turned() const;
  Flaws flaws() const;
  Outline outline() const;
  double length() const;
};

}  // namespace wander::description

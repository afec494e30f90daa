// The curves of a scene as a draughtsman needs them: where they run, which way they face, and how
// to say so in SVG.  Circles and arcs stay what they are.
#pragma once

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "core/description.h"
#include "draw/figure/svg.h"

namespace wander::figure {

struct Line {
  Vector from, to;
};
// Counter-clockwise from `start`; a circle has an extent of a full turn.
struct Bend {
  Vector center;
  double radius, start, extent;  // radians
  double facing;                 // +1: the normal points away from the centre, -1: towards it
};
using Curve = std::variant<Line, Bend>;

// In drawing order; a polyline has one for each of its sides.
std::vector<Curve> curves(const description::ShapeKind& shape);
// The curves of one shape lead back to their start.
bool is_closed(const std::vector<Curve>& outline);

struct Spot {
  Vector position, normal;
};
// At a fraction of the arc length in the direction of the curve.
Spot spot(const Curve& curve, double fraction);
double length(const Curve& curve);

struct Extent {
  Vector low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};

  void include(Vector point);
  void include(const Curve& curve);
  Vector size() const { return high - low; }
};

// Metres to points: equal in both directions, with y up in the scene and down on the page.
struct PageMap {
  Vector scene_origin, page_origin;
  double scale = 1;  // points per metre

  Vector operator()(Vector p) const {
    return {page_origin.x + (p.x - scene_origin.x) * scale,
            page_origin.y - (p.y - scene_origin.y) * scale};
  }
  Vector direction(Vector d) const { return {d.x, -d.y}; }
};

// One connected path, closed where the shape is.
std::string outline(const description::ShapeKind& shape, const PageMap& map);
// A curve moved along its normal by an offset in points.
std::string outline(const Curve& curve, const PageMap& map, double offset);

// What continues a path along a curve from one of its ends to the other.
enum class Direction { along, against };
std::string continuation(const Curve& curve, const PageMap& map, Direction direction);

}  // namespace wander::figure

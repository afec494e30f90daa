// Closed polygons for tests of watertightness: convex, star-shaped with any radii, with acute
// spikes, and with corners made by walls that end on other walls.  They run counter-clockwise
// around the origin, which sees every corner; the inside is on the left.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/shape.h"
#include "tests/support/generator.h"

namespace wander::test {

using Corner = Flatland::Point;

struct Wall2 {
  Corner from, to;
};

inline std::vector<Wall2> closed(const std::vector<Corner>& corners) {
  std::vector<Wall2> walls;
  for (std::size_t i = 0; i < corners.size(); ++i)
    walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return walls;
}

inline std::vector<double> sorted_angles(Generator& g, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i)  // from four on, no gap reaches half a turn
    angles.push_back(2 * std::numbers::pi * (i + 0.9 * g.uniform()) / count);
  return angles;
}

template <class Radius>
std::vector<Corner> star(Generator& g, int count, Radius radius) {
  std::vector<Corner> corners;
  for (const double a : sorted_angles(g, count)) {
    const double r = radius(corners.size());
    corners.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return corners;
}

// `count` >= 4 in all of these.
inline std::vector<Wall2> convex_polygon(Generator& g, int count) {
  return closed(star(g, count, [](std::size_t) { return 1.0; }));
}
inline std::vector<Wall2> uneven_polygon(Generator& g, int count) {
  return closed(star(g, count, [&](std::size_t) { return 0.2 + g.uniform(); }));
}
// Every second corner far out: angles of the spikes go down to 1e-4.
inline std::vector<Wall2> spiky_polygon(Generator& g, int count) {
  return closed(star(g, 2 * count, [&](std::size_t i) {
    return i % 2 == 0 ? 0.01 + 0.02 * g.uniform() : std::pow(10, 2 * g.uniform());
  }));
}
// Each wall is prolonged at its far end, so the next one starts somewhere along it: a T, whose foot
// lies on the longer wall only to rounding.
inline std::vector<Wall2> overlapping_polygon(Generator& g, int count) {
  std::vector<Wall2> walls = convex_polygon(g, count);
  for (Wall2& wall : walls) wall.to += (0.1 + g.uniform()) * (wall.to - wall.from);
  return walls;
}

// Moved and scaled, so that coordinates are not round the origin.
inline std::vector<Wall2> moved(std::vector<Wall2> walls, Corner offset, double scale) {
  for (Wall2& wall : walls) {
    wall.from = offset + scale * wall.from;
    wall.to = offset + scale * wall.to;
  }
  return walls;
}

}  // namespace wander::test

#include "draw/figure/region.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace wander::figure {
namespace {

// A curve in the direction that has its back on the left.
struct Side {
  Curve curve;
  Direction direction;

  Vector start() const { return spot(curve, direction == Direction::along ? 0 : 1).position; }
  Vector end() const { return spot(curve, direction == Direction::along ? 1 : 0).position; }
};

Side with_back_on_left(const Curve& curve) {
  // The normal of a line is on its left, that of a counter-clockwise arc, unless turned, on its
  // right.
  const Bend* bend = std::get_if<Bend>(&curve);
  return {curve, bend && bend->facing > 0 ? Direction::along : Direction::against};
}

using Loop = std::vector<Side>;

// The sides of one shape, end to end.
Loop loop_of(const std::vector<Curve>& outline) {
  Loop loop;
  for (const Curve& curve : outline) loop.push_back(with_back_on_left(curve));
  if (loop.front().direction == Direction::against) std::reverse(loop.begin(), loop.end());
  return loop;
}

// Positive when the loop runs counter-clockwise, its back within.
double signed_area(const Loop& loop) {
  constexpr int samples = 16;  // of each side: the sign is all that counts
  const Vector origin = loop.front().start();
  double twice = 0;
  for (const Side& side : loop) {
    for (int k = 0; k < samples; ++k) {
      const auto at = [&](int i) {
        const double u = static_cast<double>(i) / samples;
        return spot(side.curve, side.direction == Direction::along ? u : 1 - u).position - origin;
      };
      twice += cross(at(k), at(k + 1));
    }
  }
  return twice / 2;
}

// Takes sides that follow `first` out of `pool` until they lead back to its start.  A side that is
// taken but leads nowhere is open: a curve belongs to one outline only.
Loop follow(const Side& first, std::vector<Side>& pool, double tolerance) {
  const auto joined = [&](Vector a, Vector b) { return glm::distance(a, b) <= tolerance; };
  Loop loop{first};
  while (!joined(loop.back().end(), first.start())) {
    const auto next = std::find_if(pool.begin(), pool.end(), [&](const Side& side) {
      return joined(side.start(), loop.back().end());
    });
    if (next == pool.end()) break;
    loop.push_back(*next);
    pool.erase(next);
  }
  return loop;
}

std::string path_of(const Loop& loop, const PageMap& map) {
  std::string data = "M" + coordinates(map(loop.front().start()));
  for (const Side& side : loop) data += continuation(side.curve, map, side.direction);
  return data + "Z";
}

}  // namespace

Insides find_insides(const std::vector<description::ShapeKind>& outlines, const PageMap& map,
                     double scene_size) {
  const double tolerance = 1e-6 * scene_size;
  Insides insides;
  const auto add = [&](const Loop& loop) {
    const bool closed = glm::distance(loop.back().end(), loop.front().start()) <= tolerance;
    if (closed && signed_area(loop) > 0) return insides.regions.push_back(path_of(loop, map));
    for (const Side& side : loop) insides.open.push_back(side.curve);
  };

  std::vector<Side> pool;
  for (const description::ShapeKind& shape : outlines) {
    const std::vector<Curve> outline = curves(shape);
    Loop alone = loop_of(outline);
    if (is_closed(outline))
      add(alone);
    else
      pool.insert(pool.end(), alone.begin(), alone.end());
  }
  while (!pool.empty()) {
    const Side first = pool.back();
    pool.pop_back();
    add(follow(first, pool, tolerance));
  }
  return insides;
}

}  // namespace wander::figure

// f/p and the weight of a path, from the two sides of the edge at which technique (s,t) connects it.
//
// Each side is made vertex by vertex, from its end of the path towards the edge, so subpaths that are
// connected again and again keep what is far behind their ends: a connection then costs the same however
// long the path is, and has the bits of the path measured as a whole.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/techniques.h"

namespace wander {

// Some vertices at an end of a path.
template <class W>
struct PathSide {
  double product = 1;  // Π value / p, with the edges between them
  double ratios =
      0;  // Σ_j (p_j / p_s)^β over the techniques j that connect before this side's edge
  [[no_unique_address]] typename W::Tint tint{};
};

// What techniques are weighed against each other, and how.
struct Weighing {
  TechniqueSet set;
  Heuristic heuristic;
};

// Of x_0 … x_{i-1}, and x_i.
template <class Space, class W>
void add_light_vertex(PathSide<W>& side, const Space& space, const Path<W>& x, int i,
                      const Weighing& by) {
  side.product *= light_factor(x, i);
  side.ratios = ratios_past_light_vertex(space, x, i, by.set, by.heuristic, side.ratios);
  side.tint *= x[i].tint;
}
// Of x_{n-1} … x_{i+1}, and x_i.
template <class Space, class W>
void add_sensor_vertex(PathSide<W>& side, const Space& space, const Path<W>& x, int i,
                       const Weighing& by) {
  side.product *= sensor_factor(x, i);
  side.ratios = ratios_past_sensor_vertex(space, x, i, by.set, by.heuristic, side.ratios);
  side.tint *= x[i].tint;
}

// Both, of the path that technique (s,t) connects between them.
template <class W>
struct PathSides {
  PathSide<W> light, sensor;

  // w_s
  double mis_weight() const { return 1 / (1 + light.ratios + sensor.ratios); }
  // Π tint_i
  typename W::Tint tint() const {
    typename W::Tint product = light.tint;
    product *= sensor.tint;
    return product;
  }
};

// f / p_{s,t}
template <class W>
double unweighted_contribution(const Path<W>& x, int s, const PathSides<W>& sides) {
  const double edge = s > 0 && s < x.size() ? x[s - 1].geometry : 1;
  return sides.light.product * sides.sensor.product * (edge * luminance(sides.tint()));
}

// w_s f / p_{s,t}; 0 where that is no positive number.
template <class W>
double weighted_contribution(const Path<W>& x, int s, const PathSides<W>& sides) {
  const double c = unweighted_contribution(x, s, sides);
  return c > 0 && std::isfinite(c) ? c * sides.mis_weight() : 0;
}

// Of a whole path.
template <class Space, class W>
PathSides<W> sides_of(const Space& space, const Path<W>& x, int s, const Weighing& by) {
  PathSides<W> sides;
  for (int i = 0; i < s; ++i) add_light_vertex(sides.light, space, x, i, by);
  for (int i = x.size() - 1; i >= s; --i) add_sensor_vertex(sides.sensor, space, x, i, by);
  return sides;
}

// The sides that a subpath gives to the paths of all techniques, by how many of its vertices belong to them:
// each is made once, when it is first asked for.
template <class W>
class KnownPathSides {
 public:
  explicit KnownPathSides(int longest) : sides_(static_cast<std::size_t>(longest) + 1) {}

  void clear() { known_ = 0; }
  // Of the first `count` vertices; add(side, k) adds vertex k.
  template <class Add>
  const PathSide<W>& first(int count, Add&& add) {
    for (; known_ < count; ++known_) {
      PathSide<W>& next = at(known_ + 1) = at(known_);
      add(next, known_);
    }
    return at(std::max(count, 0));
  }

 private:
  PathSide<W>& at(int count) { return sides_[static_cast<std::size_t>(count)]; }

  std::vector<PathSide<W>> sides_;  // the first is of no vertices
  int known_ = 0;
};

}  // namespace wander

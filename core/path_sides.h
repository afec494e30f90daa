// f / p_{s,t} and the weight w_s of a path, from the two sides of the edge at which technique (s,t) connects it
// [Veach 1997, 10.2 and 9.2.2].  Densities and f are of the area product (path.h).
//
// Each side is made vertex by vertex, from its end of the path towards the edge, so subpaths that are
// connected again and again keep what is far behind their ends: a connection then costs the same however
// long the path is, and has the bits of the path measured as a whole.
#pragma once

#include <cmath>
#include <vector>

#include "core/techniques.h"

namespace wander {

// What techniques are weighed against each other, and how.
struct Weighing {
  TechniqueSet set;
  Heuristic heuristic;
};

// Some vertices at an end of a path.
template <class W>
struct PathSide {
  double product = 1;  // Π value / p, with the edges between them, times the luminance of Π tint
  double ratios = 0;   // Σ_j (p_j / p_i)^β: the edges of j are among them, that of i behind
  [[no_unique_address]] typename W::Tint tint{};  // Π tint, of luminance 1

  // The next vertex, whose edge to the last one has this geometry.  Of the techniques i, with the edge
  // before it, and k, with the edge behind it, k samples it from here and i from there, so
  // p_i / p_k = from_there / from_here.  Horner's rule sums ratios outwards,
  //   Σ_j (p_j / p_k)^β = (p_i / p_k)^β (1 + Σ_j (p_j / p_i)^β),
  // the 1 if technique i can sample the path, else 0: nothing overflows before the weight itself vanishes.
  void add(const Vertex<W>& v, double geometry, double from_here, double from_there,
           double possible, Heuristic heuristic) {
    product *= geometry * double(v.value) / from_here;
    ratios = raised(from_there / from_here, heuristic) * (possible + ratios);
    tint *= v.tint;
    product *= tint.normalize();
  }
};

// Of x_0 … x_{i-1}, and x_i.
template <class Space, class W>
void add_light_vertex(PathSide<W>& side, const Space& space, const Path<W>& x, int i,
                      const Weighing& by) {
  side.add(x[i], i > 0 ? x[i - 1].geometry : 1, double(x[i].from_light), double(x[i].from_sensor),
           can_sample(space, x, i, by.set) ? 1 : 0, by.heuristic);
}
// Of x_{n-1} … x_{i+1}, and x_i.
template <class Space, class W>
void add_sensor_vertex(PathSide<W>& side, const Space& space, const Path<W>& x, int i,
                       const Weighing& by) {
  side.add(x[i], i + 1 < x.size() ? x[i].geometry : 1, double(x[i].from_sensor),
           double(x[i].from_light), can_sample(space, x, i + 1, by.set) ? 1 : 0, by.heuristic);
}

// Both, of the path that technique (s,t) connects between them.
template <class W>
struct PathSides {
  PathSide<W> light, sensor;

  // w_s
  double mis_weight() const { return 1 / (1 + light.ratios + sensor.ratios); }
  // Π tint_i, but for the luminance that is in the products
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
    return at(count);
  }

 private:
  PathSide<W>& at(int count) { return sides_[static_cast<std::size_t>(count)]; }

  std::vector<PathSide<W>> sides_;  // the first is of no vertices
  int known_ = 0;
};

}  // namespace wander

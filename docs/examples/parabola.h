// The parabola: a mirror of this form gathers in its focus what arrives along its axis.
//
// With the vertex v, the unit vector a from it to the focus, the unit vector c to the right of a,
// and the focal length f, its points are
//   p(t) = v + 2 f t c + f t² a,   |t| <= T = width / (4 f)
// and the arc from v to p(t) has the length f g(t) with g(t) = t √(1+t²) + asinh t.  The normal
// points to the side of the focus.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/curves.h"
#include "core/geometry/shapes_flat.h"

namespace wander {

namespace description {

struct Parabola {
  static constexpr std::string_view name = "parabola";
  static constexpr auto fields() {
    return std::tuple(Field{"vertex", &Parabola::vertex}, Field{"focus", &Parabola::focus},
                      Field{"width", &Parabola::width});
  }

  Coordinates vertex{}, focus{};
  double width = 0;  // across the axis, from end to end

  Flaws flaws() const {
    if (too_near(vertex, focus)) return {{"focus", "too near to the vertex; they lie apart"}};
    if (width < shortest_length) return {{"width", too_short}};
    return {};
  }
  Outline outline() const;
  double length() const;
};

}  // namespace description

template <World W>
class Parabola {
 public:
  using Length = typename W::Length;
  using Point = typename W::Point;
  static constexpr bool flat = false;

  Parabola(Point vertex, Point focus, Length width)
      : vertex_(vertex),
        axis_(glm::normalize(focus - vertex)),
        across_(-left_of(axis_)),
        focal_length_(glm::length(focus - vertex)),
        end_(width / (4 * focal_length_)) {}

  // With (x, y) along c and a from the vertex, x² = 4 f y is a square equation for the distance.
  // Where the ray touches this curve one root is known, 0 or 1, and is divided out.
  Length intersect(const Ray<W>& ray, Element<W> self) const {
    const Point o = local(ray.origin - vertex_), d = local(ray.direction);
    const Length a = d.x * d.x, half_b = o.x * d.x - 2 * focal_length_ * d.y;
    const bool leaves = ray.from == self, arrives = ray.to == self;
    if (leaves && arrives) return miss();
    if (leaves) return valid(ray, -2 * half_b / a);
    const Length c = o.x * o.x - 4 * focal_length_ * o.y;
    if (arrives) return valid(ray, c / a);
    const Length discriminant = half_b * half_b - a * c;
    if (discriminant < 0) return miss();
    const Length q = -(half_b + std::copysign(std::sqrt(discriminant), half_b));
    return std::min(valid(ray, q / a), valid(ray, c / q));
  }
  SurfacePoint<W> surface(const Ray<W>& ray, const Hit<W>& hit) const {
    return at(t_of(ray.origin + hit.distance * ray.direction));
  }
  SurfacePoint<W> sample(typename W::Square u) const {
    const Length length = (2 * Length(u[0]) - 1) * g(end_);
    return at(std::copysign(inverse_of_g(std::abs(length)), length));
  }
  typename W::Square parameter(Point p, PrimitiveId<W> = {}) const {
    return {into_unit<typename W::Real>((1 + g(t_of(p)) / g(end_)) / 2)};
  }
  Length measure() const { return 2 * focal_length_ * g(end_); }
  // Of its ends, and of the point where their tangents meet: it lies in this triangle.
  Box<W> bounds() const {
    const Point a = at(-end_).position, b = at(end_).position;
    const Point corner = vertex_ - focal_length_ * end_ * end_ * axis_;
    return {glm::min(glm::min(a, b), corner), glm::max(glm::max(a, b), corner)};
  }

  SurfacePoint<W> at(Length t) const {
    const Point position =
        vertex_ + 2 * focal_length_ * t * across_ + focal_length_ * t * t * axis_;
    return {position, glm::normalize(axis_ - t * across_)};
  }
  Length end() const { return end_; }

 private:
  static constexpr Length miss() { return std::numeric_limits<Length>::infinity(); }
  static Length g(Length t) { return t * std::sqrt(1 + t * t) + std::asinh(t); }
  // Newton's iteration for s >= 0.  g is convex and at least 2t and t², so it begins above the root,
  // comes down to it, and ends when it no longer falls.
  static Length inverse_of_g(Length s) {
    for (Length t = std::min(s / 2, std::sqrt(s));;) {
      const Length next = t - (g(t) - s) / (2 * std::sqrt(1 + t * t));
      if (!(next < t)) return t;
      t = next;
    }
  }

  Point local(Point v) const { return {glm::dot(v, across_), glm::dot(v, axis_)}; }
  Length t_of(Point p) const { return local(p - vertex_).x / (2 * focal_length_); }
  Length valid(const Ray<W>& ray, Length distance) const {
    if (!(distance > 0 && distance < ray.limit)) return miss();
    return std::abs(t_of(ray.origin + distance * ray.direction)) <= end_ ? distance : miss();
  }

  Point vertex_, axis_, across_;
  Length focal_length_, end_;  // f and T
};

template <World W, class Add>
void add_curves(const description::Parabola& s, Add&& add) {
  add(Parabola<W>(point_of<W>(s.vertex), point_of<W>(s.focus), s.width));
}

namespace description {

inline double Parabola::length() const {
  return wander::Parabola<Flatland>(point_of<Flatland>(vertex), point_of<Flatland>(focus), width)
      .measure();
}

// Chords: figures and doubts need no more.
inline Outline Parabola::outline() const {
  constexpr int chords = 64;
  const wander::Parabola<Flatland> curve(point_of<Flatland>(vertex), point_of<Flatland>(focus),
                                         width);
  const auto point = [&](int k) -> Coordinates {
    const auto p = curve.at(curve.end() * (2.0 * k / chords - 1)).position;
    return {p.x, p.y, 0};
  };
  Outline strokes;
  for (int k = 0; k < chords; ++k) strokes.push_back(Segment{point(k), point(k + 1)});
  return strokes;
}

}  // namespace description

}  // namespace wander

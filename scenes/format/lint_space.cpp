#include "scenes/format/lint_space.h"
#include "scenes/format/lint_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <optional>

namespace wander {

namespace {

using Point = glm::dvec3;
constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t most_pairs = 10'000'000;

Point point_of(const description::Coordinates& c) { return {c[0], c[1], c[2]}; }

// A triangle or parallelogram: corner + u edge0 + v edge1.
struct Sheet {
  Point corner{}, edge0{}, edge1{};
  bool is_triangle = false;

  Point normal() const { return glm::normalize(glm::cross(edge0, edge1)); }
  std::array<Point, 4> inner_points() const {
    const auto at = [&](double u, double v) { return corner + u * edge0 + v * edge1; };
    if (is_triangle) return {at(0.33, 0.33), at(0.01, 0.01), at(0.98, 0.01), at(0.01, 0.98)};
    return {at(0.5, 0.5), at(0.01, 0.01), at(0.99, 0.01), at(0.99, 0.99)};
  }
  // Of a point in its plane.
  bool holds(Point p) const {
    const Point area = glm::cross(edge0, edge1);
    const double size = glm::dot(area, area);
    const double u = glm::dot(glm::cross(p - corner, edge1), area) / size,
                 v = glm::dot(glm::cross(edge0, p - corner), area) / size;
    return u > 0 && v > 0 && (is_triangle ? u + v < 1 : u < 1 && v < 1);
  }
};

struct Extent {
  Point low{infinity}, high{-infinity};

  void include(Point p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

// What of a shape is looked at.
struct Measured {
  Extent extent;
  std::size_t faces = 0, flattened = 0;  // flattened ones have no area
  double feature = infinity;             // of the last face
  std::optional<Sheet> sheet;            // that face, if it is flat

  void operator()(const description::Triangle& s) {
    const Point a = point_of(s.points[0]), b = point_of(s.points[1]), c = point_of(s.points[2]);
    for (const Point& p : {a, b, c}) extent.include(p);
    ++faces;
    if (glm::cross(b - a, c - a) == Point(0)) {
      ++flattened;
      return;
    }
    feature = std::min({glm::length(b - a), glm::length(c - a), glm::length(c - b)});
    sheet = Sheet{a, b - a, c - a, true};
  }
  void operator()(const description::Parallelogram& s) {
    ++faces;
    sheet = Sheet{point_of(s.origin), point_of(s.edges[0]), point_of(s.edges[1])};
    for (const double u : {0, 1})
      for (const double v : {0, 1})
        extent.include(sheet->corner + u * sheet->edge0 + v * sheet->edge1);
    feature = std::min(glm::length(sheet->edge0), glm::length(sheet->edge1));
  }
  void operator()(const description::Sphere& s) {
    ++faces;
    extent.include(point_of(s.center) - s.radius);
    extent.include(point_of(s.center) + s.radius);
    feature = s.radius;
  }
};

// Of a surface of many faces none is looked at alone.
Measured measured(const description::ShapeKind& kind) {
  Measured shape;
  description::visit_kind<3>([&](const auto& surface) { surface.for_each_face(shape); }, kind);
  if (shape.faces == 1) return shape;
  shape.feature = infinity;
  shape.sheet.reset();
  return shape;
}

class LintOfSpace {
 public:
  explicit LintOfSpace(const description::Scene& scene) : scene_(scene) {
    Extent all;
    for (const description::Shape& shape : scene.shapes) {
      measured_.push_back(measured(shape.kind));
      all.include(measured_.back().extent.low);
      all.include(measured_.back().extent.high);
    }
    diameter_ = glm::length(all.high - all.low);
    const Point reach = glm::max(glm::abs(all.low), glm::abs(all.high));
    remoteness_ = std::max({reach.x, reach.y, reach.z}) / diameter_;
  }

  std::vector<Fault> warnings() && {
    doubt_extent();
    for (std::size_t i = 0; i < measured_.size(); ++i) doubt_shape(i);
    doubt_overlaps();
    return std::move(warnings_);
  }

 private:
  void warn(std::size_t shape, std::string what) {
    if (warnings_.size() >= most_warnings) return;
    const description::Shape& place = scene_.shapes[shape];
    warnings_.push_back(
        {place.line, place.column, fmt::format("/shapes/{}", shape), std::move(what)});
  }

  void doubt_extent() {
    if (remoteness_ > most_remote)
      warn(0, fmt::format("the scene lies {:.1e} of its diameters from the origin, which costs as "
                          "many digits; move it nearer to (0, 0, 0)",
                          remoteness_));
  }

  void doubt_shape(std::size_t i) {
    const Measured& shape = measured_[i];
    if (shape.feature < smallest_feature * diameter_)
      warn(i, fmt::format("this shape is {:.1e} times smaller than the scene, too small for exact "
                          "results; ratios up to 1e12 are safe",
                          diameter_ / shape.feature));
    if (shape.flattened > 0)
      warn(i, fmt::format("{} of the triangles of this mesh {} no area, and light never meets {}; "
                          "leave them out of the file",
                          shape.flattened, shape.flattened == 1 ? "has" : "have",
                          shape.flattened == 1 ? "it" : "them"));
  }

  void doubt_overlaps() {
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < measured_.size(); ++i) {
      const description::Shape& shape = scene_.shapes[i];
      if (!measured_[i].sheet || !(shape.light || shape.sensor)) continue;
      for (std::size_t j = 0; j < measured_.size() && ++pairs < most_pairs; ++j)
        if (j != i && measured_[j].sheet && overlap(*measured_[i].sheet, *measured_[j].sheet))
          warn(i, fmt::format("the {0} lies on /shapes/{1} at no distance and may be hidden by it; "
                              "move it a small distance off, or put the {0} on /shapes/{1} itself",
                              shape.light ? "light" : "sensor", j));
    }
  }
  bool overlap(const Sheet& a, const Sheet& b) const {
    const double rounding =
        32 * std::numeric_limits<double>::epsilon() * diameter_ * (1 + remoteness_);
    const Point normal = b.normal();
    if (glm::length(glm::cross(a.normal(), normal)) > 1e-9 ||
        std::abs(glm::dot(a.corner - b.corner, normal)) > rounding)
      return false;
    const auto points = a.inner_points(), others = b.inner_points();
    return std::ranges::any_of(points, [&](Point p) { return b.holds(p); }) ||
           std::ranges::any_of(others, [&](Point p) { return a.holds(p); });
  }

  const description::Scene& scene_;
  std::vector<Measured> measured_;
  double diameter_ = 0, remoteness_ = 0;
  std::vector<Fault> warnings_;
};

}  // namespace

std::vector<Fault> lint_space(const description::Scene& scene) {
  return LintOfSpace(scene).warnings();
}

}  // namespace wander

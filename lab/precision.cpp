#include "lab/precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wander {

namespace {

struct Range {
  double least, most;
  bool holds(double x) const { return x >= least && x <= most; }
};
constexpr Range lengths{1e-15, 1e15}, reflectances{1e-30, 1};

// How far a shape reaches from the origin, and how long it is at least.
struct Reach {
  double farthest = 0, shortest = std::numeric_limits<double>::infinity();

  void point(const description::Coordinates& p) {
    farthest = std::max({farthest, std::abs(p[0]), std::abs(p[1])});
  }
  void operator()(const description::Segment& s) {
    point(s.from);
    point(s.to);
    shortest = std::min(shortest, s.length());
  }
  void operator()(const description::Arc& s) {
    point(s.center);
    farthest = std::max(farthest, s.radius);
    shortest = std::min(shortest, s.radius);
  }
};

double reflectance_of(const description::MaterialKind& kind) {
  return std::visit(
      [](const auto& material) -> double {
        if constexpr (requires { material.reflectance; })
          return material.reflectance.channels[0];
        else
          return 1;
      },
      kind);
}

std::string beyond(std::string_view what, double value, const Range& range) {
  return fmt::format("{} {:g}: allowed is {:g} to {:g}", what, value, range.least, range.most);
}

}  // namespace

std::string why_beyond(Precision precision, const description::Scene& scene) {
  if (precision == Precision::of_double) return {};
  for (const auto& material : scene.materials) {
    const double reflectance = reflectance_of(material.kind);
    if (reflectance > 0 && !reflectances.holds(reflectance))
      return fmt::format("material {}: {}", material.name,
                         beyond("reflectance", reflectance, reflectances));
  }
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const auto& shape = scene.shapes[i];
    Reach reach;
    for (const auto& stroke : outline_of(shape.kind))
      std::visit([&](const auto& s) { reach(s); }, stroke);
    for (const double length : {reach.farthest, reach.shortest})
      if (!lengths.holds(length))
        return fmt::format("/shapes/{}: {}", i, beyond("length", length, lengths));
  }
  const double lens = scene.camera ? scene.camera->aperture_radius : 0;
  if (lens > 0 && !lengths.holds(lens)) return beyond("/camera: aperture_radius", lens, lengths);
  return {};
}

}  // namespace wander

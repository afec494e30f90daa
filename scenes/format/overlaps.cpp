#include "scenes/format/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "scenes/format/measured_face.h"

namespace wander {

namespace {

using Point = glm::dvec3;

constexpr std::size_t most_pairs = 10'000'000, most_named = 1000;

bool overlap(const Sheet& a, const Sheet& b, double rounding) {
  const Point normal = b.normal();
  if (glm::length(glm::cross(a.normal(), normal)) > 1e-9 ||
      std::abs(glm::dot(a.corner - b.corner, normal)) > rounding)
    return false;
  const auto points = a.inner_points(), others = b.inner_points();
  return std::ranges::any_of(points, [&](Point p) { return b.holds(p); }) ||
         std::ranges::any_of(others, [&](Point p) { return a.holds(p); });
}
bool overlap(const Ball& a, const Ball& b, double rounding) {
  return glm::length(a.center - b.center) <= rounding && std::abs(a.radius - b.radius) <= rounding;
}
bool overlap(const Sheet&, const Ball&, double) { return false; }
bool overlap(const Ball&, const Sheet&, double) { return false; }

struct PlacedFace {
  Face face;
  Extent extent;
  std::size_t shape = 0;
};

bool has_role(const description::Shape& shape) { return shape.light || shape.sensor; }

class Search {
 public:
  Search(const description::Scene& scene, double rounding) : scene_(scene), rounding_(rounding) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
      if (has_role(scene.shapes[i]))
        for_each_face(scene.shapes[i].kind, [&](const Face& face) {
          roles_.push_back({face, extent_of(face), i});
          all_roles_.include(roles_.back().extent);
        });
  }

  Overlaps found() && {
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
      for_each_face(scene_.shapes[i].kind, [&](const Face& face) { compare_with_roles(face, i); });
      if (has_role(scene_.shapes[i])) continue;
      if (const auto face = only_face_of(scene_.shapes[i].kind)) compare_with_sheets(*face, i);
    }
    return std::move(found_);
  }

 private:
  // A pair of lights is met from both sides, and said once.
  void compare_with_roles(const Face& face, std::size_t shape) {
    const Extent extent = extent_of(face);
    if (!extent.meets(all_roles_, rounding_)) return;
    for (const PlacedFace& role : roles_) {
      if (role.shape == shape || (has_role(scene_.shapes[shape]) && shape < role.shape)) continue;
      if (++pairs_with_roles_ > most_pairs) return;
      if (extent.meets(role.extent, rounding_) && overlap_of(role.face, face))
        note(found_.of_roles, {role.shape, shape});
    }
  }

  void compare_with_sheets(const Face& face, std::size_t shape) {
    const PlacedFace placed{face, extent_of(face), shape};
    for (const PlacedFace& other : sheets_) {
      if (++pairs_of_sheets_ > most_pairs) return;
      if (placed.extent.meets(other.extent, rounding_) && overlap_of(face, other.face))
        note(found_.of_sheets, {shape, other.shape});
    }
    sheets_.push_back(placed);
  }

  bool overlap_of(const Face& a, const Face& b) const {
    return std::visit([&](const auto& x, const auto& y) { return overlap(x, y, rounding_); }, a, b);
  }

  static void note(std::vector<Overlap>& list, Overlap pair) {
    const auto is_same = [pair](const Overlap& o) {
      return o.shape == pair.shape && o.other == pair.other;
    };
    if (list.size() < most_named && std::ranges::none_of(list, is_same)) list.push_back(pair);
  }

  const description::Scene& scene_;
  double rounding_ = 0;
  std::vector<PlacedFace> roles_, sheets_;
  Extent all_roles_;
  std::size_t pairs_with_roles_ = 0, pairs_of_sheets_ = 0;
  Overlaps found_;
};

}  // namespace

Overlaps overlaps_of(const description::Scene& scene, double rounding) {
  return Search(scene, rounding).found();
}

}  // namespace wander

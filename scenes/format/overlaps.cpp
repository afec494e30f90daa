#include "scenes/format/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <utility>
#include <variant>

#include "scenes/format/measured_face.h"

namespace wander {

namespace {

using Point = glm::dvec3;

constexpr std::size_t most_pairs = 10'000'000, most_named = 1000, most_passive_faces = 50'000;

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
  bool is_alone = false;  // the only face of its shape
};

bool has_role(const description::Shape& shape) { return shape.light || shape.sensor; }

bool lets_light_through(const description::Scene& scene, const description::Shape& shape) {
  if (!shape.material) return false;
  const description::MaterialKind& kind = scene.materials[*shape.material].kind;
  return std::holds_alternative<description::Dielectric>(kind) ||
         std::holds_alternative<description::RoughDielectric>(kind);
}

bool overlap(const Face& a, const Face& b, double rounding) {
  return std::visit([&](const auto& x, const auto& y) { return overlap(x, y, rounding); }, a, b);
}

void note(std::vector<Overlap>& list, Overlap pair) {
  const auto is_same = [pair](const Overlap& o) {
    return o.shape == pair.shape && o.other == pair.other;
  };
  if (list.size() < most_named && std::ranges::none_of(list, is_same)) list.push_back(pair);
}

class OfRoles {
 public:
  OfRoles(const description::Scene& scene, double rounding) : scene_(scene), rounding_(rounding) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
      if (!has_role(scene.shapes[i])) continue;
      Role& role = roles_.emplace_back(Role{.shape = i});
      for_each_face(scene.shapes[i].kind, [&](const Face& face) {
        role.faces.push_back({face, extent_of(face), i});
        role.extent.include(role.faces.back().extent);
      });
      all_roles_.include(role.extent);
    }
  }

  std::vector<Overlap> found() && {
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i)
      for_each_face(scene_.shapes[i].kind, [&](const Face& face) { compare(face, i); });
    return std::move(found_);
  }

 private:
  struct Role {
    std::size_t shape = 0;
    std::vector<PlacedFace> faces{};
    Extent extent{};
  };

  void compare(const Face& face, std::size_t shape) {
    const Extent extent = extent_of(face);
    if (!extent.meets(all_roles_, rounding_)) return;
    for (const Role& role : roles_) {
      // A pair of lights is met from both sides, and said once.
      if (role.shape == shape || (has_role(scene_.shapes[shape]) && shape < role.shape)) continue;
      if (++pairs_ > most_pairs) return;
      if (extent.meets(role.extent, rounding_)) compare(face, extent, shape, role);
    }
  }
  void compare(const Face& face, const Extent& extent, std::size_t shape, const Role& role) {
    for (const PlacedFace& own : role.faces) {
      if (++pairs_ > most_pairs) return;
      if (extent.meets(own.extent, rounding_) && overlap(own.face, face, rounding_))
        note(found_, {role.shape, shape});
    }
  }

  const description::Scene& scene_;
  double rounding_ = 0;
  std::vector<Role> roles_;
  Extent all_roles_;
  std::size_t pairs_ = 0;
  std::vector<Overlap> found_;
};

class OfPassive {
 public:
  OfPassive(const description::Scene& scene, double rounding) : scene_(scene), rounding_(rounding) {
    for (std::size_t i = 0; i < scene.shapes.size() && faces_.size() <= most_passive_faces; ++i)
      if (!has_role(scene.shapes[i])) add(i);
  }

  // A sweep along an axis: what begins before a face ends is compared with it.
  std::vector<Overlap> found() && {
    if (faces_.size() > most_passive_faces) return {};
    const int axis = longest_axis();
    std::ranges::sort(faces_, {}, [axis](const PlacedFace& face) { return face.extent.low[axis]; });
    std::size_t pairs = 0;
    for (auto a = faces_.begin(); a != faces_.end(); ++a)
      for (auto b = a + 1; b != faces_.end(); ++b) {
        if (b->extent.low[axis] > a->extent.high[axis] + rounding_) break;
        if (++pairs > most_pairs) return std::move(found_);
        if (is_doubtful(*a, *b))
          note(found_, {std::max(a->shape, b->shape), std::min(a->shape, b->shape)});
      }
    return std::move(found_);
  }

 private:
  void add(std::size_t shape) {
    const std::size_t before = faces_.size();
    for_each_face(scene_.shapes[shape].kind, [&](const Face& face) {
      const Sheet* sheet = std::get_if<Sheet>(&face);
      if ((sheet == nullptr || sheet->has_area()) && faces_.size() <= most_passive_faces)
        faces_.push_back({face, extent_of(face), shape});
    });
    if (faces_.size() == before + 1) faces_.back().is_alone = true;
  }
  int longest_axis() const {
    Extent all;
    for (const PlacedFace& face : faces_) all.include(face.extent);
    const Point size = all.high - all.low;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }
  bool is_doubtful(const PlacedFace& a, const PlacedFace& b) const {
    return a.extent.meets(b.extent, rounding_) && overlap(a.face, b.face, rounding_) &&
           light_may_reach_both(a, b);
  }
  // Not where a body of which nothing is seen through touches another, as a box does its floor.
  bool light_may_reach_both(const PlacedFace& a, const PlacedFace& b) const {
    if ((a.is_alone && b.is_alone) || lets_light_through(scene_, scene_.shapes[a.shape]) ||
        lets_light_through(scene_, scene_.shapes[b.shape]))
      return true;
    const Sheet *one = std::get_if<Sheet>(&a.face), *other = std::get_if<Sheet>(&b.face);
    return one == nullptr || other == nullptr || glm::dot(one->normal(), other->normal()) > 0;
  }

  const description::Scene& scene_;
  double rounding_ = 0;
  std::vector<PlacedFace> faces_;
  std::vector<Overlap> found_;
};

}  // namespace

Overlaps overlaps_of(const description::Scene& scene, double rounding) {
  return {OfRoles(scene, rounding).found(), OfPassive(scene, rounding).found()};
}

}  // namespace wander

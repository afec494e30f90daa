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

constexpr std::size_t most_pairs = 10'000'000, most_named = 100;
// Of faces that are neither lights nor sensors: in a sweep, most are far apart.
constexpr std::size_t most_passive_faces = 50'000, most_passive_pairs = 40'000'000;

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

bool has_area(const Face& face) {
  const Sheet* sheet = std::get_if<Sheet>(&face);
  return sheet == nullptr || sheet->has_area();
}

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
        if (!has_area(face)) return;
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
    if (!has_area(face)) return;
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

// A body is a shape that is not flat.
class OfPassive {
 public:
  OfPassive(const description::Scene& scene, double rounding) : scene_(scene), rounding_(rounding) {
    for (const description::Shape& shape : scene.shapes) {
      Extent& extent = extents_.emplace_back();
      for_each_face(shape.kind, [&](const Face& face) { extent.include(extent_of(face)); });
      all_.include(extent);
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
      if (has_role(scene.shapes[i])) ends_.push_back(extents_[i]);
    if (scene.camera) {
      all_.include(position_of(*scene.camera));
      ends_.emplace_back().include(position_of(*scene.camera));
    }
    for (const Extent& end : ends_) all_ends_.include(end);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
      is_dark_within_.push_back(!lets_light_through(scene, scene.shapes[i]) &&
                                !holds_an_end(extents_[i]));
  }

  std::vector<Overlap> found() && {
    std::vector<PlacedFace> sheets, all;
    std::size_t faces = 0;
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
      if (has_role(scene_.shapes[i])) continue;
      const std::vector<PlacedFace> own = faces_of(i);
      faces += own.size();
      if (own.size() == 1) sheets.push_back(own.front());
      if (faces <= most_passive_faces) all.insert(all.end(), own.begin(), own.end());
    }
    sweep(std::move(sheets));
    if (faces <= most_passive_faces) sweep(std::move(all));
    return std::move(found_);
  }

 private:
  static Point position_of(const description::Camera& camera) {
    return {camera.position[0], camera.position[1], camera.position[2]};
  }
  // As far as one more than is looked at.
  std::vector<PlacedFace> faces_of(std::size_t shape) const {
    std::vector<PlacedFace> faces;
    for_each_face(scene_.shapes[shape].kind, [&](const Face& face) {
      if (has_area(face) && faces.size() <= most_passive_faces)
        faces.push_back({face, extent_of(face), shape});
    });
    return faces;
  }

  // Along an axis: what begins before a face ends is compared with it.
  void sweep(std::vector<PlacedFace> faces) {
    const Point size = all_.high - all_.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::ranges::sort(faces, {}, [axis](const PlacedFace& face) { return face.extent.low[axis]; });
    std::size_t pairs = 0;
    for (auto a = faces.begin(); a != faces.end(); ++a)
      for (auto b = a + 1; b != faces.end(); ++b) {
        if (b->extent.low[axis] > a->extent.high[axis] + rounding_) break;
        if (++pairs > most_passive_pairs || found_.size() == most_named) return;
        if (is_doubtful(*a, *b))
          note(found_, {std::max(a->shape, b->shape), std::min(a->shape, b->shape)});
      }
  }

  bool is_doubtful(const PlacedFace& a, const PlacedFace& b) const {
    if (!a.extent.meets(b.extent, rounding_) || !overlap(a.face, b.face, rounding_)) return false;
    const Sheet *one = std::get_if<Sheet>(&a.face), *other = std::get_if<Sheet>(&b.face);
    if (one == nullptr || other == nullptr) return true;
    // Of one mesh nobody knows which of its faces are a body.  The triangles of a sheet with two sides, or of a face that was folded
    // as it was split, look opposite ways and share an edge; so do those of bodies that share a face, but not of others that touch.
    if (a.shape == b.shape)
      return glm::dot(one->normal(), other->normal()) > 0 || share_an_edge(*one, *other);
    const Point normal = one->normal();
    return is_seen_from(normal, *one, a.shape, b.shape) ||
           is_seen_from(-normal, *one, a.shape, b.shape);
  }
  bool share_an_edge(const Sheet& a, const Sheet& b) const {
    const auto corners = [](const Sheet& s) {
      return std::array{s.corner, s.corner + s.edge0, s.corner + s.edge1};
    };
    const auto others = corners(b);
    const auto shared = std::ranges::count_if(corners(a), [&](Point p) {
      return std::ranges::any_of(others, [&](Point q) { return glm::length(p - q) <= rounding_; });
    });
    return shared >= 2;
  }

  // From the side of the plane to which the normal points: something is there, and neither shape
  // covers the other.
  bool is_seen_from(Point normal, const Sheet& plane, std::size_t a, std::size_t b) const {
    return highest(all_, normal, plane) > rounding_ && !covers(a, normal, plane) &&
           !covers(b, normal, plane);
  }
  // A body on that side of which nothing is seen through or from within, as a box on a floor.
  bool covers(std::size_t shape, Point normal, const Sheet& plane) const {
    const Extent& own = extents_[shape];
    return is_dark_within_[shape] && highest(own, normal, plane) > rounding_ &&
           highest(own, -normal, plane) <= rounding_;
  }
  // A light, a sensor or the camera; not said of more pairs than are looked at.
  bool holds_an_end(const Extent& body) {
    if (!body.meets(all_ends_, 0) || pairs_of_ends_ > most_passive_pairs) return false;
    pairs_of_ends_ += ends_.size();
    return std::ranges::any_of(ends_, [&](const Extent& end) { return end.meets(body, 0); });
  }
  static double highest(const Extent& extent, Point normal, const Sheet& plane) {
    double most = -Extent::infinity;
    for (int k = 0; k < 8; ++k) {
      const Point corner(k & 1 ? extent.high.x : extent.low.x, k & 2 ? extent.high.y : extent.low.y,
                         k & 4 ? extent.high.z : extent.low.z);
      most = std::max(most, glm::dot(corner - plane.corner, normal));
    }
    return most;
  }

  const description::Scene& scene_;
  double rounding_ = 0;
  std::vector<Extent> extents_;       // of the shapes
  std::vector<bool> is_dark_within_;  // likewise, as bodies
  Extent all_;                        // of them and the camera
  std::vector<Extent> ends_;          // of lights, sensors and the camera
  Extent all_ends_;
  std::size_t pairs_of_ends_ = 0;
  std::vector<Overlap> found_;
};

}  // namespace

Overlaps overlaps_of(const description::Scene& scene, double rounding) {
  return {OfRoles(scene, rounding).found(), OfPassive(scene, rounding).found()};
}

}  // namespace wander

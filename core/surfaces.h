// The surfaces of space as scene files name them.  A kind of shape offers
//   name                  in scene files
//   fields()              its keys
//   flaws()               what the schema cannot say against it
//   for_each_face(visit)  triangles, parallelograms and spheres that together are the surface: for
//                         doubts, not for rays
// and, beside the surfaces that rays meet, add_surfaces<World>(kind, role, add), which adds them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/geometry/triangles.h"
#include "core/shape_description.h"

namespace wander {

// Points of light are sampled on emitters.
enum class SurfaceRole { passive, emitter };

namespace description {

// So narrow that it has no normal.
bool is_narrow(const Coordinates& edge, const Coordinates& other);

// The normal is on the side from which the corners run counter-clockwise.
struct Triangle {
  static constexpr std::string_view name = "triangle";
  static constexpr auto fields() { return std::tuple(Field{"points", &Triangle::points}); }

  std::array<Coordinates, 3> points{};

  Flaws flaws() const;
  template <class Visitor>
  void for_each_face(Visitor&& visit) const {
    visit(*this);
  }
};

struct Parallelogram {
  static constexpr std::string_view name = "parallelogram";
  static constexpr auto fields() {
    return std::tuple(Field{"origin", &Parallelogram::origin},
                      Field{"edges", &Parallelogram::edges});
  }

  Coordinates origin{};
  std::array<Coordinates, 2> edges{};  // the normal is along edges[0] × edges[1]

  Flaws flaws() const;
  template <class Visitor>
  void for_each_face(Visitor&& visit) const {
    visit(*this);
  }
};

struct Sphere {
  static constexpr std::string_view name = "sphere";
  static constexpr auto fields() {
    return std::tuple(Field{"center", &Sphere::center}, Field{"radius", &Sphere::radius},
                      Field{"flip", &Sphere::flip});
  }

  Coordinates center{};
  double radius = 0;
  bool flip = false;

  Flaws flaws() const;
  template <class Visitor>
  void for_each_face(Visitor&& visit) const {
    visit(*this);
  }
};

// By which normals a mesh is shaded: those of its triangles, or those that the file gives corners.
enum class MeshNormals { flat, smooth };

struct Mesh {
  static constexpr std::string_view name = "mesh";
  static constexpr auto fields() {
    return std::tuple(Field{"file", &Mesh::file}, Field{"transform", &Mesh::transform},
                      Field{"normals", &Mesh::normals});
  }

  std::string file;                                // as the scene names it
  std::shared_ptr<const Triangles> triangles{};    // of the file, where the transform puts them
  std::vector<std::array<double, 4>> transform{};  // rows; none leave the file's as they are
  MeshNormals normals = MeshNormals::flat;

  Flaws flaws() const;
  template <class Visitor>
  void for_each_face(Visitor&& visit) const {
    const auto point = [&](std::int32_t i) {
      return triangles->points[static_cast<std::size_t>(i)];
    };
    for (const auto& [a, b, c] : triangles->corners)
      visit(Triangle{{point(a), point(b), point(c)}});
  }
};

}  // namespace description

}  // namespace wander

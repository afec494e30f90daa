#include "scenes/format/scene_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/mesh_text.h"
#include "scenes/format/scene_file_build.h"
#include "scenes/format/scene_textures.h"

namespace wander {

namespace {

using Point = glm::dvec3;

struct Transform {
  glm::dmat3 linear{1};
  Point offset{0};

  Point operator()(Point p) const { return linear * p + offset; }
  // Planes move by the inverse, transposed; of unit length, or 0.
  Point normal(Point n, const glm::dmat3& inverse) const {
    const Point moved = glm::transpose(inverse) * n;
    const double length = glm::length(moved);
    return length > 0 && std::isfinite(length) ? moved / length : Point(0);
  }
  bool mirrors() const { return glm::determinant(linear) < 0; }
};

// A mesh says rows; glm's matrices are columns.
Transform transform_of(const description::Mesh& mesh) {
  Transform transform;
  if (mesh.transform.empty()) return transform;
  for (int row = 0; row < 3; ++row) {
    const auto& numbers = mesh.transform[static_cast<std::size_t>(row)];
    for (int column = 0; column < 3; ++column)
      transform.linear[column][row] = numbers[static_cast<std::size_t>(column)];
    transform.offset[row] = numbers[3];
  }
  return transform;
}

// A mirror image is turned round, so that the outside stays outside.
Triangles moved(Triangles triangles, const Transform& transform) {
  for (auto& point : triangles.points) {
    const Point p = transform(Point(point[0], point[1], point[2]));
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(p[axis]) <= largest_coordinate))
        throw MeshFileError("the transform leads beyond 1e60, the largest coordinate");
      point[static_cast<std::size_t>(axis)] = p[axis] + 0.0;  // -0 is 0
    }
  }
  const glm::dmat3 inverse = glm::inverse(transform.linear);
  for (auto& normal : triangles.normals) {
    const Point n = transform.normal(Point(normal[0], normal[1], normal[2]), inverse);
    normal = {n.x, n.y, n.z};
  }
  if (transform.mirrors())
    for (auto* corners :
         {&triangles.corners, &triangles.normal_corners, &triangles.coordinate_corners})
      for (auto& three : *corners) std::swap(three[1], three[2]);
  return triangles;
}

MeshWants wants_of(const description::Mesh& mesh, JsonNode shape, const JsonDocument& document) {
  const auto material = document.find(shape, "material");
  const bool is_textured = material && has_texture(document, (*material)->get<std::string>());
  return {mesh.normals, is_textured ? MeshCoordinates::of_textures : MeshCoordinates::none};
}

}  // namespace

std::vector<JsonFault> SceneMeshes::read(const JsonDocument& document,
                                         const std::vector<JsonFault>& faults,
                                         const MeshReader& read_file) {
  std::vector<JsonFault> found;
  const auto shapes = document.find(document.root(), "shapes");
  if (!shapes || !(*shapes)->is_array() || faults.size() > json_limits.faults) return found;
  // A file may be named more than once.
  std::map<std::pair<std::string, MeshWants>, Triangles> files;
  for (const JsonMember& shape : document.children(*shapes)) {
    const auto file = document.find(shape.node, "file");
    const bool is_faulty = std::ranges::any_of(faults, [&](const JsonFault& fault) {
      return document.holds_byte(shape.node, fault.byte);
    });
    if (!file || is_faulty || found.size() > json_limits.faults) continue;
    const auto mesh = std::get<description::Mesh>(build_shape_kind(*shape.node.value));
    try {
      const auto name = std::pair(mesh.file, wants_of(mesh, shape.node, document));
      if (!files.contains(name)) files.emplace(name, read_file(mesh.file, name.second));
      files_.insert(mesh.file);
      const Triangles& triangles = files.at(name);
      if (mesh.normals == description::MeshNormals::smooth && triangles.normals.empty())
        found.push_back(document.fault(
            *document.find(shape.node, "normals"),
            fmt::format("{} has no normals; give its corners normals, or say \"flat\"",
                        excerpt(mesh.file))));
      else
        meshes_[shape.node.value] =
            std::make_shared<const Triangles>(moved(triangles, transform_of(mesh)));
    } catch (const MeshFileError& error) {
      found.push_back(
          document.fault(*file, fmt::format("{}: {}", excerpt(mesh.file), error.what())));
    }
  }
  return found;
}

}  // namespace wander

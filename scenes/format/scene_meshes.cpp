#include "scenes/format/scene_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"
#include "scenes/format/scene_file_build.h"

namespace wander {

namespace {

constexpr double largest_coordinate = 1e150;  // as in a scene

using Point = glm::dvec3;

struct Transform {
  glm::dmat3 linear{1};
  Point offset{0};

  Point operator()(Point p) const { return linear * p + offset; }
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
        throw MeshFileError("the transform leads beyond 1e150, the largest coordinate");
      point[static_cast<std::size_t>(axis)] = p[axis] + 0.0;  // -0 is 0
    }
  }
  if (transform.mirrors())
    for (auto& corners : triangles.corners) std::swap(corners[1], corners[2]);
  return triangles;
}

}  // namespace

std::vector<JsonFault> SceneMeshes::read(const JsonDocument& document,
                                         const std::vector<JsonFault>& faults,
                                         const MeshReader& read_file) {
  std::vector<JsonFault> found;
  const auto shapes = document.find(document.root(), "shapes");
  if (!shapes || !(*shapes)->is_array() || faults.size() > json_limits.faults) return found;
  std::map<std::string, Triangles> files;  // a file may be named more than once
  for (const JsonMember& shape : document.children(*shapes)) {
    const auto file = document.find(shape.node, "file");
    const bool is_faulty = std::ranges::any_of(faults, [&](const JsonFault& fault) {
      return document.holds_byte(shape.node, fault.byte);
    });
    if (!file || is_faulty || found.size() > json_limits.faults) continue;
    const auto mesh = std::get<description::Mesh>(build_shape_kind(*shape.node.value));
    try {
      if (!files.contains(mesh.file)) files.emplace(mesh.file, read_file(mesh.file));
      meshes_[shape.node.value] =
          std::make_shared<const Triangles>(moved(files.at(mesh.file), transform_of(mesh)));
    } catch (const MeshFileError& error) {
      found.push_back(
          document.fault(*file, fmt::format("{}: {}", excerpt(mesh.file), error.what())));
    }
  }
  return found;
}

}  // namespace wander

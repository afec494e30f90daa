#include "scenes/import/mesh_shading.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <utility>

#include "scenes/format/mesh_text.h"

namespace wander {

namespace {

using Vector = glm::dvec3;
using Corners = std::array<std::int32_t, 3>;

// Of the cosine between normals that are the same, but for the digits of a file.
constexpr double same = 1 - 1e-5;

Vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

// Nothing of a triangle without area.
std::optional<Vector> normal_of(const std::array<Vector, 3>& triangle) {
  const Vector n = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double length = glm::length(n);
  if (!(length > 0)) return {};
  return n / length;
}

std::array<Vector, 3> corners_of(const Triangles& mesh, std::size_t triangle) {
  const Corners& corners = mesh.corners[triangle];
  return {vector(mesh.points[at(corners[0])]), vector(mesh.points[at(corners[1])]),
          vector(mesh.points[at(corners[2])])};
}

double angle_at(const std::array<Vector, 3>& triangle, std::size_t corner) {
  const Vector a = triangle[(corner + 1) % 3] - triangle[corner],
               b = triangle[(corner + 2) % 3] - triangle[corner];
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The number after the first slash, 0 if there is none.
std::int32_t texture_index(std::string_view word) {
  std::int32_t number = 0;
  const std::size_t slash = word.find('/');
  if (slash != std::string_view::npos)
    std::from_chars(word.data() + slash + 1, word.data() + word.size(), number);
  return number;
}

// The lines have been understood once, so faces are as many as the mesh has, in their order.
std::vector<Corners> texture_corners(std::string_view text) {
  MeshText lines(text);
  Triangles fans;
  std::vector<std::int32_t> face;
  while (!lines.at_end()) {
    std::string_view line = lines.next_line();
    if (take_word(line) != "f") continue;
    face.clear();
    for (std::string_view word = take_word(line); !word.empty() && !word.starts_with('#');
         word = take_word(line))
      face.push_back(texture_index(word));
    add_fan(fans, face);
  }
  return fans.corners;
}

// A normal for each pair of a point and a number beside it.
std::vector<Corners> numbered(const std::vector<Corners>& points,
                              const std::vector<Corners>& beside) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> pairs;
  std::vector<Corners> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      result[i][k] = pairs
                         .emplace(std::pair(points[i][k], beside[i][k]),
                                  static_cast<std::int32_t>(pairs.size()))
                         .first->second;
  return result;
}

const std::vector<Corners>& normal_corners(const Triangles& mesh) {
  return mesh.normal_corners.empty() ? mesh.corners : mesh.normal_corners;
}

// Of the file, whose normals the transform moves by its inverse, transposed.
void add_normals(Triangles& mesh, const glm::dmat4& transform) {
  std::int32_t last = -1;
  for (const Corners& corners : normal_corners(mesh))
    last = std::max({last, corners[0], corners[1], corners[2]});
  std::vector<Vector> sums(static_cast<std::size_t>(last + 1), Vector(0));
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    std::array<Vector, 3> triangle = corners_of(mesh, i);
    for (Vector& corner : triangle) corner = Vector(transform * glm::dvec4(corner, 1));
    const auto normal = normal_of(triangle);
    if (!normal) continue;
    for (std::size_t k = 0; k < 3; ++k)
      sums[at(normal_corners(mesh)[i][k])] += angle_at(triangle, k) * *normal;
  }
  const glm::dmat3 back = glm::transpose(glm::dmat3(transform));
  mesh.normals.clear();
  for (const Vector& sum : sums) {
    const Vector moved = back * sum;
    const double length = glm::length(moved);
    const Vector unit = length > 0 ? moved / length : Vector(0);
    mesh.normals.push_back({unit.x, unit.y, unit.z});
  }
}

}  // namespace

MeshShading shading_of(const Triangles& mesh) {
  MeshShading result;
  double least = 1, most = -1, sum = 0;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const auto face = normal_of(corners_of(mesh, i));
    if (!face) continue;
    for (const std::int32_t index : normal_corners(mesh)[i]) {
      if (index < 0) continue;
      const Vector normal = vector(mesh.normals[at(index)]);
      const double length = glm::length(normal);
      if (!(length > 0)) continue;
      const double cosine = glm::dot(*face, normal) / length;
      least = std::min(least, cosine);
      most = std::max(most, cosine);
      sum += cosine;
    }
  }
  if (sum < 0) result.front = MeshShading::Front::inside;
  if (least < same && most > -same) result.normals = MeshShading::Normals::smooth;
  return result;
}

Triangles with_computed_normals(Triangles mesh, const glm::dmat4& transform,
                                std::string_view obj_text) {
  mesh.normal_corners = numbered(mesh.corners, texture_corners(obj_text));
  add_normals(mesh, transform);
  return mesh;
}

Triangles with_computed_normals(Triangles mesh, const glm::dmat4& transform) {
  mesh.normal_corners.clear();
  add_normals(mesh, transform);
  return mesh;
}

}  // namespace wander

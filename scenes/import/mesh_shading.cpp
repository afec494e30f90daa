#include "scenes/import/mesh_shading.h"

#include <charconv>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

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
std::optional<Vector> face_normal(const Triangles& mesh, const Corners& corners) {
  const Vector a = vector(mesh.points[at(corners[0])]);
  const Vector n =
      glm::cross(vector(mesh.points[at(corners[1])]) - a, vector(mesh.points[at(corners[2])]) - a);
  const double length = glm::length(n);
  if (!(length > 0)) return {};
  return n / length;
}

MeshShading shading(const Triangles& mesh, const std::vector<std::array<double, 3>>& normals,
                    const std::vector<Corners>& normal_corners) {
  MeshShading result;
  result.is_of_file = true;
  double least = 1, most = -1, sum = 0;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const auto face = face_normal(mesh, mesh.corners[i]);
    if (!face) continue;
    for (const std::int32_t index : normal_corners[i]) {
      if (index < 0 || at(index) >= normals.size()) continue;
      const Vector normal = vector(normals[at(index)]);
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

// Mitsuba averages the normals of triangles at each point.
MeshShading computed_shading(const Triangles& mesh) {
  MeshShading result;
  std::vector<Vector> of_point(mesh.points.size(), Vector(0));
  for (const Corners& corners : mesh.corners) {
    const auto face = face_normal(mesh, corners);
    if (!face) continue;
    for (const std::int32_t corner : corners) {
      Vector& known = of_point[at(corner)];
      if (known == Vector(0)) known = *face;
      if (glm::dot(known, *face) < same) result.normals = MeshShading::Normals::smooth;
    }
  }
  return result;
}

// The number after the second slash, counted from 1 or back from the last.
std::int32_t normal_index(std::string_view word, std::size_t known) {
  const std::size_t first = word.find('/');
  const std::size_t second = first == std::string_view::npos ? first : word.find('/', first + 1);
  if (second == std::string_view::npos) return -1;
  std::int32_t number = 0;
  std::from_chars(word.data() + second + 1, word.data() + word.size(), number);
  return number < 0 ? static_cast<std::int32_t>(known) + number : number - 1;
}

std::array<double, 3> numbers_of(std::string_view line) {
  std::array<double, 3> result{};
  for (double& x : result) {
    const std::string_view word = take_word(line);
    std::from_chars(word.data(), word.data() + word.size(), x);
  }
  return result;
}

}  // namespace

// The lines have been understood once, so faces are as many as the mesh has, in their order.
MeshShading shading_of_obj(const Triangles& mesh, std::string_view text) {
  MeshText lines(text);
  std::vector<std::array<double, 3>> normals;
  Triangles fans;
  std::vector<std::int32_t> face;
  while (!lines.at_end()) {
    std::string_view line = lines.next_line();
    const std::string_view keyword = take_word(line);
    if (keyword == "vn") normals.push_back(numbers_of(line));
    if (keyword != "f") continue;
    face.clear();
    for (std::string_view word = take_word(line); !word.empty() && !word.starts_with('#');
         word = take_word(line))
      face.push_back(normal_index(word, normals.size()));
    add_fan(fans, face);
  }
  return normals.empty() ? computed_shading(mesh) : shading(mesh, normals, fans.corners);
}

MeshShading shading_of_ply(const Triangles& mesh,
                           const std::vector<std::array<double, 3>>& normals) {
  return normals.empty() ? computed_shading(mesh) : shading(mesh, normals, mesh.corners);
}

}  // namespace wander

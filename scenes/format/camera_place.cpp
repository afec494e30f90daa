#include "scenes/format/camera_place.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "scenes/format/lint_bounds.h"
#include "scenes/format/measured_face.h"
#include "scenes/format/scene_file_pieces.h"

namespace wander {

namespace {

double distance(const Ball& ball, glm::dvec3 point) {
  return std::abs(glm::length(point - ball.center) - ball.radius);
}
// From its plane, and infinite beside it.
double distance(const Sheet& sheet, glm::dvec3 point) {
  if (!sheet.has_area() || !sheet.reaches(point)) return std::numeric_limits<double>::infinity();
  return std::abs(glm::dot(point - sheet.corner, sheet.normal()));
}

std::optional<std::size_t> below_in_plane(const description::Scene& scene) {
  const Pieces parts = pieces_of(scene);
  const auto& p = scene.camera->position;
  const glm::dvec2 point = (glm::dvec2(p[0], p[1]) - parts.middle) / parts.diameter;
  const double rounding = rounding_of_points(1, parts.remoteness);
  const auto found = std::ranges::find_if(
      parts.pieces, [&](const Piece& piece) { return piece.distance(point) <= rounding; });
  if (found == parts.pieces.end()) return std::nullopt;
  return found->shape;
}

std::optional<std::size_t> below_in_space(const description::Scene& scene) {
  const auto& p = scene.camera->position;
  const glm::dvec3 point(p[0], p[1], p[2]);
  Extent all;
  for (const description::Shape& shape : scene.shapes)
    for_each_face(shape.kind, [&](const Face& face) { all.include(extent_of(face)); });
  const double rounding = rounding_of_points(all.diameter(), all.remoteness());
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    bool is_below = false;
    for_each_face(scene.shapes[i].kind, [&](const Face& face) {
      is_below = is_below ||
                 std::visit([&](const auto& f) { return distance(f, point); }, face) <= rounding;
    });
    if (is_below) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> shape_below_camera(const description::Scene& scene) {
  if (!scene.camera || scene.shapes.empty()) return std::nullopt;
  return scene.dimension == 3 ? below_in_space(scene) : below_in_plane(scene);
}

}  // namespace wander

#include "core/surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace wander::description {

namespace {

// As a share of the longer side.
constexpr double least_breadth = 1e-14;

glm::dvec3 vector(const Coordinates& c) { return {c[0], c[1], c[2]}; }

Coordinates difference(const Coordinates& a, const Coordinates& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

}  // namespace

bool is_narrow(const Coordinates& edge, const Coordinates& other) {
  const glm::dvec3 a = vector(edge), b = vector(other);
  const auto largest = glm::max(glm::abs(a), glm::abs(b));
  const double size = std::max({largest.x, largest.y, largest.z});
  return glm::length(glm::cross(a / size, b / size)) < least_breadth;
}

Flaws Triangle::flaws() const {
  const auto& [a, b, c] = points;
  if (a == b || b == c || c == a)
    return {
        {"points", "this repeats a corner; a triangle has three different ones", a == b ? 1u : 2u}};
  if (too_near(a, b) || too_near(b, c) || too_near(c, a)) return {{"points", too_short}};
  if (is_narrow(difference(b, a), difference(c, a)))
    return {{"points", "the corners lie on a line; a triangle has an area > 0"}};
  return {};
}

Flaws Parallelogram::flaws() const {
  const Coordinates zero{};
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (too_near(edges[i], zero))
      return {{"edges",
               edges[i] == zero ? "this edge has no length; a parallelogram has an area > 0"
                                : too_short,
               i}};
  if (is_narrow(edges[0], edges[1]))
    return {{"edges", "the edges are parallel; a parallelogram has an area > 0"}};
  return {};
}

Flaws Sphere::flaws() const { return flaws_of_radius(radius); }

Flaws Mesh::flaws() const {
  if (transform.empty()) return {};
  Flaws found;
  if (transform.size() == 4 && transform[3] != std::array<double, 4>{0, 0, 0, 1})
    found.push_back({"transform", "a fourth row is 0, 0, 0, 1: a transform is affine", 3});
  glm::dmat3 linear;
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      linear[column][row] =
          transform[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      largest = std::max(largest, std::abs(linear[column][row]));
    }
  if (!(largest > 0) || glm::determinant(linear / largest) == 0)
    found.push_back(
        {"transform", "the transform flattens the mesh; its first three columns are independent"});
  return found;
}

}  // namespace wander::description

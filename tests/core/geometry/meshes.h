// Closed meshes for tests: balls of longitudes and latitudes, smooth or rough, and boxes.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "core/geometry/mesh.h"
#include "tests/support/generator.h"

namespace wander::test {

// Star-shaped about its centre; radii vary by this share.  Convex when they do not.
inline Triangles ball_mesh(Generator& g, int rows, double roughness, Spaceland::Point center = {},
                           double scale = 1) {
  Triangles mesh;
  const int columns = 2 * rows;
  const auto add = [&](double x, double y, double z) {
    const double r = scale * (1 + roughness * (2 * g.uniform() - 1));
    mesh.points.push_back({center.x + r * x, center.y + r * y, center.z + r * z});
  };
  add(0, 0, 1);
  for (int row = 1; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double theta = std::numbers::pi * row / rows,
                   phi = 2 * std::numbers::pi * column / columns;
      add(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  add(0, 0, -1);
  const auto at = [&](int row, int column) { return 1 + (row - 1) * columns + column % columns; };
  const int last = static_cast<int>(mesh.points.size()) - 1;
  for (int k = 0; k < columns; ++k) {
    mesh.corners.push_back({0, at(1, k), at(1, k + 1)});
    for (int row = 1; row + 1 < rows; ++row) {
      mesh.corners.push_back({at(row, k), at(row + 1, k), at(row + 1, k + 1)});
      mesh.corners.push_back({at(row, k), at(row + 1, k + 1), at(row, k + 1)});
    }
    mesh.corners.push_back({at(rows - 1, k), last, at(rows - 1, k + 1)});
  }
  return mesh;
}

inline Triangles box_mesh(Spaceland::Point low, Spaceland::Point high) {
  Triangles mesh;
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  mesh.corners = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline Spaceland::Point corner_of(const Triangles& mesh, std::int32_t triangle, std::size_t k) {
  const auto index = static_cast<std::size_t>(mesh.corners[static_cast<std::size_t>(triangle)][k]);
  const auto& p = mesh.points[index];
  return {p[0], p[1], p[2]};
}

}  // namespace wander::test

#include "scenes/import/unit_meshes.h"

#include <cmath>
#include <numbers>

namespace wander {

namespace {

constexpr double pi = std::numbers::pi;
using Corner = std::array<double, 3>;

Corner on_circle(int i, double radius, double z) {
  const double angle = 2 * pi * i / sides_of_round;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

double area_of(const Triangles& mesh) {
  double area = 0;
  for (const auto& corners : mesh.corners) {
    const auto& a = mesh.points[static_cast<std::size_t>(corners[0])];
    const auto& b = mesh.points[static_cast<std::size_t>(corners[1])];
    const auto& c = mesh.points[static_cast<std::size_t>(corners[2])];
    const Corner u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    area += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]) /
            2;
  }
  return area;
}

}  // namespace

Triangles unit_cube() {
  Triangles cube;
  for (int i = 0; i < 8; ++i)
    cube.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  cube.corners = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return cube;
}

Triangles unit_disk() {
  const double turn = 2 * pi / sides_of_round;
  const double radius = std::sqrt(turn / std::sin(turn));
  Triangles disk;
  disk.points.push_back({0, 0, 0});
  for (int i = 0; i < sides_of_round; ++i) disk.points.push_back(on_circle(i, radius, 0));
  for (int i = 0; i < sides_of_round; ++i)
    disk.corners.push_back({0, 1 + i, 1 + (i + 1) % sides_of_round});
  return disk;
}

Triangles unit_cylinder() {
  const double half = pi / sides_of_round;
  const double radius = half / std::sin(half);
  Triangles cylinder;
  for (int i = 0; i < sides_of_round; ++i)
    for (const double z : {0.0, 1.0}) cylinder.points.push_back(on_circle(i, radius, z));
  for (int i = 0; i < sides_of_round; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % sides_of_round);
    cylinder.corners.push_back({a, b, b + 1});
    cylinder.corners.push_back({a, b + 1, a + 1});
  }
  return cylinder;
}

Triangles unit_sphere() {
  constexpr int rings = sides_of_round / 2;
  Triangles sphere;
  sphere.points.push_back({0, 0, 1});
  for (int ring = 1; ring < rings; ++ring) {
    const double angle = pi * ring / rings;
    for (int i = 0; i < sides_of_round; ++i)
      sphere.points.push_back(on_circle(i, std::sin(angle), std::cos(angle)));
  }
  sphere.points.push_back({0, 0, -1});
  const auto at = [](int ring, int i) {
    return 1 + (ring - 1) * sides_of_round + i % sides_of_round;
  };
  const int last = static_cast<int>(sphere.points.size()) - 1;
  for (int i = 0; i < sides_of_round; ++i) {
    sphere.corners.push_back({0, at(1, i), at(1, i + 1)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      sphere.corners.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      sphere.corners.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
    sphere.corners.push_back({at(rings - 1, i + 1), at(rings - 1, i), last});
  }
  const double scale = std::sqrt(4 * pi / area_of(sphere));
  for (Corner& point : sphere.points)
    for (double& x : point) x *= scale;
  return sphere;
}

}  // namespace wander

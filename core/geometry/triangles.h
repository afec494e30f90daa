// Triangles that share corners, as plain data: 12 bytes a triangle, 24 a corner; and 24 a normal, 16 a
// pair of texture coordinates, where there are any.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace wander {

struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::int32_t, 3>> corners;  // counter-clockwise as seen from outside

  // For smooth shading, else empty; of unit length in a scene, and 0 for that of the triangle.
  std::vector<std::array<double, 3>> normals{};
  // Which of them the corners of a triangle have, -1 for that of the triangle; empty if normals are
  // numbered as points.
  std::vector<std::array<std::int32_t, 3>> normal_corners{};

  // Texture coordinates, u to the right and v up, for surfaces with a texture, else empty.
  std::vector<std::array<double, 2>> coordinates{};
  // Which of them the corners of a triangle have; empty if they are numbered as points.
  std::vector<std::array<std::int32_t, 3>> coordinate_corners{};
};

}  // namespace wander

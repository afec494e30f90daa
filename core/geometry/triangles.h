// Triangles that share corners, as plain data: 12 bytes a triangle, 24 a corner.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace wander {

struct Triangles {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::int32_t, 3>> corners;  // counter-clockwise as seen from outside
};

}  // namespace wander

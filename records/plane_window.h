// The part of the plane that a picture shows, in metres.
#pragma once

#include <array>

namespace wander {

struct PlaneWindow {
  std::array<double, 2> low{}, high{};  // lower left and upper right corner
};

}  // namespace wander

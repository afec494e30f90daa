// What lint finds and how it says so, in the plane and in space alike.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace wander {

// In units of the scene's diameter.
constexpr double smallest_feature = 1e-12;
constexpr double most_remote = 1e6;

constexpr std::size_t most_findings = 100;

// Of a point computed from coordinates of a scene of this diameter, whose largest is so many diameters.
constexpr double rounding_of_points(double diameter, double remoteness) {
  return 32 * std::numeric_limits<double>::epsilon() * diameter * (1 + remoteness);
}

// Of a light, or else a sensor, on the surface of this shape.
std::string light_or_sensor_lies_on(bool is_light, std::size_t shape);

}  // namespace wander

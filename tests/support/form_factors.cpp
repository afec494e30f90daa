#include "tests/support/form_factors.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/quadrature.h"

namespace wander::test {

double polygon_irradiance(SpacePoint at, SpacePoint normal,
                          const std::vector<SpacePoint>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const SpacePoint a = glm::normalize(corners[i] - at),
                     b = glm::normalize(corners[(i + 1) % corners.size()] - at);
    const SpacePoint across = glm::cross(a, b);
    const double sine = glm::length(across);
    sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across / sine, normal);
  }
  return 0.5 * std::abs(sum);
}

double ball_irradiance(SpacePoint at, SpacePoint normal, SpacePoint center, double radius) {
  const SpacePoint towards = center - at;
  const double distance = glm::length(towards);
  return std::numbers::pi * radius * radius / (distance * distance) *
         glm::dot(towards / distance, normal);
}

std::vector<double> pixel_means(int columns, int rows,
                                const std::function<double(double, double)>& function) {
  const auto at = [&](const std::array<double, 2>& u) { return function(u[0], u[1]); };
  std::vector<double> means;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double left = static_cast<double>(column) / columns,
                   first = static_cast<double>(row) / rows;
      const Box<2> pixel{{left, first}, {left + 1.0 / columns, first + 1.0 / rows}};
      means.push_back(integral<2>(at, pixel, {.absolute = 1e-9, .depth = 8}) / pixel.measure());
    }
  return means;
}

}  // namespace wander::test

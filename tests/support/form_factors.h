// Direct light in space, point by point, in closed form.
//
//   a polygon [Lambert 1760]  E = Le/2 |Σ β_i n·γ_i|, β_i the angle that edge i is seen under, γ_i
//                             the unit normal of the plane through it and the point
//   a ball                    E = π Le (r/d)² cos θ
// Both lie wholly in front of the receiver, and nothing stands in the way.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

namespace wander::test {

using SpacePoint = glm::dvec3;

// At a point that listens to the side of the unit vector `normal`, of light of radiance 1.
double polygon_irradiance(SpacePoint at, SpacePoint normal, const std::vector<SpacePoint>& corners);
double ball_irradiance(SpacePoint at, SpacePoint normal, SpacePoint center, double radius);

// The means of a smooth function of two film coordinates over the columns × rows pixels of a film.
// The first coordinate runs along a row; rows follow each other.
std::vector<double> pixel_means(int columns, int rows,
                                const std::function<double(double, double)>& function);

}  // namespace wander::test

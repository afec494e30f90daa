#include "tests/precision/sweep.h"
#include "tests/support/space_maker.h"

namespace wander::test {
namespace {

using Coordinates = description::Coordinates;

SpaceMaker::Role sensor(std::size_t wall) { return {wall, {}, {2, 2}}; }
SpaceMaker::Role lamp(std::size_t wall, double radiance) {
  return {wall, SpaceMaker::grey(radiance)};
}
std::size_t plaster(SpaceMaker& maker, double reflectance) {
  return maker.diffuse(SpaceMaker::grey(reflectance));
}

// A room with six walls at odd angles, of about a unit cube, whose floor is the sensor and whose
// ceiling shines; its back wall is of this material.  Normals look inwards.
void room(SpaceMaker& maker, std::size_t wall, std::size_t back, Coordinates at = {}) {
  const auto place = [&](double x, double y, double z) {
    return Coordinates{at[0] + x, at[1] + y, at[2] + z};
  };
  maker.parallelogram(place(0, 0, 0), {1, 0.05, 0}, {0, 1, 0.02}, sensor(wall));
  maker.parallelogram(place(0.02, 0, 0.95), {0, 1, 0.03}, {1, 0.04, 0}, lamp(wall, 1));
  maker.parallelogram(place(0, 0, 0), {0, 1, 0.02}, {0.02, 0, 0.95}, {wall});
  maker.parallelogram(place(1, 0.05, 0), {0.02, 0, 0.95}, {0, 1, 0.02}, {wall});
  maker.parallelogram(place(0, 0, 0), {0.02, 0, 0.95}, {1, 0.05, 0}, {wall});
  maker.parallelogram(place(0, 1, 0.02), {1, 0.05, 0}, {0.02, 0, 0.95}, {back});
}

description::Scene space_of_length(double setting) {
  SpaceMaker maker(static_cast<int>(setting));
  const std::size_t wall = plaster(maker, 0.7);
  room(maker, wall, wall);
  return maker.description();
}
description::Scene space_of_angle(double setting) {
  SpaceMaker maker(4);
  const std::size_t wall = plaster(maker, 0.7);
  maker.parallelogram({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, sensor(wall));
  maker.parallelogram({0, 0, setting}, {0, 1, 0}, {1, 0, 0.1 * setting}, lamp(wall, 1));
  return maker.description();
}
description::Scene space_of_roughness(double setting) {
  SpaceMaker maker(5);
  const std::size_t metal =
      maker.material(description::RoughConductor{setting, SpaceMaker::grey(0.9)});
  room(maker, plaster(maker, 0.6), metal);
  maker.sphere({0.5, 0.4, 0.4}, 0.2,
               {maker.material(description::RoughDielectric{setting, 1.5, 1})});
  return maker.description();
}
description::Scene space_of_distance(double setting) {
  SpaceMaker maker(4);
  const std::size_t wall = plaster(maker, 0.7);
  maker.parallelogram({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, sensor(wall));
  maker.parallelogram({1.2, 0, 0.1}, {0.1, 0, 0.8}, {0, 1, 0}, {wall});
  maker.parallelogram({0.1, 0, setting}, {0, 1, 0}, {1, 0, 0.01 * setting}, lamp(wall, 1));
  return maker.description();
}
description::Scene space_of_offset(double setting) {
  SpaceMaker maker(6);
  const std::size_t wall = plaster(maker, 0.7);
  room(maker, wall, wall, {setting, setting, setting});
  maker.sphere({setting + 0.5, setting + 0.4, setting + 0.4}, 0.2,
               {maker.material(description::RoughDielectric{0.2, 1.5, 1})});
  return maker.description();
}

}  // namespace

std::vector<Sweep> space_sweeps() {
  return {
      {"length", space_of_length, {2, 4, 8, 16, 32, 64, 128, 256}, PathsOf::greatest_length},
      {"angle", space_of_angle, {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
      {"roughness", space_of_roughness, {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
      {"distance", space_of_distance, {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12}},
      {"offset", space_of_offset, {1, 1e2, 1e4, 1e6, 1e8, 1e10}},
  };
}

}  // namespace wander::test

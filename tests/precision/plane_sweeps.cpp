#include "tests/precision/sweep.h"
#include "tests/support/core_scenes.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

// `setting` vertices in a room of diffuse walls.
description::Scene plane_of_length(double setting) {
  description::Scene scene = diffuse_room();
  scene.max_vertices = static_cast<int>(setting);
  return scene;
}
// Light and sensor face each other at so small a part of their length: cosines are as small.
description::Scene plane_of_angle(double setting) {
  SceneMaker maker(4);
  const std::size_t wall = maker.diffuse(0.7);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4});
  maker.segment({1, 1.1 * setting}, {0, setting}, {wall, 1});
  return maker.description();
}
// Metal and glass of this roughness.
description::Scene plane_of_roughness(double setting) {
  SceneMaker maker(5);
  const std::size_t wall = maker.diffuse(0.6);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4}).segment({1, 0}, {1.1, 0.9}, {wall, 1});
  maker.segment({1.1, 0.9}, {0, 1}, {maker.rough_metal(setting, 0.9)});
  maker.segment({0, 1}, {0, 0}, {wall});
  maker.circle({0.5, 0.4}, 0.15, {maker.rough_glass(setting, 1.5)});
  return maker.description();
}
// Light and sensor so many of their lengths apart, with a wall beside the sensor.
description::Scene plane_of_distance(double setting) {
  SceneMaker maker(4);
  const std::size_t wall = maker.diffuse(0.7);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4}).segment({1.2, 0.1}, {1.3, 0.9}, {wall});
  maker.segment({1.1, setting}, {0.1, setting * 1.01}, {wall, 1});
  return maker.description();
}
// A room so many of its diameters from the origin.
description::Scene plane_of_offset(double setting) {
  SceneMaker maker(6);
  const std::size_t plaster = maker.diffuse(0.7);
  const auto at = [&](double x, double y) { return PlanePoint{setting + x, setting + y}; };
  maker.segment(at(0, 0), at(1, 0.05), {plaster, 0, 4})
      .segment(at(1, 0.05), at(0.95, 1), {plaster});
  maker.segment(at(0.95, 1), at(0, 0.9), {plaster, 2}).segment(at(0, 0.9), at(0, 0), {plaster});
  maker.circle(at(0.5, 0.4), 0.15, {maker.rough_glass(0.2, 1.5)});
  return maker.description();
}

}  // namespace

std::vector<Sweep> plane_sweeps() {
  return {
      {"length", plane_of_length, {2, 4, 8, 16, 32, 64, 128, 256}, PathsOf::greatest_length},
      {"angle", plane_of_angle, {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}},
      {"roughness", plane_of_roughness, {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
      {"distance", plane_of_distance, {1, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12}},
      {"offset", plane_of_offset, {1, 1e2, 1e4, 1e6, 1e8, 1e10}},
  };
}

}  // namespace wander::test

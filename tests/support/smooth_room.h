// A room for the comparison of claimed densities with histograms of proposals: the paths are made
// by hand, each vertex from a wall and a position along it.
#pragma once

#include <gtest/gtest.h>

#include "core/transport.h"
#include "mlt/join.h"
#include "tests/support/test_scenes.h"

namespace wander::test {

// A closed room in which no light touches a sensor or another wall: densities are smooth.
inline description::Scene smooth_room() {
  description::Scene scene;
  scene.max_vertices = 4;
  scene.materials.push_back({"wall", description::Diffuse{{{0.7, 0.7, 0.7}, false}}});
  const std::array<description::Coordinates, 9> corners{
      {{0, 0}, {0.3, 0}, {0.8, 0}, {1, 0}, {1.1, 0.9}, {0.8, 0.95}, {0.4, 1.02}, {0, 1.1}, {0, 0}}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    description::Shape& wall = scene.shapes.emplace_back();
    wall.kind = description::Segment{corners[i], corners[i + 1]};
    wall.material = 0;
  }
  scene.shapes[1].sensor = description::Sensor{{4}};
  scene.shapes[5].light = description::Light{{{1, 1, 1}, false}};
  return scene;
}
inline constexpr ShapeId sensor_wall = 1, light_wall = 5, wall_count = 8;

// Paths of this room are chosen by hand: a vertex is a wall and a position along it.
class SmoothRoom : public ::testing::Test {
 protected:
  void put(Path<Flatland>& x, int i, ShapeId wall, double position) const {
    const int last = x.size() - 1;
    const auto point = std::get<Segment<Flatland>>(scene_->shape(wall)).sample({position});
    x[i].place = {.position = point.position, .normal = point.normal, .shape = wall};
    x[i].event = i == 0 ? Event::emission : i == last ? Event::detection : Event::scattering;
  }
  // Edges and measures.  False: no light gets through.
  bool complete(Path<Flatland>& x) const {
    for (int i = 0; i + 1 < x.size(); ++i)
      if (space_.connect(x, i) != Connection::open) return false;
    return evaluate(space_, x, 0, x.size() - 1) == Reason::none;
  }
  Path<Flatland> path(std::initializer_list<std::pair<ShapeId, double>> places) const {
    Path<Flatland> x(space_.max_vertices());
    x.resize(static_cast<int>(places.size()));
    int i = 0;
    for (const auto& [wall, position] : places) put(x, i++, wall, position);
    EXPECT_TRUE(complete(x));
    weigh(space_, x);
    return x;
  }
  double length(ShapeId wall) const {
    return std::get<Segment<Flatland>>(scene_->shape(wall)).measure();
  }
  double position(const Vertex<Flatland>& v) const {
    return std::get<Segment<Flatland>>(scene_->shape(v.place.shape)).parameter(v.place.position)[0];
  }

  FlatScene scene_ = build(smooth_room());
  Transport<Flatland> space_{*scene_, Roulette::off};
};

}  // namespace wander::test

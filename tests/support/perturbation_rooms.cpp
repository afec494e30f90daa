#include "tests/support/perturbation_rooms.h"

#include "tests/support/core_scenes.h"
#include "tests/support/test_scenes.h"

namespace wander::test {

namespace {

// What the middle of each wall is made for; the corners are plaster.
struct Walls {
  Role floor, right, ceiling, left;
};

void surround(SceneMaker& room, const Walls& walls, Role corner) {
  room.segment({0, 0}, {0.15, 0}, corner);
  room.segment({0.15, 0}, {0.9, 0}, walls.floor);
  room.segment({0.9, 0}, {1, 0}, corner);
  room.segment({1, 0}, {1.1, 0.9}, walls.right);
  room.segment({1.1, 0.9}, {0.75, 0.94}, corner);
  room.segment({0.75, 0.94}, {0.3, 1}, walls.ceiling);
  room.segment({0.3, 1}, {0, 1.05}, corner);
  room.segment({0, 1.05}, {0, 0.65}, corner);
  room.segment({0, 0.65}, {0, 0.1}, walls.left);
  room.segment({0, 0.1}, {0, 0}, corner);
}

// Glass below a line from wall to wall; its ends lie behind the walls.
void fill_with_glass(SceneMaker& room) {
  room.segment({-0.05, 0.37}, {1.1, 0.33}, {room.glass(1.5)});
}

}  // namespace

description::Scene sensor_in_glass() {
  SceneMaker room(5);
  const Role plaster{room.diffuse(0.6)}, bright{room.diffuse(0.8)};
  surround(room,
           {{plaster.material, 0, 12}, bright, {plaster.material, 1}, {room.rough_metal(0.3, 0.8)}},
           plaster);
  fill_with_glass(room);
  return room.description();
}

description::Scene lamp_in_glass() {
  SceneMaker room(5);
  const Role plaster{room.diffuse(0.6)}, bright{room.diffuse(0.8)};
  surround(room, {{plaster.material, 1}, bright, {plaster.material, 0, 12}, {room.mirror(0.9)}},
           plaster);
  fill_with_glass(room);
  return room.description();
}

description::Scene sensor_across_the_surface() {
  SceneMaker room(5);
  const Role plaster{room.diffuse(0.6)}, bright{room.diffuse(0.8)};
  surround(room, {bright, {plaster.material, 2}, {plaster.material, 1}, {plaster.material, 0, 12}},
           plaster);
  fill_with_glass(room);
  return room.description();
}

description::Scene curved_ends() {
  SceneMaker room(5);
  const Role plaster{room.diffuse(0.6)}, bright{room.diffuse(0.8)};
  surround(room, {bright, plaster, bright, {room.mirror(0.9)}}, plaster);
  room.arc({0.55, 0.8}, 0.2, 200, 330, {bright.material, 1});
  room.arc({0.5, 0}, 0.3, 25, 145, {plaster.material, 0, 12});
  return room.description();
}

description::Scene mirror_corridor() {
  SceneMaker room(7);
  const Role plaster{room.diffuse(0.7)}, mirror{room.mirror(0.9)};
  room.segment({0, 0}, {0.45, 0}, mirror);
  room.segment({0.45, 0}, {1, 0.02}, plaster);
  room.segment({1, 0.02}, {1, 0.42}, {plaster.material, 0, 12});
  room.segment({1, 0.42}, {0, 0.45}, mirror);
  room.segment({0, 0.45}, {0, 0.1}, {plaster.material, 1});
  room.segment({0, 0.1}, {0, 0}, plaster);
  return room.description();
}

description::Scene beads_of_two_glasses() {
  SceneMaker room(6);
  const Role plaster{room.diffuse(0.6)}, bright{room.diffuse(0.8)};
  surround(room, {{plaster.material, 0, 12}, bright, {plaster.material, 1}, bright}, plaster);
  const Role light_glass{room.glass(1.2)}, heavy_glass{room.glass(2.2)};
  room.circle({0.2, 0.5}, 0.1, light_glass);
  room.circle({0.41, 0.52}, 0.1, heavy_glass);
  room.circle({0.62, 0.5}, 0.1, light_glass);
  room.circle({0.83, 0.52}, 0.1, heavy_glass);
  return room.description();
}

std::vector<NamedRoom> perturbation_rooms() {
  return {{"SensorInGlass", sensor_in_glass},
          {"LampInGlass", lamp_in_glass},
          {"SensorAcrossTheSurface", sensor_across_the_surface},
          {"CurvedEnds", curved_ends},
          {"MirrorCorridor", mirror_corridor},
          {"BeadsOfTwoGlasses", beads_of_two_glasses},
          {"Diffuse", diffuse_room},
          {"MirrorAndGlass", mirror_and_glass},
          {"Rough", rough_room},
          {"ThinLens", thin_lens_room}};
}

}  // namespace wander::test

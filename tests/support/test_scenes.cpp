#include "tests/support/test_scenes.h"

#include <functional>

#include "scenes/format/build_scene.h"

namespace wander::test {

namespace {

namespace d = description;

d::Quantity grey(double value) { return {{value, value, value}, false}; }
d::Coordinates at(double x, double y) { return {x, y, 0}; }

// Collects the parts of a description; materials are named by their index.
struct Draft {
  d::Scene scene;

  explicit Draft(const char* name, int max_vertices) {
    scene.name = name;
    scene.max_vertices = max_vertices;
  }
  std::size_t material(d::MaterialKind kind) {
    scene.materials.push_back({"material " + std::to_string(scene.materials.size()), kind});
    return scene.materials.size() - 1;
  }
  std::size_t diffuse(double reflectance) { return material(d::Diffuse{grey(reflectance)}); }
  d::Shape& shape(d::ShapeKind kind, std::size_t material) {
    d::Shape& shape = scene.shapes.emplace_back();
    shape.kind = std::move(kind);
    shape.material = material;
    return shape;
  }
  // Normals lie on the left of a segment: walls run counter-clockwise around a room.
  d::Shape& wall(double ax, double ay, double bx, double by, std::size_t material) {
    return shape(d::Segment{at(ax, ay), at(bx, by)}, material);
  }
  void light(double ax, double ay, double bx, double by, std::size_t material, double radiance) {
    wall(ax, ay, bx, by, material).light = d::Light{grey(radiance)};
  }
  void sensor(double ax, double ay, double bx, double by, std::size_t material, int bins) {
    wall(ax, ay, bx, by, material).sensor = d::Sensor{{bins}};
  }
};

// Floor, right wall and ceiling with a light, around a sensor in the middle of the floor; the left
// wall is the caller's.
Draft open_room(const char* name, int max_vertices, std::size_t& left_material) {
  Draft room(name, max_vertices);
  const std::size_t dim = room.diffuse(0.3), bright = room.diffuse(0.8), middle = room.diffuse(0.5);
  room.wall(0, 0, 0.2, 0, dim);
  room.sensor(0.2, 0, 0.9, 0, dim, 12);
  room.wall(0.9, 0, 1, 0, dim);
  room.wall(1, 0, 1.1, 0.9, bright);
  room.wall(1.1, 0.9, 0.7, 0.95, middle);
  room.light(0.7, 0.95, 0.3, 1, middle, 1);
  room.wall(0.3, 1, 0, 1.05, middle);
  left_material = bright;
  return room;
}

}  // namespace

d::Scene diffuse_room() {
  std::size_t bright = 0;
  Draft room = open_room("diffuse room", 5, bright);
  room.wall(0, 1.05, 0, 0.6, bright);
  room.light(0, 0.6, 0, 0.5, bright, 3);
  room.wall(0, 0.5, 0, 0, bright);
  return room.scene;
}

d::Scene room_with_gap() {
  Draft room("room with a gap", 5);
  const std::size_t dim = room.diffuse(0.4), bright = room.diffuse(0.9);
  room.wall(0, 0, 0.7, 0, bright);
  room.wall(0.7, 0, 0.72, 0, dim);
  room.sensor(0.72, 0, 1.4, 0.05, dim, 10);
  room.wall(1.4, 0.05, 1.4, 1, bright);
  room.wall(1.4, 1, 0.6, 1.1, dim);
  room.wall(0.6, 1.1, 0, 1, bright);
  room.light(0, 1, 0, 0.3, dim, 2);
  room.wall(0, 0.3, 0, 0, dim);
  room.wall(0.7, 0, 0.66, 0.65, bright);  // between the two: its front faces the light
  return room.scene;
}

d::Scene mirror_and_glass() {
  std::size_t bright = 0;
  Draft room = open_room("mirror and glass", 6, bright);
  room.wall(0, 1.05, 0, 0.5, room.material(d::Mirror{grey(0.9)}));
  room.wall(0, 0.5, 0, 0, room.material(d::RoughConductor{0.3, grey(0.8)}));
  room.shape(d::Circle{at(0.55, 0.5), 0.17}, room.material(d::Dielectric{1.5, 1}));
  return room.scene;
}

d::Scene rough_room() {
  std::size_t bright = 0;
  Draft room = open_room("rough room", 5, bright);
  room.wall(0, 1.05, 0, 0, room.material(d::RoughConductor{0.4, grey(0.9)}));
  room.shape(d::Circle{at(0.6, 0.45), 0.15}, room.material(d::RoughDielectric{0.35, 1.5, 1}));
  room.shape(d::Arc{at(0.25, 0.5), 0.12, 20, 200},
             room.material(d::RoughConductor{0.2, grey(0.7)}));
  return room.scene;
}

d::Scene pinhole_room() {
  Draft room("room with a camera", 5);
  const std::size_t dim = room.diffuse(0.3), bright = room.diffuse(0.8);
  const std::size_t mirror = room.material(d::Mirror{grey(0.8)});
  room.wall(0, 0, 1, 0, dim);
  room.wall(1, 0, 1.1, 0.9, mirror);
  room.wall(1.1, 0.9, 0.7, 0.95, bright);
  room.light(0.7, 0.95, 0.3, 1, bright, 1);
  room.wall(0.3, 1, 0, 1.05, bright);
  room.wall(0, 1.05, 0, 0, bright);
  room.shape(d::Arc{at(0.7, 0.3), 0.12, -30, 150}, room.diffuse(0.6));
  d::Camera& camera = room.scene.camera.emplace();
  camera.position = at(0.15, 0.4);
  camera.target = at(0.9, 0.45);
  camera.fov_degrees = 75;
  camera.resolution = {12};
  return room.scene;
}

d::Scene thin_lens_room() {
  d::Scene scene = pinhole_room();
  scene.name = "room with a lens";
  scene.camera->aperture_radius = 0.05;
  return scene;
}

d::Scene dark_room() {
  std::size_t bright = 0;
  Draft room = open_room("dark room", 4, bright);
  room.wall(0, 1.05, 0, 0, bright);
  room.wall(-0.1, 0.7, 1.3, 0.7, bright);
  return room.scene;
}

d::Scene angular_room() {
  d::Scene scene = room_with_gap();
  scene.name = "angular room";
  Draft room("", 0);
  room.scene = std::move(scene);
  room.wall(0.5, 0.2, 0.3, 0.3, room.material(d::Mirror{grey(0.9)}));
  room.wall(1.1, 0.5, 1.0, 0.4, room.material(d::RoughConductor{0.3, grey(0.8)}));
  return room.scene;
}

std::vector<NamedScene> lit_scenes() {
  std::vector<NamedScene> scenes;
  for (const auto& make :
       {diffuse_room, room_with_gap, mirror_and_glass, rough_room, pinhole_room, thin_lens_room}) {
    d::Scene scene = make();
    std::string name = scene.name;
    scenes.push_back({std::move(name), std::move(scene)});
  }
  return scenes;
}

FlatScene build(const d::Scene& scene) { return build_flatland(scene); }

namespace {

// Applies `move` to every point.
d::Scene moved(d::Scene scene, const std::function<d::Coordinates(d::Coordinates)>& move) {
  for (d::Shape& shape : scene.shapes) {
    if (auto* s = std::get_if<d::Segment>(&shape.kind)) {
      s->from = move(s->from);
      s->to = move(s->to);
    }
    if (auto* s = std::get_if<d::Circle>(&shape.kind)) s->center = move(s->center);
    if (auto* s = std::get_if<d::Arc>(&shape.kind)) s->center = move(s->center);
  }
  if (scene.camera) {
    scene.camera->position = move(scene.camera->position);
    scene.camera->target = move(scene.camera->target);
  }
  return scene;
}

}  // namespace

d::Scene scaled(d::Scene scene, double factor) {
  scene = moved(std::move(scene),
                [factor](d::Coordinates c) { return at(factor * c[0], factor * c[1]); });
  for (d::Shape& shape : scene.shapes) {
    if (auto* s = std::get_if<d::Circle>(&shape.kind)) s->radius *= factor;
    if (auto* s = std::get_if<d::Arc>(&shape.kind)) s->radius *= factor;
  }
  if (scene.camera) scene.camera->aperture_radius *= factor;
  return scene;
}

d::Scene brightened(d::Scene scene, double factor) {
  for (d::Shape& shape : scene.shapes)
    if (shape.light)
      for (double& channel : shape.light->radiance.channels) channel *= factor;
  return scene;
}

d::Scene turned(d::Scene scene) {
  return moved(std::move(scene), [](d::Coordinates c) { return at(-c[1], c[0]); });
}

}  // namespace wander::test

// From a scene description to the walls of the radiosity solver.
#include <stdexcept>
#include <string>
#include <variant>

#include "core/description.h"
#include "core/exact/radiosity.h"

namespace wander::exact {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("radiosity_scene: " + what);
}

double grey(const description::Quantity& quantity) {
  if (quantity.coloured) refuse("colour is not supported");
  return quantity.channels[0];
}

double reflectance_of(const description::Material& material) {
  if (std::holds_alternative<description::Black>(material.kind)) return 0;
  if (const auto* diffuse = std::get_if<description::Diffuse>(&material.kind))
    return grey(diffuse->reflectance);
  refuse("material \"" + material.name + "\" is neither diffuse nor black");
}

// What the segments of a shape have in common; its line is still to be set.
Wall wall_of(const description::Scene& scene, const description::Shape& shape) {
  Wall wall;
  if (shape.material) wall.reflectance = reflectance_of(scene.materials.at(*shape.material));
  if (shape.light) wall.radiance = grey(shape.light->radiance);
  if (shape.sensor) wall.bins = static_cast<std::size_t>(shape.sensor->resolution.at(0));
  return wall;
}

PlanePoint point_of(const description::Coordinates& c) { return {c[0], c[1]}; }

void add_wall(RadiosityScene& scene, Wall wall, const description::Coordinates& from,
              const description::Coordinates& to) {
  wall.from = point_of(from);
  wall.to = point_of(to);
  scene.walls.push_back(wall);
}

void add_polyline(RadiosityScene& scene, const Wall& wall, const description::Polyline& line) {
  if (wall.bins > 0) refuse("a sensor on a polyline");
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    add_wall(scene, wall, line.points[i], line.points[i + 1]);
  if (line.closed) add_wall(scene, wall, line.points.back(), line.points.front());
}

}  // namespace

RadiosityScene radiosity_scene(const description::Scene& scene) {
  if (scene.dimension != 2) refuse("the scene is not two-dimensional");
  if (scene.camera) refuse("a camera; the sensor must be a segment");
  RadiosityScene result{.walls = {}, .max_vertices = scene.max_vertices};
  for (const description::Shape& shape : scene.shapes) {
    const Wall wall = wall_of(scene, shape);
    if (const auto* segment = std::get_if<description::Segment>(&shape.kind))
      add_wall(result, wall, segment->from, segment->to);
    else if (const auto* polyline = std::get_if<description::Polyline>(&shape.kind))
      add_polyline(result, wall, *polyline);
    else
      refuse("a shape that is neither segment nor polyline");
  }
  return result;
}

}  // namespace wander::exact

// A closed box of Spaceland: plaster, a mirror, rough metal, a ball of glass and a lamp; the sensor
// is the floor, or a camera.  Of about the unit cube, so that the functions of a path that are made
// for Flatland's rooms serve here.
#pragma once

#include "core/scene.h"

namespace wander::test {

inline SceneParts<Spaceland> space_box() {
  using W = Spaceland;
  using Point = W::Point;
  using Sheet = Parallelogram<W>;
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.7}, Mirror<W>{0.9}, Dielectric<W>{1.5, 1},
                     RoughConductor<W>{0.35, 0.9}};
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  parts.parts.push_back({Sheet(o, x, y), 0, 0, true});  // normals look inwards
  parts.parts.push_back({Sheet(z, y, x), 0, 0, false});
  parts.parts.push_back({Sheet(o, y, z), 1, 0, false});
  parts.parts.push_back({Sheet(x, z, y), 0, 0, false});
  parts.parts.push_back({Sheet(o, z, x), 3, 0, false});
  parts.parts.push_back({Sheet(y, x, z), 0, 0, false});
  parts.parts.push_back({Sheet({0.25, 0.3, 0.9}, {0, 0.5, 0.02}, {0.5, 0, 0}), 0, 4, false});
  parts.parts.push_back(
      {Sphere<W>({0.55, 0.6, 0.45}, 0.25, Sphere<W>::Facing::outward), 2, 0, false});
  parts.resolution = {3, 2};
  parts.max_vertices = 5;
  return parts;
}

// Seen by a pinhole, or through a lens of this radius.
inline SceneParts<Spaceland> space_box_by_camera(double lens_radius) {
  using Point = Spaceland::Point;
  SceneParts<Spaceland> parts = space_box();
  parts.parts[0].is_sensor = false;
  const Point axis = glm::normalize(Point(0.1, 1, 0));
  parts.camera = Camera<Spaceland>{.position = {0.5, 0.05, 0.5},
                                   .axis = axis,
                                   .across = {Point(axis.y, -axis.x, 0), Point(0, 0, -1)},
                                   .extent = {1.2, 0.9},
                                   .lens_radius = lens_radius,
                                   .focus_distance = 0.6};
  return parts;
}

}  // namespace wander::test

// The geometry of a scene in three dimensions as a table: one row per triangle, parallelogram or
// sphere, so that it can be drawn without the scene file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/description.h"

namespace wander {

struct SceneFaces {
  // What the numbers in `kind` mean.
  std::vector<std::string> kinds{"triangle", "parallelogram", "sphere"};

  std::vector<std::int32_t> shape;  // index among the shapes of the scene file
  std::vector<std::int32_t> kind, material;
  // [face][corner][xyz]: of a triangle all three; of a parallelogram the origin and the ends of its
  // edges there; of a sphere the centre, the others NaN.  Seen from the side of the normal they run
  // counter-clockwise.
  std::vector<double> corners;
  std::vector<double> radius;         // NaN but of a sphere
  std::vector<std::uint8_t> flipped;  // the normal of a sphere points to its centre
  std::vector<double> radiance;       // luminance, of a light; else 0
  std::vector<std::uint8_t> is_sensor;

  std::size_t size() const { return shape.size(); }
};

SceneFaces scene_faces(const description::Scene& scene);

}  // namespace wander

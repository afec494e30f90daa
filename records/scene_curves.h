// The geometry of a scene in two dimensions as a table: one row per segment or arc, so that it can
// be drawn without the scene file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/description.h"

namespace wander {

// What the numbers in `material` mean, of curves and of faces: types as scene files say them.
inline const std::vector<std::string> material_types{
    "black", "diffuse", "mirror", "dielectric", "rough_conductor", "rough_dielectric", "conductor"};
// Of a shape; without a material it is black.
std::int32_t material_number(const description::Scene& scene, const description::Shape& shape);

struct SceneCurves {
  // What the numbers in `kind` mean.
  std::vector<std::string> kinds{"segment", "arc"};

  std::vector<std::int32_t> shape;  // index among the shapes of the scene file
  std::vector<std::int32_t> kind, material;
  std::vector<double> from, to;  // [curve][xy]: ends of a segment, NaN for an arc
  std::vector<double> center;    // [curve][xy]: of an arc, NaN for a segment; so are the next three
  std::vector<double> radius;
  std::vector<double> from_degrees, to_degrees;  // counter-clockwise; equal ends are a full turn
  std::vector<std::uint8_t> flipped;             // the normal of an arc points to its centre
  std::vector<double> radiance;                  // of a light, else 0
  std::vector<std::uint8_t> is_sensor;

  std::size_t size() const { return shape.size(); }
};

SceneCurves scene_curves(const description::Scene& scene);

}  // namespace wander

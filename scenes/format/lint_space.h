// Doubts about the geometry of a valid scene of three dimensions; of meshes, what can be told of
// each triangle alone.
//
//   a flat light or sensor that lies on another flat shape
//   triangles of a mesh that have no area, which light never meets
//   features below 1e-12 of the diameter, and scenes beyond 1e6 diameters from the origin
#pragma once

#include <vector>

#include "core/description.h"
#include "scenes/format/scene_file_fault.h"

namespace wander {

std::vector<Fault> lint_space(const description::Scene& scene);

}  // namespace wander

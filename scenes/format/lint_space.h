// What lint looks for in a scene of three dimensions.
//
//   a light or sensor that lies on another shape, faces of meshes included: refused
//   other flat shapes that lie on each other: most are a box that stands on a floor
//   triangles of a mesh that have no area, which light never meets; a light of nothing else: refused
//   features below 1e-12 of the diameter, and scenes beyond 1e6 diameters from the origin
#pragma once

#include "scenes/format/lint.h"

namespace wander {

Lint lint_space(const description::Scene& scene);

}  // namespace wander

// What is looked for in the geometry of a scene whose every shape is sound: what no two methods would
// render alike, and what is allowed but rarely meant.
//
//   shapes that lie on each other          which of them light meets is left to rounding, and no two
//                                          methods round alike: refused, in space where one of them is
//                                          a light or sensor, else doubted
//   a camera that lies on a surface        what it sees there is left to rounding: refused
//   a light that faces another surface at almost no distance
//   ends that nearly meet                  light leaks through a gap below 1e-6 of the diameter
//   features below 1e-12 of the diameter, and scenes beyond 1e6 diameters from the origin
//
// Shapes are compared in pairs that a sweep finds: at most 2 million pairs whose boxes meet, and 32
// million others.  Of scenes with more only a part is compared, and a warning says so.  At most 100
// of each.  Of scenes of three dimensions less is doubted: lint_space.h.
#pragma once

#include <vector>

#include "core/description.h"
#include "scenes/format/scene_file_fault.h"

namespace wander {

struct Lint {
  std::vector<Fault> faults;    // the scene cannot be rendered
  std::vector<Fault> warnings;  // it can
};

Lint lint(const description::Scene& scene);

}  // namespace wander

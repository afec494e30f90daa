// Surfaces of space that lie on each other.  Light meets one of them, which one is left to rounding.
#pragma once

#include <cstddef>
#include <vector>

#include "core/description.h"

namespace wander {

struct Overlap {
  std::size_t shape = 0, other = 0;  // in the scene
};

struct Overlaps {
  std::vector<Overlap> of_roles;   // a light or sensor, and what it lies on
  std::vector<Overlap> of_sheets;  // two triangles or parallelograms that are neither
};

// Points nearer than `rounding` are the same.  Of lights and sensors every face is compared with every
// face of other shapes, and of the rest those shapes that are one flat face: as far as ten million
// pairs of either kind.  Each pair of shapes is named once, and no more than a thousand.
Overlaps overlaps_of(const description::Scene& scene, double rounding);

}  // namespace wander

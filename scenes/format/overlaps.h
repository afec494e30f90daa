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
  std::vector<Overlap> of_roles;    // a light or sensor, and what it lies on
  std::vector<Overlap> of_passive;  // two that are neither, or one in which triangles do
};

// Points nearer than `rounding` are the same.  Of lights and sensors every face is compared with every
// face of other shapes, as far as ten million pairs; of the rest those of one face with each other,
// and, where there are no more than fifty thousand, all faces: as far as forty million pairs that a
// sweep finds.  Pairs are left out that light does not reach, as the floor and the bottom of a box.
// Each pair of shapes is named once, and no more than a hundred.
Overlaps overlaps_of(const description::Scene& scene, double rounding);

}  // namespace wander

// Mitsuba's shapes of unit size as triangles, normals outwards.
//
// The cube is exact.  The others have as many sides as `sides_of_round` says, and the area of what
// they stand for, so that a lamp of that shape has its power.
#pragma once

#include "core/geometry/triangles.h"

namespace wander {

inline constexpr int sides_of_round = 128;

Triangles unit_cube();      // from -1 to 1
Triangles unit_disk();      // of radius 1 in the plane z = 0, normal along z
Triangles unit_cylinder();  // of radius 1 around z, from z = 0 to 1, without caps
Triangles unit_sphere();    // of radius 1

}  // namespace wander

// The paths of a trajectory in space as lines of an OBJ file, which Blender and other programs open:
// vertices `v x y z`, and of each path a line `l` through its vertices, from the light to the sensor.
//
// Objects: `start`, the states before the steps where those are known; `accepted` and `rejected`,
// what the steps proposed; `failed`, what there is of proposals that came to nothing.  A comment
// before each line says of which chain, step and mutation it is.
#pragma once

#include <string>

#include "draw/figure/steps.h"

namespace wander::figure {

std::string path_lines(const Steps& steps);

}  // namespace wander::figure

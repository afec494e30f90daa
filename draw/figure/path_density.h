// Where the chains were: the mean length of the visited paths in each cell of the plane, per area.
#pragma once

#include "core/description.h"
#include "draw/figure/block.h"
#include "draw/figure/plane_picture.h"
#include "draw/figure/steps.h"

namespace wander::figure {

// Σ |path ∩ cell| / (steps · |cell|), in 1/m, over the states after the steps.
std::vector<double> path_density(const Steps& steps, const PlaneGrid& grid);

Block density_picture(const Steps& steps, const description::Scene& scene, double width);

}  // namespace wander::figure

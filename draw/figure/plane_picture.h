// A quantity over the plane of a scene: tones, the outlines of the scene over them, axes in metres,
// and a legend of the tones.
#pragma once

#include <vector>

#include "core/description.h"
#include "core/geometry/plane_grid.h"
#include "draw/figure/axis.h"
#include "draw/figure/block.h"
#include "draw/figure/colour_map.h"

namespace wander::figure {

// What the outlines of the scene are drawn on.
enum class Ground { light, dark };

struct PlanePicture {
  description::Scene scene;
  PlaneGrid grid;
  std::vector<double> values;  // per cell of the grid
  Quantity quantity;
  const ColourMap& colours;
  Ground ground;
};

// The grid that covers a drawing of the scene.
PlaneGrid grid_over(const description::Scene& scene, int columns);

Block picture_block(PlanePicture picture, double width, double most_height);

}  // namespace wander::figure

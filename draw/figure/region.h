// The insides of dielectrics, found from their outlines: a lens made of two arcs, or a block made
// of four segments, is as much a region as a circle is.
#pragma once

#include <string>
#include <vector>

#include "core/description.h"
#include "draw/figure/curve.h"

namespace wander::figure {

struct Insides {
  std::vector<std::string> regions;  // closed path data, to be filled
  std::vector<Curve> open;           // curves that close no region
};

// Curves end to end, within a millionth of `scene_size`, with their backs on the same side, close a
// region when that side is within.
Insides find_insides(const std::vector<description::ShapeKind>& outlines, const PageMap& map,
                     double scene_size);

}  // namespace wander::figure

// The legend of a scene drawing: an entry for each kind of mark that occurs, and no other, with the
// numbers that matter ("dielectric, n 1.5").
#pragma once

#include <vector>

#include "core/description.h"
#include "draw/figure/legend.h"

namespace wander::figure {

std::vector<LegendEntry> legend_of(const description::Scene& scene);

}  // namespace wander::figure

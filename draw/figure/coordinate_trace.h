// Where the path of each chain meets the film, step by step: one panel for each chain, with a mark
// under every step that was rejected.  Of long trajectories a column shows the range of its steps,
// and the height of its mark the share that was rejected.
#pragma once

#include "draw/figure/block.h"
#include "draw/figure/steps.h"

namespace wander::figure {

// The first `most_chains` of the chains.
Block coordinate_trace(const Steps& steps, double width, int most_chains);

}  // namespace wander::figure

// What became of the proposals of each mutation: one bar for each, of the shares that were
// accepted, refused by the acceptance test, and that failed for each reason.  Shades and hatches
// differ, and the shares are written into the bar where they fit.
#pragma once

#include "draw/figure/block.h"
#include "draw/figure/steps.h"

namespace wander::figure {

Block acceptance_chart(const Steps& steps, double width);

}  // namespace wander::figure

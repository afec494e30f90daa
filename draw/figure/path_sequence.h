// Figure 3 of the article: a sequence of mutated paths over the scene, one small drawing for each
// step.  The current path is black; the proposal beside it is solid where it was accepted and
// dashed where it was rejected, and words say which mutation it was and what became of it.
#pragma once

#include "draw/figure/block.h"
#include "draw/figure/stage.h"
#include "draw/figure/steps.h"

namespace wander::figure {

// The first `most` of the steps; the heading says of how many.
Block path_sequence(const Steps& steps, const Stage& stage, double width, int most);

}  // namespace wander::figure

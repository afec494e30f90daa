// The normalization constant b = ∫ f, the mean of the film, and its share by path length: the
// direct mean of the seed pass, unbiased, with the standard error of independent samples.
#pragma once

#include "core/rendering.h"
#include "mlt/seed_pass.h"

namespace wander {

Normalization normalization(const SeedTally& tally);

}  // namespace wander

// A run whose film is an image, as a renderer might have made it.
#pragma once

#include "records/run_record.h"

namespace wander::test {

// Smooth tones with noise of the standard error that it states; `channels` is 1 or 3.  Images of
// equal size and different seeds agree.
RunRecord image_run(int width, int height, int channels, std::uint64_t seed = 1);

// The same with maps of a mutation per pixel, films by length and a normalization.
RunRecord chains_image_run(int width, int height, int channels);

}  // namespace wander::test

// The colours of a quantity over the plane, from nothing to most: perceptually even, so that equal
// steps of the scale look like equal steps, and legible without colour, for lightness only grows
// (or falls) along them; along those of a difference, from its middle.
#pragma once

#include <array>

#include "records/png.h"

namespace wander::figure {

using ColourMap = std::array<Rgb, 256>;

// Of light: from black over violet and orange to pale yellow.
const ColourMap& light_colours();
// Of ink: from paper to blue.
const ColourMap& ink_colours();
// Of a difference: from blue, what is below, over white, none, to red.
const ColourMap& difference_colours();

}  // namespace wander::figure

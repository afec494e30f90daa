// Colours of spectra that are given at wavelengths.
#pragma once

#include <utility>
#include <vector>

#include "scenes/import/colour.h"

namespace wander {

// Wavelengths in nanometres, growing, and values; linear in between and 0 outside.
using Spectrum = std::vector<std::pair<double, double>>;

// As the CIE's observer of 1931 sees it; what is reflected in the light of D65, so that a flat
// spectrum is grey.  What no screen can show is clipped.
Colour colour_of(const Spectrum& spectrum, Light light);

// What it is to emit as much at all wavelengths, of luminance one.
Colour equal_energy();

}  // namespace wander

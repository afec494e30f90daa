// A PNG image within a figure.
#pragma once

#include <string>

#include "draw/figure/svg.h"

namespace wander::figure {

void draw_image(Svg& svg, const std::string& png, Vector top_left, Vector size);

}  // namespace wander::figure

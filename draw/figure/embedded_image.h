// A PNG image within a figure.
#pragma once

#include <string>

#include "draw/figure/svg.h"

namespace wander::figure {

// Between its pixels: even steps of colour, or edges, where single pixels are to be told apart.
enum class Enlarged { smoothly, in_squares };

void draw_image(Svg& svg, const std::string& png, Vector top_left, Vector size, Enlarged enlarged);

}  // namespace wander::figure

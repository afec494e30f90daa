// A small drawing of a scene beside something else: no axes, a scale bar.
#pragma once

#include <string>

#include "core/description.h"
#include "draw/figure/svg.h"

namespace wander::figure {

// "5 mm", "0.2 m", "1 Gm"
std::string length_in_words(double metres);

// The height that a drawing of this width needs, scale bar included.
double inset_height(const description::Scene& scene, double width, double most_height);
void draw_inset(Svg& svg, const description::Scene& scene, Vector top_left, Vector size);

}  // namespace wander::figure

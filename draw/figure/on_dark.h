// Marks of a scene over a dark picture: the same marks as on paper, in light colours, with a dark
// rim that keeps them legible where the picture is bright.
#pragma once

#include <string_view>

#include "draw/figure/svg.h"

namespace wander::figure {

// What the ground of a picture is, and of its legend.
inline constexpr std::string_view dark_ground = "#16131c";

// Groups of these kinds show what is drawn into them in light colours, and as a dark rim.
inline constexpr std::string_view on_dark = "on-dark", dark_rim = "dark-rim";

// The rules that make them so, before the first such group.
void define_on_dark(Svg& svg);

}  // namespace wander::figure

// Marks at the points of a curve, told apart by their shape whatever their colour.
#pragma once

#include <cstddef>

#include "draw/figure/style.h"
#include "draw/figure/svg.h"

namespace wander::figure {

// How a series is drawn: the stroke of its line and the shape of its marks.
struct Look {
  style::Stroke stroke = style::films[0];
  std::size_t marker = 0;
};
// Of the k-th of several things; 56 differ.
Look look_of(std::size_t k);

// Shapes begin again after the last.
void draw_marker(Svg& svg, Vector at, const Look& look);
// Its outline alone.
void draw_open_marker(Svg& svg, Vector at, const Look& look);

}  // namespace wander::figure

// Fills that differ without colour: tiles of lines, dots and shapes at several angles and
// distances. What each means is in meanings.h.
#pragma once

#include <string>
#include <string_view>

#include "draw/figure/svg.h"

namespace wander::figure {

enum class Tile { plain, line, dash, cross, dot, ring, square, triangle, zigzag, plus };

struct Fill {
  Tile tile = Tile::plain;
  double spacing = 3, angle = 0;        // of the tiles; degrees, clockwise
  double weight = 0;                    // the width of a line, the radius of a dot
  std::string_view colour{}, ground{};  // no ground: what lies below is seen
};

// Such as "url(#fill-line-3-45-...)", or a colour where the fill is plain.  The pattern is written
// into the document at its first use.
std::string define_fill(Svg& svg, const Fill& fill);

}  // namespace wander::figure

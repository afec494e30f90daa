// A page of figures: blocks that know their height and draw themselves, one below the other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "draw/figure/svg.h"

namespace wander::figure {

struct Block {
  std::string heading;  // empty: none
  double height = 0;    // without the heading
  std::function<void(Svg& svg, Vector top_left)> draw;
};

// The title of a page in as many lines as it needs, given the middle of its upper edge; and the
// room that it takes with the gap below it.
double title_height(const std::string& title, double width);
void draw_title(Svg& svg, const std::string& title, Vector top, double width);

// The width that blocks on a page of this width have.
double block_width(double page_width);

// An SVG document.
std::string page(const std::string& title, const std::string& description, double page_width,
                 const std::vector<Block>& blocks);

}  // namespace wander::figure

// Fills that differ without colour: lines, dots and crosses at several angles and distances.
#pragma once

#include <string>

#include "tools/figure/svg.h"

namespace wander::figure {

// The fill of hatch k, such as "url(#hatch-3)"; written into the document at its first use.  Hatch
// 0 is that of rejected proposals; beyond the last they begin again with the second.
std::string define_hatch(Svg& svg, std::size_t k);

}  // namespace wander::figure

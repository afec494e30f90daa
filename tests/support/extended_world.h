// The yardstick that float and double are held against: the plane and space in extended precision;
// and space in float, which the program does not offer.  They can evaluate paths, but draw none.
#pragma once

#include "core/transport.h"

namespace wander::test {

using FlatlandExtended = Universe<2, long double>;
using SpacelandExtended = Universe<3, long double>;
using SpacelandSingle = Universe<3, float>;

}  // namespace wander::test

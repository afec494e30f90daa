// Flatland in extended precision: the yardstick that float and double are held against.  It can
// evaluate paths, but draws none; the program does not know it.
#pragma once

#include "core/transport.h"

namespace wander::test {

using FlatlandExtended = Universe<2, long double>;

}  // namespace wander::test

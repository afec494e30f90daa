// Flatland in extended precision: the yardstick that float and double are held against.  It can
// evaluate paths, but draws none; the program does not know it.
#pragma once

#include "core/transport.h"

namespace wander {

namespace test {
using FlatlandExtended = Universe<2, long double>;
}

// No processor has lanes for its lengths.
template <>
struct AcceleratorOf<test::FlatlandExtended, 2> {
  using Type = Bvh<test::FlatlandExtended>;
};

}  // namespace wander

// The worlds that are compiled in: the one list of them.
#pragma once

#include "core/world.h"

namespace wander {

template <World... Ws>
struct WorldList {};

using Worlds = WorldList<Flatland, FlatlandSingle, Spaceland, SpacelandColour>;

}  // namespace wander

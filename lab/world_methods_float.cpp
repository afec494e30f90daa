#include "lab/world_methods.h"

namespace wander {

template class WorldMethods<FlatlandSingle>;

}  // namespace wander

#include "lab/world_tracers.h"

namespace wander {

template class WorldTracers<FlatlandSingle>;

}  // namespace wander

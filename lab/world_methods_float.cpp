#include "lab/world_methods.h"

namespace wander {

template Rendering render_in<FlatlandSingle>(const Job&, const Session&);

}  // namespace wander

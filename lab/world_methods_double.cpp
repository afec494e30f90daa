#include "lab/world_methods.h"

namespace wander {

template Rendering render_in<Flatland>(const Job&, const Session&);

}  // namespace wander

#include "lab/world_methods.h"

namespace wander {

template Rendering carry_on_in<FlatlandSingle>(const KeptRun&, const Job&, const Session&,
                                               const Keeper&);
template Rendering merge_in<FlatlandSingle>(const Job&, std::span<const StoredRun>, const Session&);

}  // namespace wander

#include "lab/world_methods.h"

namespace wander {

template std::unique_ptr<LiveRun> PathChains::make(const Stage<FlatlandSingle>&);
template std::unique_ptr<LiveRun> PssmltChains::make(const Stage<FlatlandSingle>&);
template std::unique_ptr<LiveRun> MmltChains::make(const Stage<FlatlandSingle>&);
template Rendering carry_on_in<FlatlandSingle>(const KeptRun&, const Job&, const Session&,
                                               const Keeper&);
template Rendering merge_in<FlatlandSingle>(const Job&, std::span<const StoredRun>, const Session&);

}  // namespace wander

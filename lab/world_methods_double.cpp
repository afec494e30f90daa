#include "lab/world_methods.h"

namespace wander {

template std::unique_ptr<LiveRun> PathChains::make(const Stage<Flatland>&);
template std::unique_ptr<LiveRun> PssmltChains::make(const Stage<Flatland>&);
template std::unique_ptr<LiveRun> MmltChains::make(const Stage<Flatland>&);
template Rendering carry_on_in<Flatland>(const KeptRun&, const Job&, const Session&, const Keeper&);
template Rendering merge_in<Flatland>(const Job&, std::span<const StoredRun>, const Session&);

}  // namespace wander

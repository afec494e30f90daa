#include "lab/world_methods.h"

namespace wander {

template std::unique_ptr<LiveRun> PssmltMethod::make(const Stage<Spaceland>&);
template std::unique_ptr<LiveRun> MmltMethod::make(const Stage<Spaceland>&);
template std::unique_ptr<WorldRun> hold_in<Spaceland>(const KeptRun&, const Job&, const Session&);
template Rendering merge_in<Spaceland>(const Job&, std::span<const StoredRun>, const Session&);

}  // namespace wander

#include "lab/world_methods.h"

namespace wander {

template std::unique_ptr<LiveRun> PssmltMethod::make(const Stage<FlatlandSingle>&);
template std::unique_ptr<LiveRun> MmltMethod::make(const Stage<FlatlandSingle>&);
template std::unique_ptr<WorldRun> hold_in<FlatlandSingle>(const KeptRun&, const Job&,
                                                           const Session&);
template Rendering merge_in<FlatlandSingle>(const Job&, std::span<const StoredRun>, const Session&);

}  // namespace wander

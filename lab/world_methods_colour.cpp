#include "lab/world_methods.h"

namespace wander {

template std::unique_ptr<LiveRun> PssmltMethod::make(const Stage<SpacelandColour>&);
template std::unique_ptr<LiveRun> MmltMethod::make(const Stage<SpacelandColour>&);
template std::unique_ptr<WorldRun> hold_in<SpacelandColour>(const KeptRun&, const Job&,
                                                            const Session&);
template Rendering merge_in<SpacelandColour>(const Job&, std::span<const StoredRun>,
                                             const Session&);

}  // namespace wander

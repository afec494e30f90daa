// What an engine is made of, for any world.  Each function is made for each world in a file of its
// own (world_methods_float.cpp, world_methods_space.cpp, ...), for they take long to compile.
#pragma once

#include "core/world.h"
#include "lab/engine.h"

namespace wander {

// Defined in world_methods.h.
template <World W>
std::unique_ptr<WorldRun> hold_in(const KeptRun& from, const Job& job, const Session& session);
template <World W>
Rendering merge_in(const Job& job, std::span<const StoredRun> runs, const Session& session);

// Defined in world_tracers.h.
template <World W>
Trace trace_in(const Job& job, const Session& session, const TraceRequest& request);
template <World W>
Replay replay_in(const Job& job, const Session& session, int chain, std::uint64_t step);

// Defined in world_checks.h.
template <World W>
void check_in(const Job& job, const InvarianceOptions& options, const Run& run,
              const KernelChecked& done);

}  // namespace wander

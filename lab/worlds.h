// What an engine is made of, for any world.  Each function is made for each world in a file of its
// own (world_methods_space.cpp, family/study_space.cpp, ...), for they take long to compile.
#pragma once

#include "core/world.h"
#include "lab/engine.h"

namespace wander {

template <World W>
inline constexpr WorldKind kind_of{
    W::dimension,
    std::same_as<typename W::Real, float> ? Precision::of_float : Precision::of_double,
    W::channels};

// Defined in world_methods.h.
template <World W>
std::unique_ptr<WorldRun> hold_in(const KeptRun& from, const Job& job, const Session& session);
template <World W>
Rendering merge_in(const Job& job, std::span<const StoredRun> runs, const Session& session);

// Defined in family/tracers.h.
template <World W>
Trace trace_in(const Job& job, const Session& session, const TraceRequest& request);
template <World W>
Replay replay_in(const Job& job, const Session& session, int chain, std::uint64_t step);

// Defined in family/checks.h.
template <World W>
void check_in(const Job& job, const InvarianceOptions& options, const Run& run,
              const KernelChecked& done);

}  // namespace wander

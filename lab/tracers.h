// The methods of `trace` by name: those whose state is one path.
#pragma once

#include <span>
#include <string_view>

#include "core/description.h"
#include "lab/dials.h"
#include "lab/replay.h"
#include "lab/trace.h"
#include "work/session.h"

namespace wander {

// As many chains can be told apart, and traced, as render() runs.
inline constexpr int most_traced_chains = ChainSettings{}.groups * ChainSettings{}.chains_per_group;

std::span<const std::string_view> traced_methods();

// `method` is one of traced_methods(); the budget of the session is that of the request.  Throws
// NoLightFound, NothingComputed, and
// UsageError if the scene does not fit into the precision.
Trace trace(const description::Scene& scene, std::string_view method, const Dials& dials,
            const Session& session, const TraceRequest& request);
// A step of a chain of mlt.
Replay replay(const description::Scene& scene, const Dials& dials, const Session& session,
              int chain, std::uint64_t step);

}  // namespace wander

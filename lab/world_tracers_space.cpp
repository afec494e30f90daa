#include "lab/world_tracers.h"

namespace wander {

template Trace trace_in<Spaceland>(const Job&, const Session&, const TraceRequest&);
template Replay replay_in<Spaceland>(const Job&, const Session&, int, std::uint64_t);

}  // namespace wander

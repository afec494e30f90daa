#include "lab/family/checks.h"
#include "lab/family/tracers.h"

namespace wander {

template Trace trace_in<FlatlandSingle>(const Job&, const Session&, const TraceRequest&);
template Replay replay_in<FlatlandSingle>(const Job&, const Session&, int, std::uint64_t);
template void check_in<FlatlandSingle>(const Job&, const InvarianceOptions&, const Run&,
                                       const KernelChecked&);

}  // namespace wander

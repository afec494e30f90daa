// Which steps of which chains a trajectory is made of, and how many can be.
#pragma once

#include "lab/method.h"
#include "records/trajectory_of_logs.h"

namespace wander {

struct TraceRequest {
  int chains = 4;
  TraceWindow window;
};

// Throws UsageError where there is no chain whose state is one path.
void require_traced(const Method& method);
// Throws UsageError where there are more draws than are kept in memory, some hundred bytes each.
void require_bounded(const TraceRequest& request);

}  // namespace wander

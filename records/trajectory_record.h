// A trajectory as it is saved: what was recorded, and what made it.
#pragma once

#include <cstdint>
#include <string>

#include "records/rendering.h"
#include "records/run_record.h"
#include "records/trajectory.h"

namespace wander {

struct TrajectoryRecord {
  Trajectory trajectory;
  bool complete = true;  // all draws that were asked for
  std::string method;
  std::uint64_t seed = 1;
  Estimate normalization;  // b, of the seed pass
  Provenance provenance;
};

}  // namespace wander

// A trajectory as text: one row per draw with the scalars of trajectory_netcdf.h, those of the
// proposed path with `proposed_` before them.  Numbers read back to the same double; what does not
// exist is `nan`, or empty where a word is expected.
#pragma once

#include <string>

#include "records/trajectory.h"

namespace wander {

std::string to_csv(const Trajectory& trajectory);

}  // namespace wander

// The state of a run as bytes, and its way back: what a checkpoint holds beside its headway (drive.h).  They are read by the
// version of the program that wrote them.
#pragma once

#include <iosfwd>
#include <string>

#include "lab/live_run.h"

namespace wander {

void write_state(const LiveRun& run, std::ostream& bytes);
std::string state_of(const LiveRun& run);

// Throws std::exception if the bytes are not of such a run.
void restore(LiveRun& run, const std::string& state);

}  // namespace wander

// What Ceres says on the standard error stream.
#pragma once

#include <glog/logging.h>

namespace wander {

// A solve that does not converge is a result, which callers tell in words of their own; Ceres writes a
// line about it through glog, whatever its options say.
inline void silence_solver() { FLAGS_minloglevel = google::GLOG_FATAL; }

}  // namespace wander

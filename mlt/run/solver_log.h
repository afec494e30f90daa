// What Ceres says on the standard error stream.
#pragma once

#include <glog/logging.h>

namespace wander {

// A solve that does not converge is a result, which callers tell in words of their own; Ceres writes a
// line about it through glog, whatever its options say.  Once, for all threads read it.
inline void silence_solver() {
  static const int level = FLAGS_minloglevel = google::GLOG_FATAL;
  static_cast<void>(level);
}

}  // namespace wander

// The methods by Markov chains.  They are defined in family/mlt_run.h and world_methods.h, and made for
// each world in a file of its own.
#pragma once

#include "lab/stage.h"

namespace wander {

// mlt, in path space
struct MltMethod {
  template <World W>
  static std::unique_ptr<LiveRun> make(const Stage<W>& stage);
};
struct PssmltMethod {
  template <World W>
  static std::unique_ptr<LiveRun> make(const Stage<W>& stage);
};
struct MmltMethod {
  template <World W>
  static std::unique_ptr<LiveRun> make(const Stage<W>& stage);
};

}  // namespace wander

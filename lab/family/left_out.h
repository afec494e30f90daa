// In place of mlt in a world that is left out of the program (WANDER_WORLDS).
#pragma once

#include <stdexcept>

#include "lab/chain_methods.h"

namespace wander {

// No job is in a world that has no engine.
template <World W>
std::unique_ptr<LiveRun> MltMethod::make(const Stage<W>&) {
  throw std::logic_error("a job is in a world that this program is built without");
}

}  // namespace wander

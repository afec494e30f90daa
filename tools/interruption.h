// Ctrl-C and SIGTERM: the first asks the run to finish early and save, a later one kills.
#pragma once

#include <atomic>

namespace wander {

// Installs the handlers and returns the flag that the first signal sets.
const std::atomic<bool>& watch_for_interruption();

}  // namespace wander

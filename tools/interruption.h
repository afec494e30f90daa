// Ctrl-C and SIGTERM: once a verb watches, the first asks the run to finish early and save, a later one
// kills.  Before that the first ends the program.
#pragma once

#include <atomic>

namespace wander {

// From now on they end the program, also where a shell has it ignore them, as it does in the background.
void leave_at_interruption();

// From now on they are noted: installs the handlers and returns the flag that the first signal sets.
const std::atomic<bool>& watch_for_interruption();

}  // namespace wander

// Other work on the machine takes its part of a budget of wall time, and of one run more than of
// another.
#pragma once

#include <string>

namespace wander {

// In words, where `threads` threads had much less than `seconds` of processor time each; else
// empty.
std::string load_warning(double seconds, double processor_seconds, int threads);

}  // namespace wander

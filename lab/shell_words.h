// Words of a command line, as a shell reads them.
#pragma once

#include <string>

namespace wander {

// The arguments as one line that a shell reads back to the same words; of the program its name alone.
std::string quoted_for_shell(int count, const char* const* arguments);

}  // namespace wander

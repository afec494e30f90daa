// The command line of the program as CLI11 knows it: every verb with its options and help.
#pragma once

#include "tools/verb.h"

namespace wander {

// What `--help` says of the exit codes.
std::string exit_code_table();

void build_application(CLI::App& app, Global& global);

}  // namespace wander

// Reads the words of the command line, and finds all that is wrong with them rather than the first
// fault alone.
#pragma once

#include <string>
#include <vector>

#include "tools/examination.h"

namespace CLI {
class App;
}

namespace wander {

// `help VERB` stands for `VERB --help`.  Throws CLI::CallForHelp and CLI::CallForVersion; faults go
// to the examination.  False if no sense could be made of the words, so that what they leave out is
// not known.
bool read_command_line(CLI::App& app, std::vector<std::string> words, Examination& examination);

}  // namespace wander

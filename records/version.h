// The version of the program, as every output and `--version` state it.
#pragma once

namespace wander {

const char* program_version();

}  // namespace wander

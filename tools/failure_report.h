// How the program tells that it failed: messages on stderr, with --json {"error": ...} on stdout,
// and the exit code.
#pragma once

#include <exception>

#include "lab/exit_code.h"
#include "tools/verb.h"

namespace wander {

// `problem` may be several at once (Failures).  A usage error among them decides the exit code, for
// the command line must change anyway; else the first does.
ExitCode report_failure(const std::exception& problem, const Global& global);

}  // namespace wander

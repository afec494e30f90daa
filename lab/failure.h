// How a verb gives up: an exception that carries the exit code.  main() prints it and, with --json,
// turns it into {"error": ...}.  Whatever else is thrown is a run-time failure.
#pragma once

#include <stdexcept>
#include <string>

#include "lab/exit_code.h"

namespace wander {

class CommandFailure : public std::runtime_error {
 public:
  CommandFailure(ExitCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

// The command line asks for something that does not exist or makes no sense.
class UsageError : public CommandFailure {
 public:
  explicit UsageError(const std::string& message) : CommandFailure(ExitCode::usage, message) {}
};

}  // namespace wander

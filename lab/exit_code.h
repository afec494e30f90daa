// The exit codes of the program: the one table that the verbs return and that `--help` prints.
#pragma once

#include <array>

namespace wander {

enum class ExitCode {
  ok = 0,
  failure = 1,
  usage = 2,
  invalid_input = 3,
  check_failed = 4,
  interrupted = 130
};

struct ExitCodeMeaning {
  ExitCode code;
  const char* meaning;
};

inline constexpr std::array exit_code_meanings{
    ExitCodeMeaning{ExitCode::ok, "success"},
    ExitCodeMeaning{ExitCode::failure, "run-time failure: a disk is full, no light is found, ..."},
    ExitCodeMeaning{ExitCode::usage,
                    "usage: the command line asks for something that does not exist"},
    ExitCodeMeaning{ExitCode::invalid_input, "invalid scene or input file"},
    ExitCodeMeaning{ExitCode::check_failed, "a check or comparison failed"},
    ExitCodeMeaning{ExitCode::interrupted,
                    "interrupted; what was computed so far is saved as incomplete"},
};

}  // namespace wander

// The program `wander`: reads the command line, runs the chosen verb, and turns every failure into
// a message and an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <string>
#include <string_view>
#include <vector>

#include "lab/failure.h"
#include "lab/shell_words.h"
#include "tools/application.h"
#include "tools/command_line.h"
#include "tools/console.h"
#include "tools/examination.h"
#include "tools/failure_report.h"
#include "tools/verb.h"

namespace {

using namespace wander;

// All that can be said against the command is said before anything is computed.
ExitCode run(CLI::App& app, Global& global, const std::vector<std::string>& words) {
  Examination examination;
  try {
    const bool is_read = read_command_line(app, words, examination);
    if (global.quiet && global.verbose)
      examination.part([] { throw UsageError("--quiet and --verbose exclude each other"); });
    open_log(global.quiet     ? Verbosity::quiet
             : global.verbose ? Verbosity::verbose
                              : Verbosity::normal);
    if (is_read && global.examine) global.examine(examination);
  } catch (const CLI::CallForHelp&) {
    print_data(app.help());
    return ExitCode::ok;
  } catch (const CLI::CallForVersion& wanted) {
    print_data(fmt::format("{}\n", wanted.what()));
    return ExitCode::ok;
  }
  examination.require_passed();
  return global.job();
}

}  // namespace

int main(int count, char** arguments) {
  // Writing to a closed pipe or beyond a file size limit is an error to report, not a death.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  open_log(Verbosity::normal);
  Global global;
  // Known before the command line is parsed, for parsing itself may fail.
  global.json = std::any_of(arguments, arguments + count,
                            [](std::string_view argument) { return argument == "--json"; });
  try {
    global.command_line = quoted_for_shell(count, arguments);
    CLI::App app;
    build_application(app, global);
    if (count == 1) {
      print_note(app.help());
      return static_cast<int>(ExitCode::usage);
    }
    return static_cast<int>(run(app, global, {arguments + 1, arguments + count}));
  } catch (const std::exception& problem) {
    return static_cast<int>(report_failure(problem, global));
  }
}

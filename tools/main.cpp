// The program `wander`: reads the command line, runs the chosen verb, and turns every failure into
// a message and an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "core/output/atomic_file.h"
#include "core/output/run_record.h"
#include "core/output/version.h"
#include "core/scene_file.h"
#include "tools/console.h"
#include "tools/failure.h"
#include "tools/nearest.h"
#include "tools/parsing.h"
#include "tools/verb.h"

namespace {

using namespace wander;

constexpr const char* introduction =
    "Wanderlight: a Metropolis light transport testbed.\n\n"
    "  wander gallery                                   which scenes come with the program\n"
    "  wander inspect gallery:NAME                      what a scene requires\n"
    "  wander render gallery:NAME -m mlt -b 5s -o run   the light on its sensor, with error bars\n"
    "  wander plot run/run.json -o film.svg             the result as a figure\n"
    "  wander compare gallery:NAME -m bdpt,mlt -o duel  error against time and samples\n"
    "  wander trace gallery:NAME -o chains.nc           every step of some Markov chains\n";

std::string exit_code_table() {
  std::string text = "Exit codes:\n";
  for (const ExitCodeMeaning& entry : exit_code_meanings)
    text += fmt::format("  {:>3}  {}\n", static_cast<int>(entry.code), entry.meaning);
  return text;
}

void build(CLI::App& app, Global& global) {
  app.name("wander");
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  app.footer("\n" + exit_code_table() +
             "\n`wander VERB --help` explains one verb.  Data goes to stdout, the rest to stderr.");
  app.set_version_flag("--version", fmt::format("wander {}", program_version()),
                       "print the version and exit");
  app.require_subcommand(1);
  add_global_options(app, global);
  add_render(app, global);
  add_trace(app, global);
  add_inspect(app, global);
  add_gallery(app, global);
  add_plot(app, global);
  add_check(app, global);
  add_compare(app, global);
  for (CLI::App* verb : app.get_subcommands({})) verb->group("Verbs");
}

std::vector<std::string_view> names_of(const std::vector<CLI::App*>& verbs) {
  std::vector<std::string_view> names;
  for (const CLI::App* verb : verbs) names.push_back(verb->get_name());
  return names;
}

// What CLI11 found wrong, in words that help.
UsageError usage_error(CLI::App& app, const CLI::ParseError& problem) {
  const auto is_word = [](const std::string& argument) { return !argument.starts_with("-"); };
  if (app.get_subcommands().empty()) {
    const std::vector<std::string> left = app.remaining();
    const auto word = std::find_if(left.begin(), left.end(), is_word);
    if (word != left.end())
      return UsageError(unknown_word("verb", *word, names_of(app.get_subcommands({}))));
    return UsageError("a verb is missing; see `wander --help`");
  }
  const std::string verb = app.get_subcommands().front()->get_name();
  return UsageError(fmt::format("{}; see `wander {} --help`", problem.what(), verb));
}

ExitCode exit_code_of(const std::exception& problem) {
  if (const auto* failure = dynamic_cast<const CommandFailure*>(&problem)) return failure->code();
  if (dynamic_cast<const SceneFileError*>(&problem) != nullptr) return ExitCode::invalid_input;
  if (dynamic_cast<const RunFileError*>(&problem) != nullptr) return ExitCode::invalid_input;
  return ExitCode::failure;
}

std::string message_of(const std::exception& problem) {
  if (dynamic_cast<const std::bad_alloc*>(&problem) != nullptr) return "out of memory";
  return problem.what();
}

nlohmann::ordered_json error_document(const std::exception& problem) {
  nlohmann::ordered_json faults = nlohmann::ordered_json::array();
  if (const auto* invalid = dynamic_cast<const SceneFileError*>(&problem))
    for (const Fault& fault : invalid->faults)
      faults.push_back({{"line", fault.line},
                        {"column", fault.column},
                        {"pointer", fault.pointer},
                        {"what", fault.what}});
  return {{"error", {{"message", message_of(problem)}, {"faults", faults}}}};
}

ExitCode report(const std::exception& problem, const Global& global) {
  // Faults of a scene are lines FILE:LINE:COL: that editors follow, so nothing stands before them.
  if (dynamic_cast<const SceneFileError*>(&problem) != nullptr)
    print_note(message_of(problem) + "\n");
  else
    print_error(message_of(problem));
  if (global.json) {
    try {
      print_json(error_document(problem));
    } catch (const OutputError&) {
      // Nobody listens on stdout; stderr and the exit code tell.
    }
  }
  return exit_code_of(problem);
}

ExitCode run(CLI::App& app, Global& global, int count, char** arguments) {
  try {
    app.parse(count, arguments);
  } catch (const CLI::CallForHelp&) {
    print_data(app.help());
    return ExitCode::ok;
  } catch (const CLI::CallForVersion& wanted) {
    print_data(fmt::format("{}\n", wanted.what()));
    return ExitCode::ok;
  } catch (const CLI::ParseError& problem) {
    throw usage_error(app, problem);
  }
  if (global.quiet && global.verbose) throw UsageError("--quiet and --verbose exclude each other");
  open_log(global.quiet     ? Verbosity::quiet
           : global.verbose ? Verbosity::verbose
                            : Verbosity::normal);
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
    CLI::App app(introduction);
    build(app, global);
    if (count == 1) {
      print_note(app.help());
      return static_cast<int>(ExitCode::usage);
    }
    return static_cast<int>(run(app, global, count, arguments));
  } catch (const std::exception& problem) {
    return static_cast<int>(report(problem, global));
  }
}

// The shape of a verb.  Each lives in one short file and offers `void add_VERB(CLI::App&,
// Global&)`: it adds its subcommand, calls `add_global_options` on it, and as the subcommand's
// callback leaves in `global.job` what is to be done.  main() runs the job once the whole command
// line is parsed.  `examine_with` says how all faults of the command are found together, also when
// the line has others.
//
//   void add_greet(CLI::App& app, Global& global) {
//     auto name = std::make_shared<std::string>();
//     Command verb = add_verb(app, "greet", "say hello");
//     verb.add_option("NAME", *name, "whom").required();
//     add_global_options(verb, global);
//     verb.callback([&global, name] { global.job = [=, &global] { return greet(global, *name); }; });
//   }
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "lab/exit_code.h"
#include "tools/examination.h"

namespace CLI {
class App;
}

namespace wander {

class Command;  // tools/command.h

inline constexpr std::array<std::string_view, 4> progress_words{"auto", "bar", "json", "none"};
enum class ProgressMode { automatic, bar, json, none };

// What every verb is told by the options that all verbs share.
struct Global {
  bool json = false;     // stdout is exactly one JSON document
  bool force = false;    // existing outputs may be replaced
  bool quiet = false;    // nothing on stderr but errors
  bool verbose = false;  // say what is being done
  int threads = 0;       // 0: all cores
  std::uint64_t seed = 1;
  std::filesystem::path out;  // empty: no output was asked for
  ProgressMode progress = ProgressMode::automatic;
  std::string command_line;  // as typed, quoted for a shell; goes into every output
  // Whether the chosen verb can do what is asked; options may be missing.
  std::function<void(Examination&)> examine;
  std::function<ExitCode()> job;  // what the chosen verb does, once it passed
};

void add_global_options(Command verb, Global& global);
void examine_with(Command verb, Global& global, std::function<void(Examination&)> examine);

void add_render(CLI::App& app, Global& global);
void add_trace(CLI::App& app, Global& global);
void add_inspect(CLI::App& app, Global& global);
void add_gallery(CLI::App& app, Global& global);
void add_plot(CLI::App& app, Global& global);
void add_check(CLI::App& app, Global& global);
void add_compare(CLI::App& app, Global& global);
void add_merge(CLI::App& app, Global& global);
void add_import(CLI::App& app, Global& global);

}  // namespace wander

#include "tools/application.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "records/version.h"
#include "tools/command.h"

namespace wander {

namespace {

constexpr const char* introduction =
    "Wanderlight: a Metropolis light transport testbed.\n\n"
    "  wander gallery                                   which scenes come with the program\n"
    "  wander inspect gallery:NAME                      what a scene requires\n"
    "  wander render gallery:NAME -m mlt -b 5s -o run   the light on its sensor, with error bars\n"
    "  wander plot run/run.json -o film.svg             the result as a figure\n"
    "  wander compare gallery:NAME -m bdpt,mlt -o duel  error against time and samples\n"
    "  wander trace gallery:NAME -o chains.nc           every step of some Markov chains\n";

}  // namespace

std::string exit_code_table() {
  std::string text = "Exit codes:\n";
  for (const ExitCodeMeaning& entry : exit_code_meanings)
    text += fmt::format("  {:>3}  {}\n", static_cast<int>(entry.code), entry.meaning);
  return text;
}

void build_application(CLI::App& app, Global& global) {
  app.name("wander");
  app.description(introduction);
  app.get_formatter()->label("SUBCOMMAND", "VERB");
  app.footer("\n" + exit_code_table() +
             "\n`wander help VERB` explains one verb.  Data goes to stdout, the rest to stderr.");
  app.set_version_flag("--version", fmt::format("wander {}", program_version()),
                       "print the version and exit");
  app.require_subcommand(1);
  add_global_options(Command(app), global);
  add_render(app, global);
  add_trace(app, global);
  add_inspect(app, global);
  add_gallery(app, global);
  add_plot(app, global);
  add_check(app, global);
  add_compare(app, global);
  add_merge(app, global);
  add_import(app, global);
  for (CLI::App* verb : app.get_subcommands({})) verb->group("Verbs");
}

}  // namespace wander

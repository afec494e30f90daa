// `wander compare`: error against time and samples, method against method.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "draw/report/comparison_files.h"
#include "lab/checkpoint.h"
#include "lab/compare/comparison_json.h"
#include "lab/compare/forecast.h"
#include "lab/failure.h"
#include "lab/parsing.h"
#include "lab/reference_name.h"
#include "lab/scene_source.h"
#include "records/run_files.h"
#include "tools/command.h"
#include "tools/compare_runs.h"
#include "tools/compare_task.h"
#include "tools/console.h"
#include "tools/interruption.h"
#include "tools/output_place.h"
#include "tools/progress.h"
#include "tools/verb.h"

namespace wander {

namespace compare {

namespace {

void announce(const Forecast& forecast, Progress& progress, const Global& global) {
  if (global.progress == ProgressMode::json)
    print_note(json_line_of(forecast) + "\n");
  else if (!global.quiet)
    progress.say(in_words(forecast));
}

void tell_where_it_goes_on(const CompareTask& task) {
  const Plan& plan = task.plan;
  print_note(fmt::format("  carried on from {} of {} runs\n", task.kept.finished(),
                         plan.entrants.size() * plan.budgets.size() * plan.replicates));
}

Runs compared(const CompareOptions& options, CompareTask& task, const Global& global,
              const std::optional<OutputDirectory>& directory) {
  Progress progress(global);
  const CompareHost host{
      .session = {.threads = global.threads,
                  .interrupted = &watch_for_interruption(),
                  .report = progress.reporter()},
      .announce = [&](const Forecast& ahead) { announce(ahead, progress, global); },
      .command_line = global.command_line};
  return runs_of(task, options, host, directory ? std::optional(directory->path()) : std::nullopt);
}

ExitCode compare_methods(const CompareOptions& options, CompareTask& task, const Global& global) {
  std::optional<OutputDirectory> directory;
  Global place = global;
  place.force = place.force || options.is_continuation;
  if (!global.out.empty()) directory.emplace(global.out, place);
  if (options.is_continuation && !global.quiet) tell_where_it_goes_on(task);

  const Comparison comparison = summarize(compared(options, task, global, directory));

  if (directory) {
    write_comparison(comparison, task.document.scene, directory->path());
    if (!options.is_continuation && !comparison.runs.runs.empty()) {
      remove_run(directory->path());
      remove_file(checkpoint_in(directory->path()));
    }
  }
  if (!global.quiet) {
    for (const std::string& line : comparison.verdict) print_note(line + "\n");
    print_note(
        fmt::format("  reference {}\n", name_of_reference(comparison.runs.reference.origin)));
    if (directory) print_note(fmt::format("  saved in  {}\n", directory->path().string()));
  }
  for (const std::string& warning : comparison.runs.warnings) spdlog::warn("{}", warning);
  if (global.json) print_json(to_json(comparison));
  return comparison.runs.complete ? ExitCode::ok : ExitCode::interrupted;
}

std::string dials_help() {
  std::string text = "Dials, for --dial and --sweep:\n";
  for (const Dial& dial : dials())
    text += fmt::format("  {:<19} {}\n",
                        fmt::format("{}={}", dial.word, dial.value.empty() ? "on" : dial.value),
                        dial.help);
  return text;
}

constexpr const char* compare_details = R"(
Every method runs R times at every budget, each time with a seed of its own.  Contenders take turns
in an order that rotates, so that a machine that grows hot or busy harms all alike.  Budgets are all
samples (300k, 5M), all wall time (500ms, 30s, 2min) or all processor time, which other work on the
machine does not use up (0.5cpu-s, 30cpu-s): then all times are of the processors.  With samples, the
same seed gives the same films, whatever the number of threads, and against the same reference the
same errors.

A sweep adds, to each method that has the dial, one contender for each value, the other dials being
as usual or as --dial says.  The usual value takes part in any case, and once: where a sweep names
it, the label ends in (default), or in (base) after --dial.  Several sweeps are made one after the
other.  Values that hold commas are parted by semicolons:
--sweep 'mutations=lens=1,primary=1;bidirectional=1'.

Errors are measured against a reference whose own error is known and allowed for:
  FILE  the DIR of an earlier render, its run.json, film.exr or film.nc, or the reference.json or
        films/reference.exr of an earlier comparison; its film has the shape of that of the scene
  auto  the exact film where all is diffuse and made of segments; else a mean of long runs of the two
        methods, contenders or not, that tell most in a second by a short trial.  Together they take
        as long as 3 R runs at the largest budget, and they are made first.  A warning says so where
        the two do not agree.  Long runs are kept for the next time in $XDG_CACHE_HOME/wanderlight
        or ~/.cache/wanderlight; remove that folder to make them anew.

DIR receives report.html, compare.json and compare.csv; of scenes in the plane reference.json, in space
films/reference.exr and films/METHOD-BUDGET.exr, the first replicate of each contender at each budget;
and a folder `kept` with the reference and every finished run, from which --continue carries the comparison on, also after Ctrl-C
or a crash: what is there is not made again.  With samples the films are those of a comparison that
never stopped.  Ctrl-C ends it with the runs that are complete, if there are any: exit code 130 and
"complete": false.  A run in which a chain finds no light to start from is recorded as failed and
does not end the comparison.

Examples:
  wander compare scene.json -o comparison
  wander compare scene.json -m pt,bdpt,mlt -b 100k,1M --replicates 16 --target 0.01 -o comparison
  wander compare scene.json -m mlt -b 1s,4s --sweep max_vertices=4,6,8 -o sweep
  wander compare --continue -o comparison --replicates 32
)";

// Those that say nothing are as usual, or as the comparison has them that is carried on.
void add_options(Command verb, CompareOptions& options) {
  verb.add_option("SCENE", options.scene, std::string(scene_help) + "; of a new comparison")
      .type_name("");
  verb.add_option("-m,--methods", options.methods, "as of render (default: bdpt,mlt)")
      .type_name("METHOD,...");
  verb.add_option("-b,--budgets", options.budgets,
                  "how much each run computes (default: 0.25s,1s,4s)")
      .type_name("BUDGET,...");
  verb.add_option(
          "--replicates",
          [&options](const std::string& text) {
            options.replicates = parse_count("--replicates", text, 2, 10'000);
          },
          "runs of each contender at each budget (default: 8); of a comparison that is continued, "
          "in all (default: its own)")
      .type_name("R");
  verb.add_option("--reference", options.reference,
                  "what errors are measured against (default: auto)")
      .type_name("FILE|auto");
  verb.add_option("--sweep", options.sweeps, "contenders at these values of a dial")
      .type_name("DIAL=V1,V2,...")
      .one_value_each_time();
  verb.add_option("--dial", options.fixed, "turn a dial for all methods that have it")
      .type_name("DIAL=VALUE")
      .one_value_each_time();
  verb.add_option(
          "--target",
          [&options](const std::string& text) { options.target = parse_share("--target", text); },
          "the relative error to which times are told (default: a round one that the best reaches)")
      .type_name("E");
  verb.add_flag("--continue", options.is_continuation,
                "carry on the comparison in DIR; SCENE and all that makes the runs are its own");
}

}  // namespace

}  // namespace compare

void add_compare(CLI::App& app, Global& global) {
  using namespace compare;
  auto options = std::make_shared<CompareOptions>();
  auto task = std::make_shared<std::optional<CompareTask>>();
  Command verb = add_verb(app, "compare", "error against time and samples, method against method");
  add_options(verb, *options);
  add_global_options(verb, global);
  verb.footer("\n" + dials_help() + compare_details);
  examine_with(verb, global, [options, task, verb, &global](Examination& examination) {
    if (verb.count("--seed") > 0) options->seed = global.seed;
    *task = examine_compare(*options, global, examination);
  });
  verb.callback([options, task, &global] {
    global.job = [options, task, &global] {
      return compare_methods(*options, task->value(), global);
    };
  });
}

}  // namespace wander

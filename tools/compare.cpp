// `wander compare`: error against time and samples, method against method.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "draw/report/comparison_files.h"
#include "lab/compare/comparison_json.h"
#include "lab/compare/forecast.h"
#include "lab/compare/long_reference.h"
#include "lab/compare/reference.h"
#include "lab/failure.h"
#include "lab/load_warning.h"
#include "lab/parsing.h"
#include "lab/reference_name.h"
#include "lab/scene_source.h"
#include "tools/console.h"
#include "tools/examined_job.h"
#include "tools/interruption.h"
#include "tools/output_place.h"
#include "tools/progress.h"
#include "tools/verb.h"

namespace wander {

namespace {

using namespace compare;

struct CompareOptions {
  std::string scene;
  std::string methods = "bdpt,mlt";
  std::string budgets = "0.25s,1s,4s";
  std::size_t replicates = 8;
  std::string reference = "auto";
  std::vector<std::string> fixed, sweeps;
  double target = not_known;
  // Once they are read.
  std::optional<Plan> plan;
  std::optional<SceneDocument> document;
};

// `max_vertices` is that of the scene, once it is read.
std::vector<Entrant> entrants_of(const CompareOptions& options, std::optional<int> max_vertices) {
  std::vector<Setting> fixed;
  std::vector<Sweep> sweeps;
  for (const std::string& text : options.fixed) fixed.push_back(parse_setting(text));
  for (const std::string& text : options.sweeps) sweeps.push_back(parse_sweep(text));
  return line_up(parse_methods(options.methods), fixed, sweeps, max_vertices);
}

Plan plan_of(const CompareOptions& options, const Global& global) {
  Plan plan{.source = options.scene,
            .entrants = entrants_of(options, std::nullopt),
            .budgets = parse_budgets(options.budgets),
            .replicates = options.replicates,
            .seed = global.seed,
            .threads = global.threads};
  require_few_enough(plan);
  return plan;
}

// Paths are as long as the scene says, or the base point.
SceneDocument scene_for(const Plan& plan) {
  SceneDocument document = open_scene(plan.source);
  const Dials& base = plan.entrants.front().dials;
  document.scene.max_vertices = base.max_vertices.value_or(document.scene.max_vertices);
  return document;
}

void examine(CompareOptions& options, const Global& global, Examination& examination) {
  examination.part([&] {
    if (global.out.empty() && !global.json)
      throw UsageError("compare needs -o DIR (where the tables go), or --json, or both");
    if (!global.out.empty()) require_replaceable_directory(global.out, global);
  });
  examination.part([&] { options.plan = plan_of(options, global); });
  if (options.scene.empty()) return;
  examination.part([&] {
    // Faults of the scene are told even where nothing is known of the contenders.
    options.document = options.plan ? scene_for(*options.plan) : open_scene(options.scene);
  });
  if (!options.plan || !options.document) return;
  options.plan->entrants = entrants_of(options, options.document->scene.max_vertices);
  for (Entrant& entrant : options.plan->entrants)
    entrant.job =
        examined_job(options.document->scene, *entrant.method, entrant.dials, examination);
}

// What is known before anything is sampled.
std::optional<Reference> known_reference(const SceneDocument& document, const std::string& wanted,
                                         Runs& runs) {
  if (wanted != "auto")
    return reference_from_file(wanted, film_shape(document.scene), runs.provenance, runs.warnings);
  std::string why;
  auto exact = exact_reference(document.scene, why);
  if (!exact) spdlog::debug("no exact film: {}", why);
  return exact;
}

// The warnings of the methods, each said once, and what is doubtful.
void collect_warnings(Runs& runs) {
  for (std::size_t c = 0; c < runs.contenders.size(); ++c)
    for (const std::string& warning : runs.details[c].warnings)
      runs.warnings.push_back(fmt::format("{}: {}", runs.contenders[c].label, warning));
  const auto& doubts = runs.reference.doubts;
  runs.warnings.insert(runs.warnings.end(), doubts.begin(), doubts.end());
  if (!runs.failures.empty())
    runs.warnings.push_back(fmt::format(
        "{} of {} runs failed, the first of {}: {}", runs.failures.size(),
        runs.failures.size() + runs.runs.size(),
        runs.contenders[runs.failures.front().contender].label, runs.failures.front().message));
}

// Once for all runs together.
void warn_of_load(const Plan& plan, Runs& runs) {
  if (!is_of_wall_time(plan.budgets.back().budget)) return;
  double seconds = 0, processor_seconds = 0;
  int threads = 1;
  for (const compare::Run& run : runs.runs) {
    seconds += run.seconds;
    processor_seconds += run.processor_seconds;
  }
  for (const Rendering& rendering : runs.details) threads = std::max(threads, rendering.threads);
  if (std::string load = load_warning(seconds, processor_seconds, threads); !load.empty())
    runs.warnings.push_back(std::move(load));
}

// Whatever was interrupted is shown, be it ever so little.
void require_some(const Runs& runs) {
  if (runs.runs.empty() && runs.complete)
    throw CommandFailure(ExitCode::failure, runs.failures.front().message);
}

double effort_of_all(const Plan& plan, bool needs_reference) {
  return effort_of(plan) + effort_of_paces(plan) +
         (needs_reference ? trial_effort(plan) + reference_effort(plan) : 0);
}

void announce(const Forecast& forecast, Progress& progress, const Global& global) {
  if (global.progress == ProgressMode::json)
    print_note(json_line_of(forecast) + "\n");
  else if (!global.quiet)
    progress.say(in_words(forecast));
}

// The reference first: what an interruption leaves of the runs can then be measured.
void make_runs(const SceneDocument& document, const Plan& plan, std::optional<Reference> reference,
               const Global& global, Runs& runs) {
  Progress progress(global);
  const Session common{.threads = global.threads,
                       .interrupted = &watch_for_interruption(),
                       .report = progress.reporter()};
  Course course(document.scene, common, effort_of_all(plan, !reference));
  Forecast ahead = forecast(plan, paces_of(plan, course));
  LongPlan long_plan;
  const ReferenceCache cache(runs.provenance, document.scene.max_vertices);
  const std::vector<int> shape = film_shape(document.scene);
  if (!reference) {
    const std::vector<Worth> worths = hold_trial(plan, course);
    long_plan = plan_reference(plan, worths, cache.load(shape, runs.warnings), ahead.longest);
    ahead.of_reference = long_plan.seconds;
  }
  course.expect(effort_of(long_plan) + effort_of(plan));
  if (!course.is_interrupted()) announce(ahead, progress, global);
  if (!reference) reference = make_reference(plan, long_plan, cache, course, shape, runs);
  runs.reference = *std::move(reference);
  measure(plan, course, runs);
}

Runs runs_of(const SceneDocument& document, const Plan& plan, const CompareOptions& options,
             const Global& global) {
  Runs runs = prepared(plan, provenance_of(document, global.command_line));
  runs.target = options.target;
  runs.warnings = scene_warnings(document, options.scene);
  make_runs(document, plan, known_reference(document, options.reference, runs), global, runs);
  require_some(runs);
  collect_warnings(runs);
  warn_of_load(plan, runs);
  return runs;
}

ExitCode compare_methods(const CompareOptions& options, const Global& global) {
  const Plan& plan = *options.plan;
  const SceneDocument& document = *options.document;
  std::optional<OutputDirectory> directory;
  if (!global.out.empty()) directory.emplace(global.out, global);

  const Comparison comparison = summarize(runs_of(document, plan, options, global));

  if (directory) write_comparison(comparison, directory->path());
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
    text += fmt::format("  {:<19} {}\n", fmt::format("{}={}", dial.word, dial.value), dial.help);
  return text;
}

constexpr const char* details = R"(
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
  FILE  a run.json, film.exr, or DIR of an earlier render, or the reference.json of a comparison
  auto  the exact film where all is diffuse and made of segments; else a mean of long runs of the two
        methods, contenders or not, that tell most in a second by a short trial.  Together they take
        as long as 3 R runs at the largest budget, and they are made first.  A warning says so where
        the two do not agree.  Long runs are kept for the next time in $XDG_CACHE_HOME/wanderlight
        or ~/.cache/wanderlight; remove that folder to make them anew.

DIR receives report.html, compare.json, compare.csv and reference.json.  Ctrl-C ends the comparison
with the runs that are complete, if there are any: exit code 130 and "complete": false.  A run in
which a chain finds no light to start from is recorded as failed and does not end the comparison.

Examples:
  wander compare scene.json -o comparison
  wander compare scene.json -m pt,bdpt,mlt -b 100k,1M --replicates 16 --target 0.01 -o comparison
  wander compare scene.json -m mlt -b 1s,4s --sweep max_vertices=4,6,8 -o sweep
)";

}  // namespace

void add_compare(CLI::App& app, Global& global) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* verb =
      app.add_subcommand("compare", "error against time and samples, method against method");
  verb->add_option("SCENE", options->scene, scene_help)->type_name("")->required();
  verb->add_option("-m,--methods", options->methods, "as of render (default: bdpt,mlt)")
      ->type_name("METHOD,...");
  verb->add_option("-b,--budgets", options->budgets,
                   "how much each run computes (default: 0.25s,1s,4s)")
      ->type_name("BUDGET,...");
  verb->add_option_function<std::string>(
          "--replicates",
          [options](const std::string& text) {
            options->replicates = parse_count("--replicates", text, 2, 10'000);
          },
          "runs of each contender at each budget (default: 8)")
      ->type_name("R");
  verb->add_option("--reference", options->reference,
                   "what errors are measured against (default: auto)")
      ->type_name("FILE|auto");
  verb->add_option("--sweep", options->sweeps, "contenders at these values of a dial")
      ->type_name("DIAL=V1,V2,...")
      ->allow_extra_args(false);
  verb->add_option("--dial", options->fixed, "turn a dial for all methods that have it")
      ->type_name("DIAL=VALUE")
      ->allow_extra_args(false);
  verb->add_option_function<std::string>(
          "--target",
          [options](const std::string& text) { options->target = parse_share("--target", text); },
          "the relative error to which times are told (default: a round one that the best reaches)")
      ->type_name("E");
  add_global_options(*verb, global);
  verb->footer("\n" + dials_help() + details);
  examine_with(*verb, global, [options, &global](Examination& examination) {
    examine(*options, global, examination);
  });
  verb->callback([options, &global] {
    global.job = [options, &global] { return compare_methods(*options, global); };
  });
}

}  // namespace wander

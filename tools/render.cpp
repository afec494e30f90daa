// `wander render`: estimates the film of a scene with one method and saves it.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lab/engine.h"
#include "lab/held_run.h"
#include "lab/memory_need.h"
#include "lab/parsing.h"
#include "lab/run_warnings.h"
#include "lab/scene_source.h"
#include "records/run_json.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/interruption.h"
#include "tools/progress.h"
#include "tools/render_task.h"
#include "tools/run_directory.h"
#include "tools/summary.h"
#include "tools/verb.h"

namespace wander {

namespace {

Rendering rendering_of(const RenderTask& task, const Keeper& keeper, const Global& global) {
  Progress progress(global);
  Session session{.budget = task.budget,
                  .seed = task.run.seed,
                  .threads = global.threads,
                  .report = progress.reporter()};
  HeldRun run(task.job, session, task.run.run);
  // Not before: while the scene is built there is nothing to save.
  session.interrupted = &watch_for_interruption();
  Rendering rendering = run.go_on(session, keeper);
  add_warnings(rendering, session, task.document, task.run.scene.source);
  return rendering;
}

Beginning beginning_of(const RenderOptions& options, const RenderTask& task) {
  if (!options.is_continuation) return Beginning::anew;
  if (task.is_begun_again()) return Beginning::begun_again;
  return task.is_new_budget ? Beginning::carried_further : Beginning::carried_on;
}

// What is kept of a run stands in its directory from the first moment, so that it can be carried on whenever it
// ends.
Keeper keeper_in(RunDirectory& directory, const RenderOptions& options, const RenderTask& task) {
  Keeper keeper = keeper_for(options, task.budget);
  keeper.least = std::max(task.samples_before.value_or(0), task.samples_in_place);
  return directory.keeper(std::move(keeper), task.run);
}

void tell_where_it_goes_on(const RenderOptions& options, const RenderTask& task) {
  const std::string& budget = options.budget.empty() ? task.run.budget : options.budget;
  if (task.has_enough)
    return print_note(
        fmt::format("  nothing to do: {} asks for no more than the {} samples of the run\n", budget,
                    task.run.run.headway.samples));
  if (task.is_begun_again())
    return print_note(fmt::format(
        "  begun again, to {}: what so few steps had planned is no plan for more; the run "
        "that is there stays until there is as much of the new one\n",
        budget));
  const bool has_chains = task.job.method().is_markov_chain();
  print_note(
      fmt::format("  carried on from {} samples, to {}\n", task.run.run.headway.samples, budget));
  if (has_chains && task.is_new_budget && task.run.run.headway.samples > 0)
    print_note("  the seed pass and the number of chains stay as the run has them\n");
}

// Always where it is much.
void tell_memory(const RenderTask& task, const Global& global) {
  Session session;
  session.threads = global.threads;
  const MemoryNeed need = memory_need(task.job, Run(session).threads());
  if (need.most() > much_memory)
    spdlog::info("the run needs about {}", memory_in_words(need));
  else
    spdlog::debug("the run needs about {}", memory_in_words(need));
}

ExitCode render_scene(const RenderOptions& options, const RenderTask& task, const Global& global) {
  std::optional<RunDirectory> directory;
  Keeper keeper;
  if (!global.out.empty()) {
    directory.emplace(global.out, global, beginning_of(options, task));
    keeper = keeper_in(*directory, options, task);
  }
  if (options.is_continuation && !global.quiet) tell_where_it_goes_on(options, task);
  tell_memory(task, global);

  const RunRecord run{rendering_of(task, keeper, global),
                      provenance_of(task.document, global.command_line)};

  if (directory) {
    directory->save(run, task.job.scene(), options.exposure.value_or(0));
    spdlog::debug("wrote the film and run.json");
  }
  if (!global.quiet) {
    print_note(summary_of(run.rendering));
    if (directory) print_note(fmt::format("  saved in        {}\n", directory->path().string()));
  }
  for (const std::string& warning : run.rendering.warnings) spdlog::warn("{}", warning);
  if (directory) directory->require_kept();
  if (global.json) print_data([&](const ByteSink& text) { write_json(run, 2, text); });
  return run.rendering.complete ? ExitCode::ok : ExitCode::interrupted;
}

std::string methods_help() {
  std::string text = "Methods:\n";
  for (const Method& method : methods())
    text += fmt::format("  {:<9} {}\n", method.name, method.summary);
  return text;
}

constexpr const char* render_details = R"(
A budget is a number of samples (2000000, 300k, 5M), wall time (1500ms, 30s, 5min, 2h), processor
time (30cpu-s), of all threads together, which other work on the machine does not use up, or the
relative error of the film, sqrt(sum of se^2 / sum of value^2), at which to stop ('error<0.01', or
'error<1%').
The same seed and number of samples, or error, give the same film, whatever the number of threads.

DIR receives film.exr, film.csv and run.json, and a file `checkpoint` from which --continue carries
the run on, also after Ctrl-C, which saves what was computed so far, or after a crash.  Continued to
the same number of samples it has the same bits as if it had never stopped.
An image, of a three-dimensional scene, has film.nc with its exact numbers in place of film.csv, and
film.png to look at.

Examples:
  wander render scene.json -m bdpt -b 1M -o run
  wander render --continue -o run -b 4M
)";

}  // namespace

void add_render(CLI::App& app, Global& global) {
  auto options = std::make_shared<RenderOptions>();
  auto task = std::make_shared<std::optional<RenderTask>>();
  Command verb = add_verb(app, "render", "estimate the film of a scene with one method");
  verb.add_option("SCENE", options->scene, std::string(scene_help) + "; of a new run")
      .type_name("");
  verb.add_option(
          "-m,--method",
          [options](const std::string& text) { options->method = &find_method(text); },
          "how to estimate, of a new run: see below")
      .type_name("METHOD");
  verb.add_option(
          "-b,--budget",
          [options](const std::string& text) {
            parse_budget(text);
            options->budget = text;
          },
          "how much to compute (default: 5s); of a run that is continued, in all (default: its "
          "own)")
      .type_name("BUDGET");
  verb.add_flag("--continue", options->is_continuation,
                "carry on the run in DIR; SCENE, method and dials are those of the run");
  verb.add_option(
          "--checkpoint",
          [options](const std::string& text) {
            options->checkpoint = parse_checkpoint_interval(text);
          },
          "keep the run so often, so that it can be continued whatever happens (default: 60 in "
          "runs "
          "longer than two minutes); 0: never, nor at its end")
      .type_name("SECONDS");
  verb.add_option(
          "--exposure",
          [options](const std::string& text) { options->exposure = parse_exposure(text); },
          "of film.png, in stops: +1 is twice as bright (default: 0, with which 99 % of the pixels "
          "that have light are not above white)")
      .type_name("EV");
  add_dial_options(verb, options->given);
  add_global_options(verb, global);
  verb.footer("\n" + methods_help() + render_details);
  examine_with(verb, global, [options, task, verb, &global](Examination& examination) {
    leave_at_interruption();
    if (verb.count("--seed") > 0) options->seed = global.seed;
    options->names_method = verb.count("--method") > 0;
    *task = examine_render(*options, global, examination);
  });
  verb.callback([options, task, &global] {
    global.job = [options, task, &global] { return render_scene(*options, task->value(), global); };
  });
}

}  // namespace wander

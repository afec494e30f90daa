// `wander render`: estimates the film of a scene with one method and saves it.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/load_warning.h"
#include "lab/parsing.h"
#include "lab/scene_source.h"
#include "records/run_files.h"
#include "records/run_json.h"
#include "tools/console.h"
#include "tools/dial_options.h"
#include "tools/examined_job.h"
#include "tools/interruption.h"
#include "tools/output_place.h"
#include "tools/progress.h"
#include "tools/summary.h"
#include "tools/verb.h"

namespace wander {

namespace {

struct RenderOptions {
  std::string scene;
  const Method* method = nullptr;
  Budget budget = TimeBudget{5};
  std::shared_ptr<DialOptions> given = std::make_shared<DialOptions>();
  // Once the scene is read.
  std::optional<SceneDocument> document;
  std::optional<Job> job;
};

void examine(RenderOptions& options, const Global& global, Examination& examination) {
  examination.part([&] {
    if (global.out.empty() && !global.json)
      throw UsageError("render needs -o DIR (where the film goes), or --json, or both");
    if (!global.out.empty()) require_replaceable_directory(global.out, global);
  });
  if (options.method) examination.part([&] { options.given->require_for(*options.method); });
  if (options.scene.empty()) return;
  examination.part([&] { options.document = open_scene(options.scene); });
  if (!options.document || !options.method) return;
  options.job =
      examined_job(options.document->scene, *options.method, options.given->dials, examination);
}

void say_scene(const RenderOptions& options) {
  const description::Scene& scene = options.job->scene();
  spdlog::debug("scene {}: {} shapes, {} materials, at most {} vertices, sha256 {}", options.scene,
                scene.shapes.size(), scene.materials.size(), scene.max_vertices,
                options.document->sha256);
}

Rendering rendering_of(const SceneDocument& document, const RenderOptions& options,
                       const Global& global) {
  Progress progress(global);
  const Session session{.budget = options.budget,
                        .seed = global.seed,
                        .threads = global.threads,
                        .interrupted = &watch_for_interruption(),
                        .report = progress.reporter()};
  Rendering rendering = render(*options.job, session);
  if (is_of_wall_time(options.budget))
    if (std::string load =
            load_warning(rendering.seconds, rendering.processor_seconds, rendering.threads);
        !load.empty())
      rendering.warnings.push_back(std::move(load));
  std::vector<std::string> warnings = scene_warnings(document, options.scene);
  rendering.warnings.insert(rendering.warnings.begin(), warnings.begin(), warnings.end());
  return rendering;
}

ExitCode render_scene(const RenderOptions& options, const Global& global) {
  const SceneDocument& document = *options.document;
  say_scene(options);
  std::optional<OutputDirectory> directory;
  if (!global.out.empty()) directory.emplace(global.out, global);

  const RunRecord run{rendering_of(document, options, global),
                      provenance_of(document, global.command_line)};

  if (directory) {
    write_run(run, options.job->scene(), directory->path());
    spdlog::debug("wrote film.exr, film.csv and run.json");
  }
  if (!global.quiet) {
    print_note(summary_of(run.rendering));
    if (directory) print_note(fmt::format("  saved in        {}\n", directory->path().string()));
  }
  for (const std::string& warning : run.rendering.warnings) spdlog::warn("{}", warning);
  if (global.json) print_json(to_json(run));
  return run.rendering.complete ? ExitCode::ok : ExitCode::interrupted;
}

std::string methods_help() {
  std::string text = "Methods:\n";
  for (const Method& method : methods())
    text += fmt::format("  {:<9} {}\n", method.name, method.summary);
  return text;
}

constexpr const char* details = R"(
A budget is a number of samples (2000000, 300k, 5M), wall time (1500ms, 30s, 5min, 2h), processor
time (30cpu-s), of all threads together, which other work on the machine does not use up, or the
relative error of the film, sqrt(sum of se^2 / sum of value^2), at which to stop ('error<0.01', or
'error<1%').
The same seed and number of samples, or error, give the same film, whatever the number of threads.

DIR receives film.exr, film.csv and run.json.  Ctrl-C saves what was computed so far.

Example:
  wander render scene.json -m bdpt -b 1M -o run
)";

}  // namespace

void add_render(CLI::App& app, Global& global) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* verb = app.add_subcommand("render", "estimate the film of a scene with one method");
  verb->add_option("SCENE", options->scene, scene_help)->type_name("")->required();
  verb->add_option_function<std::string>(
          "-m,--method",
          [options](const std::string& text) { options->method = &find_method(text); },
          "how to estimate: see below")
      ->type_name("METHOD")
      ->required();
  verb->add_option_function<std::string>(
          "-b,--budget",
          [options](const std::string& text) { options->budget = parse_budget(text); },
          "how much to compute (default: 5s)")
      ->type_name("BUDGET");
  add_dial_options(*verb, options->given);
  add_global_options(*verb, global);
  verb->footer("\n" + methods_help() + details);
  examine_with(*verb, global, [options, &global](Examination& examination) {
    examine(*options, global, examination);
  });
  verb->callback([options, &global] {
    global.job = [options, &global] { return render_scene(*options, global); };
  });
}

}  // namespace wander

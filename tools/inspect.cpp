// `wander inspect`: what a scene requires, or what a run, a trajectory or a comparison holds.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "lab/compare/comparison_json.h"
#include "lab/failure.h"
#include "lab/probe.h"
#include "lab/scene_source.h"
#include "records/exr.h"
#include "records/run_json.h"
#include "records/trajectory_netcdf.h"
#include "statistics/number_text.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/inspection.h"
#include "tools/output_place.h"
#include "tools/verb.h"

namespace wander {

namespace {

struct InspectOptions {
  std::string file, reference;
};

// Of a picture over the plane, such as of fluence.
void add_window(const InspectOptions& options, nlohmann::ordered_json& document,
                std::string& text) {
  if (std::filesystem::path(options.file).extension() != ".exr") return;
  const std::optional<PlaneWindow> window = read_window(options.file);
  if (!window) return;
  document["window"] = {{"low", window->low}, {"high", window->high}};
  text += fmt::format("  window          ({}, {}) to ({}, {}) m\n", number_text(window->low[0], 6),
                      number_text(window->low[1], 6), number_text(window->high[0], 6),
                      number_text(window->high[1], 6));
}

ExitCode show_run(const RunRecord& run, const InspectOptions& options, const Global& global) {
  nlohmann::ordered_json document = inspect_run(run);
  std::string text = text_of_run(run);
  add_window(options, document, text);
  if (!options.reference.empty()) {
    document["comparison"] = compare_runs(run, read_run(options.reference));
    text += text_of_comparison(document["comparison"]);
  }
  if (global.json)
    print_json(document);
  else
    print_data(text);
  return ExitCode::ok;
}

ExitCode show_trajectory(const TrajectoryRecord& record, const Global& global) {
  if (global.json)
    print_json(inspect_trajectory(record));
  else
    print_data(text_of_trajectory(record));
  return ExitCode::ok;
}

ExitCode show_comparison(const compare::Comparison& comparison, const Global& global) {
  if (global.json)
    print_json(inspect_comparison(comparison));
  else
    print_data(text_of_comparison(comparison));
  return ExitCode::ok;
}

ExitCode show_scene(SceneDocument scene, const InspectOptions& options, const Global& global) {
  const Probe found = probe(scene.scene);
  scene.warnings.insert(scene.warnings.end(), found.warnings.begin(), found.warnings.end());
  const nlohmann::ordered_json document = inspect_scene(scene, found);
  for (const std::string& warning : scene_warnings(scene, options.file))
    spdlog::warn("{}", warning);
  if (global.json)
    print_json(document);
  else
    print_data(text_of_scene(document));
  return ExitCode::ok;
}

ExitCode inspect(const InspectOptions& options, const Global& global) {
  if (!global.out.empty())
    throw UsageError("inspect writes no files; it prints, with --json one document");
  const bool is_a_scene = is_scene(options.file);
  const std::optional<RunRecord> run = is_a_scene ? std::nullopt : find_run(options.file);
  if (run) return show_run(*run, options, global);
  if (!options.reference.empty())
    throw UsageError("--reference compares two runs, and " + options.file + " is not a run");
  if (!is_a_scene)
    if (const auto comparison = compare::find_comparison(options.file))
      return show_comparison(*comparison, global);
  if (!is_a_scene) require_no_directory(options.file);
  if (!is_a_scene)
    if (const auto trajectory = find_trajectory(options.file))
      return show_trajectory(*trajectory, global);
  return show_scene(open_scene(options.file), options, global);
}

}  // namespace

void add_inspect(CLI::App& app, Global& global) {
  auto options = std::make_shared<InspectOptions>();
  Command verb = add_verb(
      app, "inspect", "say what a scene requires, or what a run, trajectory or comparison holds");
  verb.add_option("FILE", options->file,
                  "a scene file, gallery:NAME, - (a scene from standard input), a run.json or "
                  "compare.json, its directory, a film.exr or film.nc, or a "
                  "trajectory")
      .type_name("")
      .required();
  verb.add_option("--reference", options->reference, "hold the run against this one")
      .type_name("RUN");
  add_global_options(verb, global);
  verb.footer(
      "\nExamples:\n  wander inspect scene.json --json\n"
      "  wander inspect run --reference reference/run.json\n"
      "  wander inspect chains.nc\n"
      "  wander inspect comparison");
  verb.callback([options, &global] {
    global.job = [options, &global] { return inspect(*options, global); };
  });
}

}  // namespace wander

// `wander merge`: runs of one scene and method with different seeds, pooled into one.
#include "lab/merge.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "draw/report/comparison_files.h"
#include "lab/failure.h"
#include "lab/scene_source.h"
#include "records/run_files.h"
#include "records/run_json.h"
#include "tools/command.h"
#include "tools/console.h"
#include "tools/output_place.h"
#include "tools/summary.h"
#include "tools/verb.h"

namespace wander {

namespace {

namespace fs = std::filesystem;

struct MergeTask {
  std::vector<std::string> directories;
  std::vector<MergePart> parts;
  std::string scene;  // where it is now; empty: where it was
};

// Words that were misread are not taken for directories.
void examine(MergeTask& task, const Global& global, Examination& examination) {
  const bool words_are_known = examination.is_passed();
  examination.part([&] {
    if (global.out.empty() && !global.json)
      throw UsageError("merge needs -o DIR (where the merged run goes), or --json, or both");
    if (global.out.empty()) return;
    require_apart(global.out, task.directories);
    require_replaceable_directory(global.out, global);
  });
  if (!words_are_known) return;
  for (const std::string& directory : task.directories)
    examination.part([&] { task.parts.push_back(read_part(directory)); });
  if (!task.parts.empty()) examination.part([&] { require_mergeable(task.parts); });
}

ExitCode merge_runs(const MergeTask& task, const Global& global) {
  std::optional<OutputDirectory> directory;
  if (!global.out.empty()) {
    directory.emplace(global.out, global);
    require_file(checkpoint_in(directory->path()));
  }
  const Checkpoint& first = task.parts.front().run;
  const SceneDocument document = reopened(first.scene, task.scene);
  const Job job(document.scene, find_method(first.method), first.turned());
  Session session;
  session.threads = global.threads;
  RunRecord run{merge(job, task.parts, session), provenance_of(document, global.command_line)};
  const std::vector<std::string> doubts =
      scene_warnings(document, task.scene.empty() ? first.scene.source : task.scene);
  run.rendering.warnings.insert(run.rendering.warnings.begin(), doubts.begin(), doubts.end());
  if (directory) {
    write_run(run, job.scene(), directory->path());
    remove_file(checkpoint_in(directory->path()));
    compare::remove_comparison(directory->path());
  }
  if (!global.quiet) {
    print_note(summary_of(run.rendering));
    if (directory) print_note(fmt::format("  saved in        {}\n", directory->path().string()));
  }
  for (const std::string& warning : run.rendering.warnings) spdlog::warn("{}", warning);
  if (global.json) print_json(to_json(run));
  return ExitCode::ok;
}

constexpr const char* merge_details = R"(
A DIR is that of a run, finished or interrupted, with the file `checkpoint` that `wander render` keeps
there.  What comes out is one run of all their samples: film, error bars, normalization, statistics
and diagnostics are made of all groups of chains, or of all samples, together; in which order the
runs are named makes no difference.  Scene, method and dials must be the same, seeds different;
budgets may differ.

`seconds` are those of all runs together.  A part that was interrupted makes the whole incomplete.

Examples:
  wander render scene.json -m mlt -b 10M -s 1 -o run-1
  wander render scene.json -m mlt -b 10M -s 2 -o run-2
  wander merge run-1 run-2 -o both
)";

}  // namespace

void add_merge(CLI::App& app, Global& global) {
  auto task = std::make_shared<MergeTask>();
  Command verb = add_verb(app, "merge", "pool runs of one scene and method with different seeds");
  verb.add_option("DIR", task->directories, "directories of runs, as `wander render` makes them")
      .type_name("")
      .required();
  verb.add_option("--scene", task->scene,
                  "the scene where it is now, if meshes and textures that it names have moved")
      .type_name("FILE");
  add_global_options(verb, global);
  verb.footer(merge_details);
  examine_with(verb, global,
               [task, &global](Examination& examination) { examine(*task, global, examination); });
  verb.callback(
      [task, &global] { global.job = [task, &global] { return merge_runs(*task, global); }; });
}

}  // namespace wander

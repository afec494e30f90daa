#include "tools/compare_task.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "lab/failure.h"
#include "lab/scene_source.h"
#include "tools/examined_job.h"
#include "tools/output_place.h"

namespace wander {

namespace compare {

namespace {

constexpr const char* usual_methods = "bdpt,mlt";
constexpr const char* usual_budgets = "0.25s,1s,4s";
constexpr const char* usual_reference = "auto";
constexpr std::size_t usual_replicates = 8;

// `max_vertices` is that of the scene, once it is read.
std::vector<Entrant> entrants_of(const Request& request, std::optional<int> max_vertices) {
  std::vector<Setting> fixed;
  std::vector<Sweep> sweeps;
  for (const std::string& text : request.fixed) fixed.push_back(parse_setting(text));
  for (const std::string& text : request.sweeps) sweeps.push_back(parse_sweep(text));
  return line_up(parse_methods(request.methods), fixed, sweeps, max_vertices);
}

Plan plan_of(const Request& request, const Global& global) {
  Plan plan{.source = request.scene.source,
            .entrants = entrants_of(request, std::nullopt),
            .budgets = parse_budgets(request.budgets),
            .replicates = request.replicates,
            .seed = request.seed,
            .threads = global.threads};
  require_few_enough(plan);
  return plan;
}

// Paths are as long as the scene says, or the base point.
SceneDocument with_paths_of(const Plan& plan, SceneDocument document) {
  const Dials& base = plan.entrants.front().dials;
  document.scene.max_vertices = base.max_vertices.value_or(document.scene.max_vertices);
  return document;
}

// Gives every contender its job.
void examine_jobs(const Request& request, CompareTask& task, Examination& examination) {
  task.plan.entrants = entrants_of(request, task.document.scene.max_vertices);
  for (Entrant& entrant : task.plan.entrants)
    entrant.job = examined_job(task.document.scene, *entrant.method, entrant.dials, examination);
}

UsageError no_place() {
  return UsageError("compare needs -o DIR (where the tables go), or --json, or both");
}

// A run may be named by its directory or by a file in it.
void require_reference_apart(const std::filesystem::path& out, const std::string& reference) {
  const std::filesystem::path file(reference);
  require_apart(out, std::array{reference, file.parent_path().string()});
}

// ---- from the beginning

std::optional<CompareTask> examine_new(const CompareOptions& options, const Global& global,
                                       Examination& examination) {
  examination.part([&] {
    if (global.out.empty() && !global.json) throw no_place();
    if (global.out.empty()) return;
    require_replaceable_directory(
        global.out, global, "add --force to replace it, or --continue to carry the comparison on");
    if (options.reference) require_reference_apart(global.out, *options.reference);
  });
  Request request{.scene = {.source = options.scene},
                  .methods = options.methods.value_or(usual_methods),
                  .budgets = options.budgets.value_or(usual_budgets),
                  .reference = options.reference.value_or(usual_reference),
                  .fixed = options.fixed,
                  .sweeps = options.sweeps,
                  .seed = global.seed,
                  .replicates = options.replicates.value_or(usual_replicates),
                  .target = options.target.value_or(not_known)};
  std::optional<Plan> plan;
  examination.part([&] { plan = plan_of(request, global); });
  if (options.scene.empty()) {
    examination.part([] { throw UsageError("SCENE is required; see `wander compare --help`"); });
    return {};
  }
  std::optional<SceneDocument> document;
  // Faults of the scene are told even where nothing is known of the contenders.
  examination.part(
      [&] { document = options.document ? options.document : open_scene(options.scene); });
  if (!plan || !document) return {};
  request.scene = kept_scene(*document, options.scene);
  CompareTask task{
      std::move(request), {}, with_paths_of(*plan, *std::move(document)), *std::move(plan)};
  examine_jobs(task.request, task, examination);
  return task;
}

// ---- carried on

// What the command line asks for and the comparison is not, in words.
std::vector<std::string> differences(const CompareOptions& options, const Request& kept,
                                     const SceneDocument* scene) {
  std::vector<std::string> found;
  const auto differ = [&](std::string_view what, std::string_view has, std::string_view asked) {
    found.push_back(fmt::format("{} {}, not {}", what, has, asked));
  };
  const auto dials = [](const std::vector<std::string>& texts) {
    return texts.empty() ? std::string("none") : fmt::format("{}", fmt::join(texts, " "));
  };
  if (scene)
    if (const auto other = difference(kept.scene, kept_scene(*scene, options.scene)))
      found.push_back("its " + *other);
  if (options.methods && parse_methods(*options.methods) != parse_methods(kept.methods))
    differ("its methods are", kept.methods, *options.methods);
  if (options.budgets &&
      !are_the_same(parse_budgets(*options.budgets), parse_budgets(kept.budgets)))
    differ("its budgets are", kept.budgets, *options.budgets);
  if (options.reference && *options.reference != kept.reference)
    differ("its --reference is", kept.reference, *options.reference);
  if (options.seed && *options.seed != kept.seed)
    differ("its seed is", std::to_string(kept.seed), std::to_string(*options.seed));
  if (!options.fixed.empty() && options.fixed != kept.fixed)
    differ("its --dial is", dials(kept.fixed), dials(options.fixed));
  if (!options.sweeps.empty() && options.sweeps != kept.sweeps)
    differ("its --sweep is", dials(kept.sweeps), dials(options.sweeps));
  return found;
}

CompareTask continued(const CompareOptions& options, const Global& global,
                      Examination& examination) {
  KeptComparison kept = KeptComparison::in(global.out);
  std::optional<SceneDocument> scene;
  if (!options.scene.empty()) scene = open_scene(options.scene);
  Request request = kept.request();
  if (const auto found = differences(options, request, scene ? &*scene : nullptr); !found.empty())
    throw UsageError(
        fmt::format("the comparison in {} is another: {}; leave these out to carry it on, or "
                    "choose another place for a new one",
                    global.out.string(), fmt::join(found, "; ")));
  const std::size_t replicates = options.replicates.value_or(request.replicates);
  if (replicates < request.replicates)
    throw UsageError(
        fmt::format("the comparison in {} is of {} replicates, and --replicates {} are fewer; it "
                    "can only become larger",
                    global.out.string(), request.replicates, replicates));
  request.replicates = replicates;
  request.target = options.target.value_or(request.target);
  Plan plan = plan_of(request, global);
  if (!scene) scene = reopened(request.scene);
  CompareTask task{std::move(request), std::move(kept), with_paths_of(plan, *std::move(scene)),
                   std::move(plan)};
  examine_jobs(task.request, task, examination);
  return task;
}

std::optional<CompareTask> examine_continued(const CompareOptions& options, const Global& global,
                                             Examination& examination) {
  std::optional<CompareTask> task;
  examination.part([&] {
    require_place_of("comparison", global);
    task = continued(options, global, examination);
  });
  return task;
}

}  // namespace

}  // namespace compare

std::optional<CompareTask> examine_compare(const CompareOptions& options, const Global& global,
                                           Examination& examination) {
  using namespace compare;
  return options.is_continuation ? examine_continued(options, global, examination)
                                 : examine_new(options, global, examination);
}

}  // namespace wander

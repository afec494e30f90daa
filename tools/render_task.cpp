#include "tools/render_task.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <limits>

#include "core/film_statistics.h"
#include "lab/failure.h"
#include "lab/merge.h"
#include "lab/onward.h"
#include "lab/parsing.h"
#include "lab/scene_source.h"
#include "records/run_json.h"
#include "tools/examined_job.h"
#include "tools/output_place.h"

namespace wander {

namespace {

constexpr const char* usual_budget = "5s";
constexpr const char* anew =
    "compute the run anew: `wander render SCENE -m METHOD --force`, without --continue";

std::map<std::string, std::string> texts_of(const DialOptions& given) {
  std::map<std::string, std::string> texts;
  for (const auto& [dial, text] : given.turned) texts[std::string(dial->word)] = text;
  return texts;
}

void say(const Job& job, const std::string& digest) {
  const description::Scene& scene = job.scene();
  spdlog::debug("{} shapes, {} materials, at most {} vertices, sha256 {}", scene.shapes.size(),
                scene.materials.size(), scene.max_vertices, digest);
}

UsageError missing(std::string_view what) {
  return UsageError(fmt::format("{} is required; see `wander render --help`", what));
}

// ---- from the beginning

std::optional<RenderTask> examine_new(const RenderOptions& options, const Global& global,
                                      Examination& examination) {
  examination.part([&] {
    if (global.out.empty() && !global.json)
      throw UsageError("render needs -o DIR (where the film goes), or --json, or both");
    if (!global.out.empty())
      require_replaceable_directory(global.out, global,
                                    "add --force to replace it, or --continue to carry the run on");
  });
  if (options.method) examination.part([&] { options.given->require_for(*options.method); });
  if (!options.names_method) examination.part([] { throw missing("--method"); });
  if (options.scene.empty()) examination.part([] { throw missing("SCENE"); });
  if (options.scene.empty()) return {};
  std::optional<SceneDocument> document;
  examination.part([&] { document = open_scene(options.scene); });
  if (!document || !options.method) return {};
  std::optional<Job> job =
      examined_job(document->scene, *options.method, options.given->dials, examination);
  if (!job || !examination.is_passed()) return {};
  say(*job, document->digest.text);
  const std::string budget = options.budget.empty() ? usual_budget : options.budget;
  return RenderTask{.run = {.scene = kept_scene(*document, options.scene),
                            .method = std::string(options.method->name),
                            .budget = budget,
                            .dials = texts_of(*options.given),
                            .seed = global.seed,
                            .run = {}},
                    .document = *document,
                    .job = *std::move(job),
                    .budget = parse_budget(budget)};
}

// ---- carried on

// What the command line asks for and the run is not, in words.
std::vector<std::string> differences(const RenderOptions& options, const Checkpoint& run,
                                     const SceneDocument* scene) {
  std::vector<std::string> found;
  const auto differ = [&](std::string_view what, std::string_view has, std::string_view asked) {
    found.push_back(fmt::format("its {} is {}, not {}", what, has, asked));
  };
  if (scene)
    if (const auto other = difference(run.scene, kept_scene(*scene, options.scene)))
      found.push_back("its " + *other);
  if (options.method && options.method->name != run.method)
    differ("method", run.method, options.method->name);
  if (options.seed && *options.seed != run.seed)
    differ("seed", std::to_string(run.seed), std::to_string(*options.seed));
  for (const auto& [dial, text] : options.given->turned) {
    Dials turned = run.turned();
    dial->set(turned, text);
    if (turned == run.turned()) continue;
    const auto had = run.dials.find(std::string(dial->word));
    differ(dial->option(), had == run.dials.end() ? "the usual one" : had->second, text);
  }
  return found;
}

void require_not_beyond(const Checkpoint& run, const Budget& budget, const std::string& text) {
  const auto* count = std::get_if<SampleBudget>(&budget);
  if (count && count->samples < run.run.headway.samples)
    throw UsageError(fmt::format(
        "the run has {} samples already, more than the budget {}, which counts all of the run",
        run.run.headway.samples, text));
}

void require_not_merged(const std::filesystem::path& directory) {
  if (is_merged(directory))
    throw UsageError(
        fmt::format("{} holds merged runs, which do not go on together: carry them on one by one, "
                    "and merge them again with --force",
                    directory.string()));
}

double error_of_film_in(const std::filesystem::path& directory) {
  const auto run = find_run(directory);
  return run ? relative_error(run->rendering.film) : not_known;
}

// To another budget than that of the run.
void aim_further(RenderTask& task, const std::string& text,
                 const std::filesystem::path& directory) {
  Checkpoint& run = task.run;
  const auto error = [&] { return error_of_film_in(directory); };
  const Headway& done = run.run.headway;
  switch (onward(parse_budget(run.budget), task.budget, done, error, task.job)) {
    case Onward::as_planned:
      return;
    case Onward::enough:
      task.budget = SampleBudget{done.samples};
      task.has_enough = true;
      return;
    case Onward::begun_again:
      task.samples_before = done.samples;
      run.run = {};
      break;
    case Onward::further:
      break;
  }
  task.is_new_budget = true;
  run.budget = text;
}

// The last checkpoint of a run may not have been written, where a disk was full: then its film is ahead of it, and stays where
// it is until there is as much again.
std::uint64_t samples_ahead_of(const Checkpoint& run, const Budget& budget,
                               const std::filesystem::path& directory) {
  const auto film = find_run_alone(directory);
  if (!film || !film->rendering.complete || film->rendering.samples <= run.run.headway.samples)
    return 0;
  const std::uint64_t samples = film->rendering.samples;
  const auto* count = std::get_if<SampleBudget>(&budget);
  if (count && count->samples < samples)
    throw UsageError(fmt::format(
        "{} holds a film of {} samples and a checkpoint of {}, which is to be carried on "
        "to {} only; give a budget of no fewer samples than the film has (-b {})",
        directory.string(), samples, run.run.headway.samples, count->samples, samples));
  return samples;
}

RenderTask continued(const RenderOptions& options, const Global& global) {
  require_not_merged(global.out);
  Checkpoint run = read_checkpoint(global.out, anew);
  std::optional<SceneDocument> scene;
  if (!options.scene.empty()) scene = open_scene(options.scene);
  if (const auto found = differences(options, run, scene ? &*scene : nullptr); !found.empty())
    throw UsageError(
        fmt::format("the run in {} is another: {}; leave these out to carry it on, or choose "
                    "another place for a new run",
                    global.out.string(), fmt::join(found, "; ")));
  const bool is_new_budget =
      !options.budget.empty() && parse_budget(options.budget) != parse_budget(run.budget);
  const std::string text = is_new_budget ? options.budget : run.budget;
  require_not_beyond(run, parse_budget(text), text);
  if (!scene) scene = reopened(run.scene);
  Job job(scene->scene, find_method(run.method), run.turned());
  say(job, scene->digest.text);
  RenderTask task{std::move(run), *std::move(scene), std::move(job), parse_budget(text)};
  task.samples_in_place = samples_ahead_of(task.run, task.budget, global.out);
  if (is_new_budget) aim_further(task, text, global.out);
  return task;
}

std::optional<RenderTask> examine_continued(const RenderOptions& options, const Global& global,
                                            Examination& examination) {
  std::optional<RenderTask> task;
  examination.part([&] {
    require_place_of("run", global);
    task = continued(options, global);
  });
  return task;
}

}  // namespace

namespace {

// Of the scene, whichever way it was named.
void examine_exposure(const RenderOptions& options, const Global& global, const RenderTask& task,
                      Examination& examination) {
  if (!options.exposure) return;
  examination.part([&] {
    if (task.job.scene().dimension == 2)
      throw UsageError(
          "--exposure is for film.png, the picture of a three-dimensional scene; the film of this "
          "scene is a row of bins");
    if (global.out.empty())
      throw UsageError("--exposure is for film.png, which goes to -o DIR; say where");
  });
}

}  // namespace

std::optional<RenderTask> examine_render(const RenderOptions& options, const Global& global,
                                         Examination& examination) {
  std::optional<RenderTask> task = options.is_continuation
                                       ? examine_continued(options, global, examination)
                                       : examine_new(options, global, examination);
  if (task) examine_exposure(options, global, *task, examination);
  return task;
}

Keeper keeper_for(const RenderOptions& options, const Budget& budget) {
  constexpr double usual = 60, long_run = 120, never = std::numeric_limits<double>::infinity();
  if (options.checkpoint) return {{}, *options.checkpoint, *options.checkpoint};
  if (!is_of_wall_time(budget)) return {{}, long_run, usual};
  return {{}, std::get<TimeBudget>(budget).seconds > long_run ? usual : never, usual};
}

}  // namespace wander

#include "tools/compare_runs.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "lab/compare/long_reference.h"
#include "lab/compare/reference.h"
#include "lab/failure.h"
#include "lab/load_warning.h"
#include "lab/reference_doubts.h"
#include "lab/scene_source.h"

namespace wander::compare {

namespace {

namespace fs = std::filesystem;

// What is known before anything is sampled.
std::optional<Reference> known_reference(const SceneDocument& document, const std::string& wanted,
                                         const Provenance& provenance,
                                         std::vector<std::string>& warnings) {
  if (wanted != "auto") return reference_from_file(wanted, document.scene, provenance, warnings);
  std::string why;
  auto exact = exact_reference(document.scene, why);
  if (exact)
    exact->max_vertices = document.scene.max_vertices;
  else
    spdlog::debug("no exact film: {}", why);
  return exact;
}

// The warnings of the methods, each said once, and what is doubtful.
void collect_warnings(Runs& runs) {
  for (std::size_t c = 0; c < runs.contenders.size(); ++c)
    for (const std::string& warning : runs.details[c].warnings)
      runs.warnings.push_back(fmt::format("{}: {}", runs.contenders[c].label, warning));
  const auto is_of_reference = [&](const compare::Run& run) {
    return std::ranges::find(runs.reference.seeds, run.seed) != runs.reference.seeds.end();
  };
  if (const auto run = std::ranges::find_if(runs.runs, is_of_reference); run != runs.runs.end())
    runs.warnings.push_back(fmt::format("{} with seed {} and the reference: {}",
                                        runs.contenders[run->contender].label, run->seed,
                                        doubt_of_one_seed));
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

// Of what is still to come.
double effort_of_all(const CompareTask& task, const std::vector<Turn>& turns) {
  const Plan& plan = task.plan;
  const bool needs_reference = !task.kept.reference();
  return effort_of(plan, turns) + (turns.empty() ? 0 : effort_of_paces(plan)) +
         (needs_reference ? trial_effort(plan) + reference_effort(plan) : 0);
}

// Kept if it was not interrupted; else its long runs are there for the next time (ReferenceCache).
void sample_reference(CompareTask& task, LongPlan long_plan, const ReferenceCache& cache,
                      Course& course, Runs& runs) {
  runs.reference = make_reference(task.plan, std::move(long_plan), cache, course,
                                  film_shape(task.document.scene), runs);
  runs.reference.max_vertices = task.document.scene.max_vertices;
  if (runs.complete) task.kept.keep({runs.reference, runs.warnings});
}

// The reference first: what an interruption leaves of the runs can then be measured.
void make_runs(CompareTask& task, const CompareHost& host, Runs& runs) {
  const Plan& plan = task.plan;
  const std::vector<Turn> turns = turns_to_come(plan, task.kept);
  Course course(task.document.scene, host.session, effort_of_all(task, turns));
  const Paces paces = turns.empty() ? Paces(plan.entrants.size()) : paces_of(plan, course);
  Forecast ahead = forecast(plan, paces, turns);
  LongPlan long_plan;
  const ReferenceCache cache(runs.provenance, task.document.scene.max_vertices);
  const std::optional<KeptReference> reference = task.kept.reference();
  if (!reference) {
    const std::vector<Worth> worths = hold_trial(plan, course);
    long_plan = plan_reference(
        plan, worths, cache.load(film_shape(task.document.scene), runs.warnings), ahead.longest);
    ahead.of_reference = long_plan.seconds;
  }
  course.expect(effort_of(long_plan) + effort_of(plan, turns));
  if (!course.is_interrupted() && !turns.empty()) host.announce(ahead);
  if (reference) {
    runs.reference = reference->reference;
    runs.warnings = reference->warnings;
  } else {
    sample_reference(task, std::move(long_plan), cache, course, runs);
  }
  make_runs(plan, course, task.kept, runs);
}

// What is kept stands in the directory from the first moment, so that the comparison can be carried
// on whenever it ends.
void begin_keeping(CompareTask& task, const CompareOptions& options,
                   const std::optional<fs::path>& directory) {
  if (options.is_continuation)
    task.kept.extend(task.request.replicates, task.request.target);
  else if (directory)
    task.kept = KeptComparison(task.request, *directory);
}

void keep_known_reference(CompareTask& task, const Runs& runs) {
  if (task.kept.reference()) return;
  std::vector<std::string> warnings;
  auto known = known_reference(task.document, task.request.reference, runs.provenance, warnings);
  if (known) task.kept.keep({*std::move(known), std::move(warnings)});
}

}  // namespace

Runs runs_of(CompareTask& task, const CompareOptions& options, const CompareHost& host,
             const std::optional<fs::path>& directory) {
  Runs runs = prepared(task.plan, provenance_of(task.document, host.command_line));
  runs.target = task.request.target;
  begin_keeping(task, options, directory);
  // One that can come to nothing is not kept; one that a full disk ended can go on.
  const auto give_up = [&] {
    if (!options.is_continuation) task.kept.discard();
  };
  try {
    keep_known_reference(task, runs);
    make_runs(task, host, runs);
    require_some(runs);
  } catch (const CommandFailure&) {
    give_up();
    throw;
  } catch (const RunFileError&) {
    give_up();
    throw;
  }
  const std::vector<std::string> doubts = scene_warnings(task.document, task.request.scene.source);
  runs.warnings.insert(runs.warnings.begin(), doubts.begin(), doubts.end());
  collect_warnings(runs);
  warn_of_load(task.plan, runs);
  return runs;
}

}  // namespace wander::compare

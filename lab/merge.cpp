#include "lab/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "lab/engine.h"
#include "lab/failure.h"
#include "records/run_json.h"

namespace wander {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view remedy =
    "compute that run anew (`wander render` keeps a checkpoint unless told --checkpoint 0), or "
    "leave "
    "it out";

// The text of a dial, and what it means: 0.25 is 0.250.
struct Turned {
  std::string text;
  Dials value;
};
Turned turned(const Dial& dial, const Checkpoint& run) {
  const auto found = run.dials.find(std::string(dial.word));
  if (found == run.dials.end()) return {"the usual one", {}};
  Turned turned{found->second, {}};
  dial.set(turned.value, turned.text);
  return turned;
}

std::vector<std::string> differences(const Checkpoint& run, const Checkpoint& first) {
  std::vector<std::string> found;
  const auto differ = [&](std::string_view what, std::string_view has, std::string_view other) {
    found.push_back(fmt::format("its {} is {}, not {}", what, has, other));
  };
  if (const auto other = difference(run.scene, first.scene)) found.push_back("its " + *other);
  if (run.method != first.method) differ("method", run.method, first.method);
  for (const Dial& dial : dials()) {
    const Turned its = turned(dial, run), other = turned(dial, first);
    if (!(its.value == other.value)) differ(dial.option(), its.text, other.text);
  }
  return found;
}

}  // namespace

MergePart read_part(const fs::path& directory) {
  if (is_merged(directory))
    throw UsageError(fmt::format(
        "{} holds runs that were merged already: name those runs themselves, and the others",
        directory.string()));
  MergePart part{.directory = directory, .run = read_checkpoint(directory, remedy)};
  std::string().swap(part.run.run.state);  // and its memory
  const std::uint64_t samples = part.run.run.headway.samples;
  if (samples == 0)
    throw UsageError(fmt::format(
        "{} holds a run without samples, for it was stopped in its beginning, or found no light: "
        "carry it on with `wander render --continue -o {}`",
        directory.string(), directory.string()));
  if (const auto record = find_run_alone(directory)) {
    part.is_complete = record->rendering.complete && record->rendering.samples == samples;
    part.threads = record->rendering.threads;
  }
  return part;
}

void require_mergeable(std::vector<MergePart>& parts) {
  const MergePart& first = parts.front();
  for (const MergePart& part : parts)
    if (const auto found = differences(part.run, first.run); !found.empty())
      throw UsageError(fmt::format(
          "the run in {} cannot be merged with that in {}: {}; merge takes runs that differ in "
          "their seeds alone",
          part.directory.string(), first.directory.string(), fmt::join(found, "; ")));
  std::ranges::stable_sort(parts, {}, [](const MergePart& part) { return part.run.seed; });
  const auto twins =
      std::ranges::adjacent_find(parts, {}, [](const MergePart& part) { return part.run.seed; });
  if (twins != parts.end())
    throw UsageError(fmt::format(
        "the runs in {} and {} have the same seed {}, so they know the same: give each a seed of "
        "its own, `wander render -s SEED`",
        twins->directory.string(), std::next(twins)->directory.string(), twins->run.seed));
}

Rendering merge(const Job& job, std::span<const MergePart> parts, const Session& session) {
  std::vector<StoredRun> runs;
  for (const MergePart& part : parts)
    runs.push_back({part.run.seed,
                    [&part] {
                      Checkpoint now = read_checkpoint(part.directory, remedy);
                      if (now.seed != part.run.seed || now.run.headway != part.run.run.headway)
                        throw RunFileError(fmt::format(
                            "{}: it changed while it was read; wait for the end of the run",
                            checkpoint_in(part.directory).string()));
                      return std::move(now.run.state);
                    },
                    fmt::format("merge {} with the build that computed it, or compute it anew",
                                part.directory.string())});
  Rendering r = merge(job, runs, session);
  r.seed = parts.front().run.seed;
  r.threads = 1;
  r.seconds = r.processor_seconds = r.seed_seconds = 0;
  std::vector<std::string> incomplete;
  for (const MergePart& part : parts) {
    const Headway& headway = part.run.run.headway;
    r.merged.push_back({part.run.seed, headway.samples, headway.wall_seconds, part.is_complete});
    r.seconds += headway.wall_seconds;
    r.processor_seconds += headway.processor_seconds;
    r.seed_seconds += headway.seed_seconds;
    r.threads = std::max(r.threads, part.threads);
    if (!part.is_complete) incomplete.push_back(part.directory.string());
  }
  r.complete = incomplete.empty();
  if (!r.complete)
    r.warnings.push_back(fmt::format("{} of {} runs did not come to the end of their budgets: {}",
                                     incomplete.size(), parts.size(), fmt::join(incomplete, ", ")));
  return r;
}

bool is_merged(const fs::path& directory) {
  std::error_code error;
  if (fs::exists(checkpoint_in(directory), error)) return false;
  try {
    const auto record = find_run_alone(directory);
    return record && !record->rendering.merged.empty();
  } catch (const RunFileError&) {
    return false;
  }
}

}  // namespace wander

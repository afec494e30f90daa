// Runs of one scene and method with different seeds, each kept in a directory, as one run.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "lab/checkpoint.h"
#include "lab/job.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

struct MergePart {
  std::filesystem::path directory;
  Checkpoint run;            // without its state, which is read when its turn comes
  bool is_complete = false;  // it came to the end of its budget
  int threads = 0;           // 0: not known
};

// Throws UsageError if there is no such run, or one that cannot be merged; RunFileError if its files
// are damaged.
MergePart read_part(const std::filesystem::path& directory);

// Puts them in the order of their seeds.  Throws UsageError if they are not all of one scene,
// method and dials, each with a seed of its own.
void require_mergeable(std::vector<MergePart>& parts);

// Of parts that are mergeable, of this job.  Times are sums; it is complete if all of them are.
Rendering merge(const Job& job, std::span<const MergePart> parts, const Session& session);

// Does the directory hold what merge() made, and nothing that could go on?
bool is_merged(const std::filesystem::path& directory);

}  // namespace wander

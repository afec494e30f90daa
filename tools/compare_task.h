// What `compare` is to do: a comparison from the beginning, or one that was kept in a directory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/compare/kept_comparison.h"
#include "lab/compare/make_runs.h"
#include "scenes/format/scene_file.h"
#include "tools/examination.h"
#include "tools/verb.h"

namespace wander {

// As the command line says it; what it does not say is as usual, or that of the comparison.
struct CompareOptions {
  std::string scene;
  std::optional<SceneDocument> document;  // if it was read already
  std::optional<std::string> methods, budgets, reference;
  std::optional<std::size_t> replicates;
  std::optional<double> target;
  std::optional<std::uint64_t> seed;
  std::vector<std::string> fixed, sweeps;
  bool is_continuation = false;
};

struct CompareTask {
  compare::Request request;
  compare::KeptComparison kept;  // that is carried on
  SceneDocument document;
  compare::Plan plan;
};

// All that can be said against it; the task, if nothing can be.
std::optional<CompareTask> examine_compare(const CompareOptions& options, const Global& global,
                                           Examination& examination);

}  // namespace wander

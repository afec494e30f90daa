// What `render` is to do: a run from the beginning, or one that was kept in a directory.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lab/checkpoint.h"
#include "lab/job.h"
#include "scenes/format/scene_file.h"
#include "tools/dial_options.h"
#include "tools/examination.h"
#include "tools/verb.h"

namespace wander {

// As the command line says it.
struct RenderOptions {
  std::string scene;
  const Method* method = nullptr;
  std::string budget;                // empty: the usual one, or that of the run
  std::optional<double> checkpoint;  // seconds; none: what is usual
  std::optional<double> exposure;    // of film.png, in stops
  bool is_continuation = false;
  bool names_method = false;  // perhaps one that is not known
  std::optional<std::uint64_t> seed;
  std::shared_ptr<DialOptions> given = std::make_shared<DialOptions>();
};

struct RenderTask {
  Checkpoint run;  // without a state, if it is from the beginning
  SceneDocument document;
  Job job;
  Budget budget;
  bool has_enough = false;     // the run, of what is asked for
  bool is_new_budget = false;  // another than that of the run that is carried on
  // Of that run, if it is begun again, for what it had planned is no plan for this budget.
  std::optional<std::uint64_t> samples_before{};
  std::uint64_t samples_in_place = 0;  // of a film that is ahead of the checkpoint beside it

  bool is_begun_again() const { return samples_before.has_value(); }
};

// All that can be said against it; the task, if nothing can be.
std::optional<RenderTask> examine_render(const RenderOptions& options, const Global& global,
                                         Examination& examination);

// When such a run is kept, beside its beginning and its end; no keeping if the options say never.
Keeper keeper_for(const RenderOptions& options, const Budget& budget);

}  // namespace wander

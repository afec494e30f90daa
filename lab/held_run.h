// A run that is held in memory, and goes on as often as it is asked: for a caller who looks at what
// has come out, and then wants more.
//
//   HeldRun run(job, session);
//   Rendering some = run.go_on(session);   // to its budget, or until it is interrupted
//   Rendering more = run.go_on(session);   // from there
//
// It has the bits of `wander render` and `wander render --continue`: an interruption changes none.
#pragma once

#include <memory>
#include <optional>

#include "lab/drive.h"
#include "lab/job.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

// A run in one world, with all that it refers to.
class WorldRun {
 public:
  virtual ~WorldRun() = default;
  // The session says when the run began (Session::begun), so that what it has taken of a budget
  // counts; its seed is that of the run.
  virtual Rendering go_on(const Session& session, const Keeper& keeper) = 0;
  // As go_on() left it.
  virtual const Headway& headway() const = 0;
  virtual KeptRun kept() const = 0;
};

class HeldRun {
 public:
  // From where such a run was kept, or from the beginning.  Throws CommandFailure where the run
  // would take more memory than there is, or its state cannot be read.
  HeldRun(const Job& job, const Session& session, const KeptRun& from = {});

  // To the end of the budget, which counts all of the run; what has been interrupted goes on.
  // Throws NoLightFound where chains find nothing to start from, and NothingComputed.
  Rendering go_on(const Session& session, const Keeper& keeper = {});
  KeptRun kept() const { return run_->kept(); }
  const Headway& headway() const { return run_->headway(); }
  const Job& job() const { return *job_; }

 private:
  std::unique_ptr<const Job> job_;  // to which the run refers
  std::optional<Moment> begun_;  // until it went on: that it was built counts in its first budget
  std::unique_ptr<WorldRun> run_;
};

}  // namespace wander

#include "lab/held_run.h"

#include "lab/engine.h"
#include "lab/failure.h"
#include "lab/memory_need.h"

namespace wander {

namespace {

// The process would be killed, or the machine come to a standstill.
void require_memory(const KeptRun& from, const Job& job, const Session& session) {
  MemoryNeed need = memory_need(job, Run(session).threads());
  need.program += static_cast<double>(from.state.size());
  if (const std::string why = why_too_large(job, need, available_memory()); !why.empty())
    throw CommandFailure(ExitCode::failure, why);
}

// So that what was spent counts as spent just now.
Moment begun_before(const Headway& spent, const Clock& clock) {
  Moment begun = clock.now();
  begun.wall -= spent.wall_seconds;
  begun.processor -= spent.processor_seconds;
  return begun;
}

}  // namespace

HeldRun::HeldRun(const Job& job, const Session& session, const KeptRun& from)
    : job_(std::make_unique<const Job>(job)) {
  require_memory(from, job, session);
  begun_ = begun_before(from.headway, *session.clock);
  Session begun = session;
  begun.begun = begun_;
  run_ = engine_of(job).hold(from, *job_, begun);
}

Rendering HeldRun::go_on(const Session& session, const Keeper& keeper) {
  Session begun = session;
  begun.begun = begun_ ? *begun_ : begun_before(run_->headway(), *session.clock);
  begun_.reset();
  Rendering rendering = run_->go_on(begun, keeper);
  rendering.precision = name_of(job_->dials().precision);
  rendering.max_vertices = job_->scene().max_vertices;
  return rendering;
}

}  // namespace wander

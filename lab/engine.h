// What computes a job: the one place where a world is chosen, of those in world_list.h.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "lab/drive.h"
#include "lab/job.h"
#include "mlt/check/kernel_check.h"
#include "mlt/run/chain_settings.h"
#include "records/rendering.h"
#include "work/session.h"

namespace wander {

class WorldRun;       // lab/held_run.h
struct Replay;        // lab/replay.h
struct Trace;         // lab/trace.h
struct TraceRequest;  // lab/trace.h

using KernelChecked = std::function<void(KernelCheck)>;

// A run of some job that is kept somewhere.
struct StoredRun {
  std::uint64_t seed = 1;
  std::function<std::string()> state;  // reads it; not empty
  std::string remedy;                  // ends the message where it cannot be restored
};

// All that one world can do.
struct Engine {
  WorldKind world;
  std::unique_ptr<WorldRun> (*hold)(const KeptRun&, const Job&, const Session&);
  Rendering (*merge)(const Job&, std::span<const StoredRun>, const Session&);
  Trace (*trace)(const Job&, const Session&, const TraceRequest&);
  Replay (*replay)(const Job&, const Session&, int chain, std::uint64_t step);
  void (*check)(const Job&, const InvarianceOptions&, const Run&, const KernelChecked&);
};

std::span<const Engine> engines();
const Engine& engine_of(const Job& job);
// Empty if there is an engine for such a world.
std::string why_no_engine(const WorldKind& world);

// Throws std::runtime_error; NoLightFound where chains find nothing to start from, CommandFailure
// where the run would take more memory than there is.
Rendering render(const Job& job, const Session& session);
// The same, from where a run of this job and seed was kept.  What it has taken of the budget counts.
// Throws CommandFailure where its state cannot be read.
Rendering carry_on(const KeptRun& from, const Job& job, const Session& session,
                   const Keeper& keeper);

// What runs of this job, all of different seeds, found together, in their order.  Throws
// CommandFailure where a state cannot be read.
Rendering merge(const Job& job, std::span<const StoredRun> runs, const Session& session);

// As many chains can be told apart, and traced, as render() runs.
inline constexpr int most_traced_chains = ChainSettings{}.groups * ChainSettings{}.chains_per_group;

// The method is_traced(); the budget of the session is that of the request.  Throws NoLightFound and
// NothingComputed.
Trace trace(const Job& job, const Session& session, const TraceRequest& request);
// The method is_replayed().
Replay replay(const Job& job, const Session& session, int chain, std::uint64_t step);

// Does each mutation of the job leave the target invariant?  Calls done(check) for each, and for
// their mixture.
void check_mutations(const Job& job, const InvarianceOptions& options, const Run& run,
                     const KernelChecked& done);

}  // namespace wander

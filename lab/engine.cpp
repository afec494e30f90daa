#include "lab/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "lab/held_run.h"
#include "lab/replay.h"
#include "lab/trace.h"
#include "lab/worlds.h"

namespace wander {

namespace {

template <World... Ws>
constexpr bool is_in(WorldList<Ws...>, const WorldKind& world) {
  return ((kind_of<Ws> == world) || ...);
}
static_assert(std::ranges::all_of(precisions, [](Precision precision) {
  return is_in(Worlds{}, {2, precision});
}));

}  // namespace

const Engine& engine_of(const Job& job) {
  return *std::ranges::find(engines(), job.world(), &Engine::world);  // Job has seen to it
}

std::string why_no_engine(const WorldKind& world) {
  if (std::ranges::count(engines(), world, &Engine::world) == 1) return {};
  const bool is_left_out = is_in(Worlds{}, world);
  return fmt::format("scenes of {} dimensions{} {} in precision {}{}", world.dimension,
                     world.channels > 1 ? " in colour" : "",
                     is_left_out ? "are left out of this program" : "cannot be computed",
                     name_of(world.precision),
                     is_left_out ? "" : ", which is for the plane; leave --precision out");
}

Rendering render(const Job& job, const Session& session) { return carry_on({}, job, session, {}); }

Rendering carry_on(const KeptRun& from, const Job& job, const Session& session,
                   const Keeper& keeper) {
  return HeldRun(job, session, from).go_on(session, keeper);
}

Rendering merge(const Job& job, std::span<const StoredRun> runs, const Session& session) {
  Rendering rendering = engine_of(job).merge(job, runs, session);
  rendering.precision = name_of(job.dials().precision);
  rendering.max_vertices = job.scene().max_vertices;
  return rendering;
}

Trace trace(const Job& job, const Session& session, const TraceRequest& request) {
  if (!job.method().is_traced())
    throw std::logic_error(fmt::format("{} has no state that is one path", job.method().name));
  return engine_of(job).trace(job, session, request);
}

Replay replay(const Job& job, const Session& session, int chain, std::uint64_t step) {
  if (!job.method().is_replayed())
    throw std::logic_error(fmt::format("{} proposes no step in path space", job.method().name));
  return engine_of(job).replay(job, session, chain, step);
}

void check_mutations(const Job& job, const InvarianceOptions& options, const Run& run,
                     const KernelChecked& done) {
  engine_of(job).check(job, options, run, done);
}

}  // namespace wander

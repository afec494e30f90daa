// The methods of `trace` in one world.
#pragma once

#include <memory>

#include "lab/family/family_of.h"
#include "lab/replay.h"
#include "lab/trace.h"
#include "lab/worlds.h"
#include "mlt/run/mmlt_group.h"
#include "mutations/kelemen.h"
#include "scenes/format/build_scene.h"

namespace wander {

template <World W>
class WorldTracers {
 public:
  WorldTracers(const Job& job, const Session& session)
      : job_(job),
        session_(session),
        scene_(build_scene<W>(job.scene())),
        space_(*scene_, Roulette::off) {}

  Trace trace(const TraceRequest& request) const {
    if (job_.method().state == ChainState::numbers_of_path) {
      const Dials& dials = job_.dials();
      const PrimaryKernel<Kelemen> kernel{Kelemen{}.scaled(dials.family().kernel),
                                          dials.large_step};
      using Chains = MmltChains<Space, Kelemen, ExpectedValues>;
      return Tracer<Space, Chains>(space_, kernel, session_, request, ChainSettings{}).run();
    }
    return Tracer(space_, family_of(job_), session_, request, ChainSettings{}).run();
  }

  Replay replay(int chain, std::uint64_t step) const {
    return wander::replay(space_, family_of(job_), session_, chain, step, ChainSettings{});
  }

 private:
  using Space = Transport<W>;

  const Job& job_;
  const Session& session_;
  std::unique_ptr<const Scene<W>> scene_;
  Space space_;
};

template <World W>
Trace trace_in(const Job& job, const Session& session, const TraceRequest& request) {
  return WorldTracers<W>(job, session).trace(request);
}

template <World W>
Replay replay_in(const Job& job, const Session& session, int chain, std::uint64_t step) {
  return WorldTracers<W>(job, session).replay(chain, step);
}

}  // namespace wander

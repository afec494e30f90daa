// The methods of `trace` in one world; each precision is made in a file of its own
// (world_tracers_float.cpp, world_tracers_double.cpp).
#pragma once

#include "lab/tracers.h"
#include "mlt/primary/primary_estimator.h"
#include "mlt/run/multiplexed_chains.h"
#include "mutations/kelemen.h"
#include "scenes/format/build_scene.h"

namespace wander {

template <World W>
class WorldTracers {
 public:
  WorldTracers(const description::Scene& description, const Dials& dials, const Session& session)
      : description_(description),
        dials_(dials),
        session_(session),
        scene_(build_flatland<W>(description)),
        space_(*scene_, Roulette::off) {}

  Trace trace(std::string_view method, const TraceRequest& request) const {
    if (method == "mmlt") {
      const PrimaryKernel<Kelemen> kernel{Kelemen{}.scaled(dials_.kernel), dials_.large_step};
      using Chains = MultiplexedChains<Space, Kelemen>;
      return Tracer<Space, Chains>(space_, kernel, session_, request, ChainSettings{}).run();
    }
    return Tracer(space_, family(), session_, request, ChainSettings{}).run();
  }

  Replay replay(int chain, std::uint64_t step) const {
    return wander::replay(space_, family(), session_, chain, step, ChainSettings{});
  }

 private:
  using Space = Transport<W>;

  Family family() const { return make_family(dials_.family(), requires_of(description_)); }

  const description::Scene& description_;
  const Dials& dials_;
  const Session& session_;
  std::unique_ptr<const Scene<W>> scene_;
  Space space_;
};

extern template class WorldTracers<FlatlandSingle>;
extern template class WorldTracers<Flatland>;

}  // namespace wander

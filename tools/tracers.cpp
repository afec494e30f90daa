#include "tools/tracers.h"

#include <array>

#include "core/build_scene.h"
#include "mlt/multiplexed_chains.h"
#include "mlt/primary_estimator.h"
#include "mutations/kelemen.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 2> names{"mlt", "mmlt"};

using Flat = Transport<Flatland>;

}  // namespace

std::span<const std::string_view> traced_methods() { return names; }

Trace trace(const description::Scene& description, std::string_view method,
            const MutationWeights& weights, const Session& session, const TraceRequest& request) {
  const auto scene = build_flatland(description);
  const Flat space(*scene, Roulette::off);
  if (method == "mmlt") {
    const PrimaryKernel<Kelemen> kernel{Kelemen{}, default_large_step};
    using Chains = MultiplexedChains<Flat, Kelemen>;
    return Tracer<Flat, Chains>(space, kernel, session, request, ChainSettings{}).run();
  }
  return Tracer(space, make_family(weights, requires_of(description)), session, request,
                ChainSettings{})
      .run();
}

Replay replay(const description::Scene& description, const MutationWeights& weights,
              const Session& session, int chain, std::uint64_t step) {
  const auto scene = build_flatland(description);
  const Flat space(*scene, Roulette::off);
  return replay(space, make_family(weights, requires_of(description)), session, chain, step,
                ChainSettings{});
}

}  // namespace wander

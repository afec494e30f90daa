#include "tools/tracers.h"

#include <array>

#include "core/build_scene.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 1> names{"mlt"};

// Calls f(space, kernel) with what the chains of a method, the only one, walk in and by.
template <class F>
auto with_chains(const description::Scene& description, std::string_view,
                 const MutationWeights& weights, F&& f) {
  const auto scene = build_flatland(description);
  const Transport<Flatland> transport(*scene, Roulette::off);
  return f(
      transport,
      make_family(weights.empty() ? choose_mutations(requires_of(description)).weights : weights,
                  scene->max_vertices()));
}

}  // namespace

std::span<const std::string_view> traced_methods() { return names; }

Trace trace(const description::Scene& scene, std::string_view method,
            const MutationWeights& weights, const Session& session, const TraceRequest& request) {
  return with_chains(scene, method, weights, [&](const auto& space, const auto& kernel) {
    return Tracer(space, kernel, session, request, ChainSettings{}).run();
  });
}

Replay replay(const description::Scene& scene, std::string_view method,
              const MutationWeights& weights, const Session& session, int chain,
              std::uint64_t step) {
  return with_chains(scene, method, weights, [&](const auto& space, const auto& kernel) {
    return replay(space, kernel, session, chain, step, ChainSettings{});
  });
}

}  // namespace wander

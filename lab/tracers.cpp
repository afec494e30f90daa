#include "lab/tracers.h"

#include <array>

#include "lab/world_tracers.h"

namespace wander {

namespace {

constexpr std::array<std::string_view, 2> names{"mlt", "mmlt"};

}  // namespace

std::span<const std::string_view> traced_methods() { return names; }

Trace trace(const description::Scene& scene, std::string_view method, const Dials& dials,
            const Session& session, const TraceRequest& request) {
  require_precision(dials.precision, scene);
  return dials.precision == Precision::of_float
             ? WorldTracers<FlatlandSingle>(scene, dials, session).trace(method, request)
             : WorldTracers<Flatland>(scene, dials, session).trace(method, request);
}

Replay replay(const description::Scene& scene, const Dials& dials, const Session& session,
              int chain, std::uint64_t step) {
  require_precision(dials.precision, scene);
  return dials.precision == Precision::of_float
             ? WorldTracers<FlatlandSingle>(scene, dials, session).replay(chain, step)
             : WorldTracers<Flatland>(scene, dials, session).replay(chain, step);
}

}  // namespace wander

#include "lab/trace_request.h"

#include <fmt/format.h>

#include "lab/failure.h"

namespace wander {

namespace {
constexpr std::uint64_t most_draws = 100'000'000;  // of all chains
}

void require_traced(const Method& method) {
  if (!method.is_traced())
    throw UsageError(fmt::format(
        "trace records Markov chains whose state is one path; {} has none: allowed are {}",
        method.name, in_words(traced_methods())));
}

void require_bounded(const TraceRequest& request) {
  const std::uint64_t draws = request.window.draws();
  if (draws > most_draws / static_cast<std::uint64_t>(request.chains))
    throw UsageError(fmt::format(
        "{} chains of {} draws are more than {} in all; record less with --every or --window",
        request.chains, draws, most_draws));
}

}  // namespace wander

// Running some chains and writing down their steps: a trajectory.
//
//   scene → seed pass → chains × mixture of mutations → steps → logs → columns
//
// The chains are those of render() (shown_chains.h).  Each has its own log, so the columns do not
// depend on the threads.
#pragma once

#include <algorithm>
#include <vector>

#include "lab/shown_chains.h"
#include "lab/trace_request.h"
#include "mlt/run/path_group.h"
#include "mlt/watch/attempt.h"

namespace wander {

struct Trace {
  bool complete = true;  // all draws that were asked for
  Trajectory trajectory;
  Normalization normalization;
  int threads = 1;
  double seconds = 0;       // wall time, seed pass included
  double seed_seconds = 0;  // of which seed pass
};

// `Chains` are the SeededChains of a method whose states are paths.
template <class Space, class Chains>
class Tracer {
 public:
  template <class Kernel>
  Tracer(const Space& space, const Kernel& kernel, const Session& session, TraceRequest request,
         ChainSettings settings)
      : space_(space),
        request_(request),
        run_(session),
        shown_(space, kernel, run_, settings),
        seed_seconds_(run_.seconds()),
        logs_(static_cast<std::size_t>(request.chains)) {
    for (int k = 0; k < request.chains; ++k) chains_.push_back(shown_.chain(k));
  }

  // Throws NothingComputed if it is interrupted before the first draw.
  Trace run() {
    const std::uint64_t end = request_.window.end;
    std::uint64_t done = 0;
    while (done < end && !run_.is_interrupted()) {
      const std::uint64_t next = std::min(end, done + steps_per_round());
      run_parallel(run_, request_.chains, [&](int k) { advance(k, done, next); });
      done = next;
      run_.report({static_cast<double>(done) / static_cast<double>(end),
                   done * static_cast<std::uint64_t>(request_.chains), run_.seconds(), "sampling"});
    }
    Trace trace;
    trace.trajectory =
        make_trajectory(logs_, request_.window, Space::Universe::dimension, Chains::move_names());
    trace.complete = static_cast<std::uint64_t>(trace.trajectory.draws) == request_.window.draws();
    if (trace.trajectory.draws == 0) throw NothingComputed();
    trace.normalization = normalization(shown_.tally());
    trace.threads = run_.threads();
    trace.seconds = run_.seconds();
    trace.seed_seconds = seed_seconds_;
    return trace;
  }

 private:
  using W = typename Space::Universe;
  using Shown = ShownChains<Space, Chains>;

  // Of each chain; long paths make short rounds, for a round reserves memory for the longest.
  std::uint64_t steps_per_round() const {
    return static_cast<std::uint64_t>(std::clamp((1 << 20) / space_.max_vertices(), 1, 1024));
  }

  void advance(int k, std::uint64_t first, std::uint64_t end) {
    typename Shown::Chain& chain = chains_[static_cast<std::size_t>(k)];
    StepLog& log = logs_[static_cast<std::size_t>(k)];
    const TraceWindow& window = request_.window;
    if (end > window.first)
      log.reserve((end - first) / window.every + 1, space_.max_vertices(), W::dimension);
    Attempt attempt;
    const WatchedSpace<Space> watched(space_, attempt);
    Path<W> again(space_.max_vertices());
    const auto record = [&](const Step<W>& step, std::uint64_t i) {
      log.add(space_, step);
      if (!std::holds_alternative<Failure>(step.outcome)) return;
      Rng same = chain.random;
      same.start(i);
      attempt.clear();
      if (chain.chain.propose_again(watched, again, same)) attempt.was_complete();
      log.add(attempt);
    };
    for (std::uint64_t i = first; i < end; ++i)
      chain.step([&](const auto& step) {
        if (window.holds(i))
          record(path_step(step), i);
        else
          log.skip(path_step(step));
      });
  }

  const Space& space_;
  TraceRequest request_;
  Run run_;
  Shown shown_;
  double seed_seconds_;
  std::vector<typename Shown::Chain> chains_;
  std::vector<StepLog> logs_;
};

// Chains of a kernel in path space; others are named by the caller.
template <class Space, class Kernel>
Tracer(const Space&, const Kernel&, const Session&, TraceRequest, ChainSettings)
    -> Tracer<Space, PathChains<Space, Kernel>>;

}  // namespace wander

// Brings a run to the end of its budget: samples, time or error.  Budgets, progress, interruption
// and checkpoints are here, and nowhere else.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "lab/live_run.h"
#include "work/parallel.h"
#include "work/stopping_rule.h"

namespace wander {

// How far a run has come, beside its own state.
struct Headway {
  double wall_seconds = 0, processor_seconds = 0, seed_seconds = 0;
  std::uint64_t samples = 0;
  double target = 0;            // of the last budget that was an error, or 0
  std::uint64_t seed_goal = 0;  // its next looks, at so many samples: of each slice,
  std::uint64_t goal = 0;       // and of the run
  std::vector<Look> looks{};    // those that samples of the seed pass alone could have mended

  bool operator==(const Headway&) const = default;
};

// A run that can be carried on.
struct KeptRun {
  Headway headway;
  std::string state;  // empty: from the beginning
};

// Writes the state of a run, as often as it is called: the state of a large film is never held as a
// whole.
using StateWriter = std::function<void(std::ostream&)>;

// Where runs are kept on their way, and when: after so many seconds, and then every so many.
struct Keeper {
  std::function<void(const Headway&, const StateWriter&)> keep{};  // may be empty
  double first = 0, every = 0;                                     // 0: only at the end
  // Samples of a run that stays in its place until this one has as many, or has come to its end.
  std::uint64_t least = 0;
};

// A small budget makes fewer chains, so that it can be met exactly.
ChainSettings fitted(ChainSettings settings, const Budget& budget);

// Throws NothingComputed where it is interrupted before it is worth its place (Keeper::least).
// `execution` is what the run was made with.  At the end, interrupted or not, the run is kept once
// more, so that it can be carried on with the bits of one that never stopped.
Rendering drive(LiveRun& run, Run& execution, const Headway& begin = {}, const Keeper& keeper = {});

}  // namespace wander

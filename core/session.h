// One run as its caller sees it: how much to compute, with what randomness, and how to watch or end
// it.  Shared by all estimators.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <variant>

namespace wander {

struct SampleBudget {
  std::uint64_t samples;
};
struct TimeBudget {
  double seconds;  // wall time of sampling, seed pass included
};
// Until √(Σ se² / Σ value²) of the film falls below it.
struct ErrorBudget {
  double relative;
};
using Budget = std::variant<SampleBudget, TimeBudget, ErrorBudget>;

struct ProgressReport {
  double fraction = 0;        // of the budget, in [0, 1]
  std::uint64_t samples = 0;  // done so far
  double seconds = 0;         // since the run began
  const char* phase = "";     // "seed pass" or "sampling"
};

struct Session {
  Budget budget = TimeBudget{5};
  std::uint64_t seed = 1;
  int threads = 0;                                 // 0: all cores
  const std::atomic<bool>* interrupted = nullptr;  // set by a signal handler: finish early, save
  std::function<void(const ProgressReport&)>
      report;  // called from one thread at a time; may be empty
};

}  // namespace wander

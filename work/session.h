// One run as its caller sees it: how much to compute, with what randomness, and how to watch or end
// it.  Shared by all estimators.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <variant>

#include "work/clock.h"

namespace wander {

// Budgets are the same however they were written.
struct SampleBudget {
  std::uint64_t samples;

  bool operator==(const SampleBudget&) const = default;
};
// From the building of the scene to the last number: seed pass, chains, error bars and diagnostics
// included.
struct TimeBudget {
  double seconds;
  TimeKind kind = TimeKind::wall;

  bool operator==(const TimeBudget&) const = default;
};
// Until √(Σ se² / Σ value²) of the film falls below it.
struct ErrorBudget {
  double relative;

  bool operator==(const ErrorBudget&) const = default;
};
using Budget = std::variant<SampleBudget, TimeBudget, ErrorBudget>;

inline bool is_of_wall_time(const Budget& budget) {
  const auto* time = std::get_if<TimeBudget>(&budget);
  return time && time->kind == TimeKind::wall;
}
// Of which kind its seconds are; wall time where it has none.
inline TimeKind time_kind_of(const Budget& budget) {
  const auto* time = std::get_if<TimeBudget>(&budget);
  return time ? time->kind : TimeKind::wall;
}

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
  const Clock* clock = &system_clock();
  std::optional<Moment> begun{};  // when the run began; none: when its Run is made
};

}  // namespace wander

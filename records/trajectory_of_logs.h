// From the logs of chains to the columns of a trajectory.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mlt/watch/step_log.h"
#include "records/trajectory.h"

namespace wander {

// Which steps of each chain are written down: first, first + every, … below `end`.
struct TraceWindow {
  std::uint64_t first = 0, end = 1000, every = 1;

  bool holds(std::uint64_t step) const {
    return step >= first && step < end && (step - first) % every == 0;
  }
  std::uint64_t draws() const { return end > first ? (end - first - 1) / every + 1 : 0; }
};

// As many draws as all logs have.  Paths are padded up to the longest that occurs, and classes are
// numbered as they appear, chain by chain.
Trajectory make_trajectory(std::span<const StepLog> chains, const TraceWindow& window,
                           int dimension, std::span<const std::string_view> mutations);

}  // namespace wander

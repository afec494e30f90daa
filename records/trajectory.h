// What was recorded of the steps of some chains: the columns of a trajectory file.  Plain data,
// made by an observer of chains (mlt), written and read beside it, drawn by draw.
//
// A draw is one recorded step.  All columns are laid out [chain][draw] (then [vertex][axis]); what
// is stored of a chain is its state after the decision, and the proposal of the same step beside
// it.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace wander {

// Paths by draw, padded with NaN up to `max_vertices`.
struct RecordedPaths {
  std::vector<double> position;  // [chain][draw][vertex][axis], light first
  std::vector<double> film;      // [chain][draw][axis - 1], in [0,1); NaN where there is no path
  std::vector<std::int32_t> vertices;    // 0: no path
  std::vector<std::int32_t> path_class;  // index into Trajectory::classes; -1: no path
};

// What there is of proposals that failed: lines to be drawn, with NaN between them and after the
// last, and the place where each failed, NaN where there is none.
struct RecordedAttempts {
  int max_points = 0;
  std::vector<double> position;  // [chain][draw][point][axis]
  std::vector<double> failure;   // [chain][draw][axis]
};

struct Trajectory {
  int dimension = 2, max_vertices = 0;
  int chains = 0, draws = 0;
  std::uint64_t first_step = 0, every = 1;  // draw d is step first_step + d * every of its chain

  std::vector<std::string> mutations, reasons;  // what the indices below mean
  std::vector<std::string> classes;             // such as LDSE, in order of first appearance

  RecordedPaths state;        // after the decision
  RecordedPaths proposed;     // also when it was rejected; no path where the proposal failed
  RecordedPaths start;        // before the first draw, by chain; empty: not recorded
  RecordedAttempts attempts;  // empty: not recorded
  std::vector<std::int32_t> mutation, reason;
  std::vector<std::uint8_t> accepted;
  std::vector<double> acceptance;     // a(x→y); 0 where there was no proposal
  std::vector<double> log_f;          // of the state after the decision
  std::vector<double> log_f_current;  // of the state before it
  // NaN where there was no proposal:
  // a = min(1, exp(log_f_proposed + log_reverse - log_f_current - log_forward)).
  std::vector<double> log_f_proposed, log_forward, log_reverse;

  std::size_t size() const {
    return static_cast<std::size_t>(chains) * static_cast<std::size_t>(draws);
  }
};

}  // namespace wander

// Running many units of work in parallel, with results that do not depend on the threads: units are
// merged in their order, whoever computed them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "work/session.h"

namespace wander {

// The clock of one run, its end, and its reports.
class Run {
 public:
  explicit Run(const Session& session);

  double seconds() const { return clock().now().wall - begun_.wall; }
  double processor_seconds() const { return clock().now().processor - begun_.processor; }
  // Of the kind of time that the budget is in; wall time if it is in none.
  double spent() const { return clock().now().of(kind_) - begun_.of(kind_); }
  bool is_interrupted() const { return session_.interrupted && session_.interrupted->load(); }
  // As many as the session asks for, or as can be started.
  int threads() const { return threads_; }
  const Session& session() const { return session_; }
  // At most ten times a second.
  void report(const ProgressReport& progress);

 private:
  const Clock& clock() const { return *session_.clock; }

  const Session& session_;
  int threads_;
  TimeKind kind_;
  Moment begun_;
  double last_report_ = 0;  // in seconds()
};

// Calls work(unit, slot) for unit = 0, 1, … on all threads, and merge(unit, slot) in the order of
// the units, one at a time.  A slot is the memory that one unit works in; there are `slots` of
// them. Ends after `units`, or when more(unit) says no.
struct Units {
  std::uint64_t units;
  std::function<bool(std::uint64_t unit)> more;
  std::function<void(std::uint64_t unit, int slot)> work, merge;
};
int slots_of(const Run& run);
void run_in_order(const Run& run, const Units& units);

// Calls work(i) for i in [0, count) on all threads; each call writes only what is its own.
void run_parallel(const Run& run, int count, const std::function<void(int)>& work);

// The same for parts of what is called by run_within(), which has the threads of the run; outside
// of it, on all cores.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);
void run_within(const Run& run, const std::function<void()>& work);

}  // namespace wander

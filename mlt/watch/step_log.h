// What is written down of the steps of one chain: scalars step by step, and each path once.
// The only observer that looks at a whole step; it fills memory that reserve() made, so that
// writing down a step does not allocate.  trajectory.h makes columns of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "mlt/chain.h"
#include "mlt/watch/attempt.h"

namespace wander {

// A path among the vertices of a log.
struct LoggedPath {
  std::uint64_t first = 0;    // vertex
  std::int32_t vertices = 0;  // 0: no path
  std::array<double, 2> film{no_number, no_number};
  double log_f = no_number;

  static constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
};

// Of a proposal that failed, among the points of a log (attempt.h).
struct LoggedAttempt {
  std::uint64_t first = 0;
  std::int32_t points = 0;  // 0: nothing is known of it
  Attempt::Point failure = Attempt::nowhere;
};

// The terms of a = min(1, f(y) T(y→x) / (f(x) T(x→y))), and the state after the decision.
struct LoggedStep {
  std::int32_t mutation = 0, reason = 0;
  double acceptance = 0;
  double log_f_current = LoggedPath::no_number;
  double log_forward = LoggedPath::no_number, log_reverse = LoggedPath::no_number;
  LoggedPath state, proposed;
  LoggedAttempt attempt;

  bool accepted() const { return reason == static_cast<std::int32_t>(Reason::none); }
};

class StepLog {
 public:
  // Memory for so many steps more.
  void reserve(std::uint64_t steps, int max_vertices, int dimension);

  template <class Space>
  void add(const Space& space, const Step<typename Space::Universe>& step) {
    LoggedStep& logged = steps_.emplace_back();
    logged.mutation = step.mutation;
    logged.reason = static_cast<std::int32_t>(step.reason);
    logged.acceptance = step.acceptance;
    if (state_.vertices == 0) state_ = store(space, step.current);
    if (steps_.size() == 1) start_ = state_;
    logged.log_f_current = state_.log_f;
    if (const Proposal* p = std::get_if<Proposal>(&step.outcome)) {
      logged.log_forward = p->forward.log();
      logged.log_reverse = p->reverse.log();
      logged.proposed = store(space, step.proposed);
    }
    if (step.accepted()) state_ = logged.proposed;
    logged.state = state_;
  }
  // What the step that was added last came to, if its proposal failed.
  void add(const Attempt& attempt) {
    steps_.back().attempt = {attempts_.size(), static_cast<std::int32_t>(attempt.points().size()),
                             attempt.failure()};
    attempts_.insert(attempts_.end(), attempt.points().begin(), attempt.points().end());
  }
  // A step that is not written down.
  template <class W>
  void skip(const Step<W>& step) {
    if (step.accepted()) state_ = {};
  }

  const std::vector<LoggedStep>& steps() const { return steps_; }
  const LoggedPath& start() const { return start_; }  // the state before the first of them
  const std::vector<Attempt::Point>& attempts() const { return attempts_; }
  const std::vector<double>& positions() const { return positions_; }  // [vertex][axis]
  const std::vector<Event>& events() const { return events_; }         // [vertex]

 private:
  template <class Space>
  LoggedPath store(const Space& space, const Path<typename Space::Universe>& x) {
    LoggedPath path;
    path.first = events_.size();
    path.vertices = x.size();
    const auto film = space.film_position(x);
    for (std::size_t k = 0; k < film.size(); ++k) path.film[k] = static_cast<double>(film[k]);
    path.log_f = x.contribution.log();
    for (int i = 0; i < x.size(); ++i) {
      for (int k = 0; k < Space::Universe::dimension; ++k)
        positions_.push_back(static_cast<double>(x[i].place.position[k]));
      events_.push_back(x[i].event);
    }
    return path;
  }

  std::vector<LoggedStep> steps_;
  std::vector<double> positions_;
  std::vector<Event> events_;
  std::vector<Attempt::Point> attempts_;
  LoggedPath state_;  // of the chain, if it is known
  LoggedPath start_;
};

}  // namespace wander

// What is written down of the steps of one chain: scalars step by step, paths one after the other.
// The only observer that looks at a whole step; it fills memory that reserve() made, so that
// writing down a step does not allocate.  trajectory.h makes columns of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "mlt/chain.h"

namespace wander {

struct LoggedStep {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::int32_t mutation = 0, reason = 0;
  std::int32_t state_vertices = 0, proposed_vertices = 0;  // 0: no path was proposed
  std::array<double, 2> state_film{none, none}, proposed_film{none, none};
  double acceptance = 0;
  double log_f = none;  // of the state after the decision
  // The terms of a = min(1, f(y) T(y→x) / (f(x) T(x→y))).
  double log_f_current = none, log_f_proposed = none, log_forward = none, log_reverse = none;

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
    logged.log_f_current = step.current.contribution.log();
    if (const Proposal* p = std::get_if<Proposal>(&step.outcome)) {
      logged.log_f_proposed = step.proposed.contribution.log();
      logged.log_forward = p->forward.log();
      logged.log_reverse = p->reverse.log();
      logged.proposed_vertices = step.proposed.size();
      logged.proposed_film = film_of(space, step.proposed);
      add_vertices(step.proposed);
    }
    const bool moved = step.accepted();
    logged.log_f = moved ? logged.log_f_proposed : logged.log_f_current;
    logged.state_vertices = moved ? logged.proposed_vertices : step.current.size();
    logged.state_film = moved ? logged.proposed_film : film_of(space, step.current);
    if (!moved) add_vertices(step.current);
  }

  const std::vector<LoggedStep>& steps() const { return steps_; }
  // Of the vertices of each step, light first: of the proposed path if there is one, then of the
  // state if it is another path.
  const std::vector<double>& positions() const { return positions_; }  // [vertex][axis]
  const std::vector<Event>& events() const { return events_; }

 private:
  template <class Space>
  static std::array<double, 2> film_of(const Space& space,
                                       const Path<typename Space::Universe>& x) {
    const auto square = space.film(x);
    std::array<double, 2> film{LoggedStep::none, LoggedStep::none};
    for (std::size_t k = 0; k < square.size(); ++k) film[k] = static_cast<double>(square[k]);
    return film;
  }
  template <class W>
  void add_vertices(const Path<W>& x) {
    for (int i = 0; i < x.size(); ++i) {
      for (int k = 0; k < W::dimension; ++k)
        positions_.push_back(static_cast<double>(x[i].place.position[k]));
      events_.push_back(x[i].event);
    }
  }

  std::vector<LoggedStep> steps_;
  std::vector<double> positions_;
  std::vector<Event> events_;
};

}  // namespace wander

// What a step deposits, on one film.
#pragma once

#include "mlt/primary/primary_estimator.h"
#include "mlt/run/deposit.h"

namespace wander::test {

inline auto onto(GroupFilm& film) {
  return [&film](const auto&, int vertices, int bin, double weight, const auto& colour) {
    film.add(vertices, bin, weight, colour);
  };
}

template <class Space>
void deposit(const Space& space, const Step<typename Space::Universe>& step, int current_bin,
             GroupFilm& film) {
  for_each_deposit(space, step, current_bin, onto(film));
}
template <class Sample>
void deposit(const PrimaryStep<Sample>& step, PrimaryDeposit weights, GroupFilm& film) {
  for_each_deposit(step, weights, onto(film));
}

}  // namespace wander::test

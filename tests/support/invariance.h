// The test of invariance (mlt/check/invariance.h) as the tests of mutations call it.
#pragma once

#include "mlt/check/invariance.h"
#include "mlt/mixture.h"
#include "tests/support/statistics.h"

namespace wander::test {

template <class Space, class Kernel>
InvarianceReport test_invariance(const Space& space, const Kernel& kernel,
                                 const InvarianceOptions& options) {
  Session session;
  session.threads = 1;
  const Starts<Space> starts(space, options.seed);
  return InvarianceTest(space, kernel, starts, options).run(Run(session));
}

// The kernel that consists of one mutation.
template <class Mutation>
Mixture<Mutation> alone(Mutation mutation) {
  return Mixture<Mutation>({1}, std::move(mutation));
}

}  // namespace wander::test

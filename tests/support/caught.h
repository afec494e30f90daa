// The positive control of an invariance test: some decision, one that had something to decide,
// shows the flaw of a wrong twin.
#pragma once

#include "tests/support/expect.h"
#include "tests/support/invariance.h"

namespace wander::test {

inline ::testing::AssertionResult caught(const InvarianceReport& report) {
  for (const Decision* decision : {&report.one_step, &report.many_steps, &report.flux})
    if (!decision->passed && decision->detail != nothing_moved)
      return ::testing::AssertionSuccess() << describe(*decision);
  return ::testing::AssertionFailure()
         << "a wrong twin went unnoticed: " << describe(report.one_step) << "; "
         << describe(report.many_steps) << "; " << describe(report.flux);
}

}  // namespace wander::test

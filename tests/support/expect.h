// Decisions as GoogleTest assertions: EXPECT_TRUE(passes(z_test(…))) prints the whole decision when
// it fails, and EXPECT_TRUE(rejects(…)) is the form of a positive control, a wrong twin that the
// test must catch.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/statistics.h"

namespace wander::test {

inline ::testing::AssertionResult passes(const Decision& decision) {
  if (decision.passed) return ::testing::AssertionSuccess() << describe(decision);
  return ::testing::AssertionFailure() << describe(decision);
}

inline ::testing::AssertionResult rejects(const Decision& decision) {
  if (!decision.passed) return ::testing::AssertionSuccess() << describe(decision);
  return ::testing::AssertionFailure() << "a wrong twin went unnoticed: " << describe(decision);
}

}  // namespace wander::test

// Decisions as GoogleTest assertions: EXPECT_TRUE(passes(z_test(…))) prints the whole decision when
// it fails, and EXPECT_TRUE(rejects(…)) is the form of a positive control, a wrong twin that the
// test must catch.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/support/statistics.h"

namespace wander::test {

// Of a test that passes, what it would have seen: in its record, from which tests/power makes
// docs/power.md.
inline void note_power(const Decision& decision) {
  static int count = 0;
  std::ostringstream text;
  text << decision.test << '|' << decision.comparisons << '|' << decision.false_alarm << '|'
       << decision.visible;
  ::testing::Test::RecordProperty("decision_" + std::to_string(++count), text.str());
}

inline ::testing::AssertionResult passes(const Decision& decision) {
  note_power(decision);
  if (decision.passed) return ::testing::AssertionSuccess() << describe(decision);
  return ::testing::AssertionFailure() << describe(decision);
}

inline ::testing::AssertionResult rejects(const Decision& decision) {
  if (!decision.passed) return ::testing::AssertionSuccess() << describe(decision);
  return ::testing::AssertionFailure() << "a wrong twin went unnoticed: " << describe(decision);
}

}  // namespace wander::test

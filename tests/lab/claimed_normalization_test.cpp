// What runs claim of b, three ways, of the light of each length, and of films that are
// merged of several runs, is what hundreds of small runs vary by: from both sides.
//
// False alarms: 1e-9 for all that runs claim, beyond the tolerance, by the normal law of the jackknife.  What
// they see: docs/power.md; the long test sees a quarter of a variance, of 2000 runs a third.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/expect.h"
#include "tests/support/small_runs.h"

namespace wander::test {
namespace {

constexpr double tolerance_of_hundreds = 0.03;

// Control: of errors that are a third too short each is caught alone.
void expect_true_and_short_ones_caught(const SmallRuns& c) {
  const Claims claims = claims_of(c);
  const Decision decision = claims_test(claims, tolerance_of_hundreds, usual_false_alarm);
  EXPECT_TRUE(passes(decision));
  std::cout << "  " << c << ": " << decision.detail << '\n';
  for (const auto& claim : scaled_errors(claims, 2.0 / 3))
    EXPECT_TRUE(rejects(claims_test({claim}, tolerance_of_hundreds, usual_false_alarm)))
        << claim.first;
}

TEST(ClaimsOfSmallRuns, OfTheNormalizationAreTrue) {
  expect_true_and_short_ones_caught({"article-1", "mlt", 3200, 1024, 200});
}
TEST(ClaimsOfSmallRuns, OfMergedFilmsAreTrue) {
  expect_true_and_short_ones_caught({"article-1", "pt", 1000, 0, 300, 2});
}

}  // namespace
}  // namespace wander::test

// As claimed_normalization_test.cpp, of every method that has chains and of thousands of runs: errors that are
// a seventh too short are seen of each estimate alone (of independent samples a tenth, of the runs of which
// there are fewer a fifth).  What least squares claims where it counts products twice, 7 % too much, is not.
// False alarms: 1e-9 for all that the runs of a method claim, beyond the tolerance.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/support/expect.h"
#include "tests/support/small_runs.h"

namespace wander::test {
namespace {

constexpr double tolerance_of_many = 0.03;

struct ManySmallRuns {
  SmallRuns runs;
  double too_short;  // a factor of errors that is seen
};
std::ostream& operator<<(std::ostream& out, const ManySmallRuns& c) { return out << c.runs; }

class ClaimsOfManyRuns : public ::testing::TestWithParam<ManySmallRuns> {};

TEST_P(ClaimsOfManyRuns, AreTrue) {
  const auto& [runs, too_short] = GetParam();
  const Claims claims = claims_of(runs);
  const Decision decision = claims_test(claims, tolerance_of_many, usual_false_alarm);
  std::cout << "  " << runs << ": " << decision.detail << ", sees " << decision.visible << '\n';
  EXPECT_TRUE(passes(decision));
  for (const auto& claim : scaled_errors(claims, too_short))
    EXPECT_TRUE(rejects(claims_test({claim}, tolerance_of_many, usual_false_alarm))) << claim.first;
}
INSTANTIATE_TEST_SUITE_P(
    Methods, ClaimsOfManyRuns,
    ::testing::Values(ManySmallRuns{{"article-1", "mlt", 3200, 2048, 5000}, 0.85},
                      ManySmallRuns{{"article-1", "pssmlt", 3200, 2048, 5000}, 0.85},
                      ManySmallRuns{{"article-1", "mmlt", 3200, 2048, 5000}, 0.85},
                      ManySmallRuns{{"article-1", "pssmlt", 51'200, 2048, 2000}, 0.8},
                      ManySmallRuns{{"article-1", "mlt", 3200, 1024, 1000, 2}, 0.8},
                      ManySmallRuns{{"article-1", "pt", 1000, 0, 2000, 2}, 0.9},
                      ManySmallRuns{{"article-2", "bdpt", 1000, 0, 2000, 2}, 0.9}));

}  // namespace
}  // namespace wander::test

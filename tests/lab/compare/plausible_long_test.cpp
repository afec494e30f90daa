// The table of coverage in lab/compare/plausible.h, measured: 2000 comparisons for each entry.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/lab/compare/coverage.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

TEST(PlausibleLong, TheTableOfCoverageIsAsMeasured) {
  constexpr double promised = 0.93;
  for (const ErrorLaw& law : error_laws())
    for (const std::size_t replicates : {2, 3, 4, 8, 16, 32}) {
      const Trials trials{.replicates = replicates, .trials = 2000};
      const Coverage draws = coverage_of(interval_by_draws, law, trials);
      const Coverage bootstrap = coverage_of(interval_by_bootstrap, law, trials);
      std::cout << law.name << ", " << replicates << " replicates: " << draws.share()
                << "; percentile bootstrap " << bootstrap.share() << '\n';
      if (replicates < 4) continue;
      EXPECT_GE(binomial_interval(draws.hits, draws.trials, 1 - 2 * usual_false_alarm).high,
                promised);
    }
}

}  // namespace
}  // namespace wander::test

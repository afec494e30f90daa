// Error bars are neither too short nor too long, of samples and of chains: tests/support/claimed_errors.h.
// False alarms: 1e-9 each beyond the tolerance, by the normal law of the jackknife.  With 99 % they see variances
// that are claimed 9 % too small or too large of samples, 19 % of chains; the long test, of every method, 11 %.
#include "tests/support/claimed_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/generator.h"

namespace wander::test {
namespace {

// What groups that are few, normalized by what all of them found, may cost.
constexpr double tolerance = 0.03;

class ErrorsOfFilms : public ::testing::TestWithParam<RunsOfAMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, ErrorsOfFilms,
                         ::testing::Values(RunsOfAMethod{"article-1", "pt", 4'000, 400},
                                           RunsOfAMethod{"article-1", "lt", 4'000, 400},
                                           RunsOfAMethod{"article-2", "bdpt", 4'000, 400},
                                           RunsOfAMethod{"article-1", "mlt", 8'000, 50}));

TEST_P(ErrorsOfFilms, AreThoseThatTheyClaim) { expect_true_claims(GetParam(), tolerance); }

// Bars whose variance is what they claim times `factor`.
ClaimedRatio simulated(double factor) {
  Generator random(1);
  std::vector<FilmEstimate> films(200);
  for (FilmEstimate& film : films)
    for (int j = 0; j < 50; ++j) {
      const double error = 0.1 * (1 + j % 7);
      film.value.push_back(10 + error * random.normal());
      film.standard_error.push_back(error * std::sqrt(factor));
    }
  return claimed_ratio(films);
}

// Control: the ratio of true bars is one, and bars that are 10 % too short are seen.
TEST(ClaimedRatios, SeeBarsThatAreTooShort) {
  const ClaimedRatio honest = simulated(1), too_short = simulated(0.81);
  EXPECT_NEAR(honest.value, 1, 5 * honest.standard_error);
  EXPECT_LT(honest.standard_error, 0.02);
  EXPECT_NEAR(too_short.value, 0.81 * honest.value, 1e-9);
  EXPECT_LT(too_short.value, 1 - tolerance - 6 * too_short.standard_error);
}

}  // namespace
}  // namespace wander::test

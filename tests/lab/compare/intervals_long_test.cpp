// Coverage of every interval of a comparison, measured: 150 comparisons for each entry.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/lab/compare/intervals.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

constexpr double promised = 0.92;

void measure(const std::string& what, const IntervalTrials& options) {
  std::cout << what << ", " << options.replicates << " replicates, " << options.law.name << ":";
  for (const auto& [name, coverage] : coverages_of(options)) {
    std::cout << "  " << name << ' ' << coverage.share();
    EXPECT_GE(binomial_interval(coverage.hits, coverage.trials, 1 - 2 * usual_false_alarm).high,
              promised)
        << what << ' ' << name;
  }
  std::cout << '\n';
}

TEST(IntervalsLong, CoverWithAnExactReference) {
  for (const std::size_t replicates : {4, 8, 16})
    for (const ErrorLaw& law : {error_laws()[0], error_laws()[1]})
      measure("exact", {.replicates = replicates, .law = law, .trials = 150});
}

TEST(IntervalsLong, CoverABiasedMethod) {
  for (const std::size_t replicates : {4, 16})
    for (const ErrorLaw& law : {error_laws()[0], error_laws()[1]})
      measure("bias", {.replicates = replicates, .law = law, .bias = 1, .trials = 150});
}

TEST(IntervalsLong, CoverWithANoisyReference) {
  for (const double noise : {0.2, 0.5, 1.0})
    for (const bool common : {false, true})
      for (const ErrorLaw& law : {error_laws()[0], error_laws()[1]})
        measure((common ? "common noise " : "noise ") + std::to_string(noise),
                {.replicates = 8,
                 .law = law,
                 .reference_error = noise,
                 .common_reference = common,
                 .trials = 150});
}

TEST(IntervalsLong, EqualMethodsAreSeldomCalledDifferent) {
  for (const std::size_t replicates : {2, 4, 8, 32})
    for (const ErrorLaw& law : {error_laws()[0], error_laws()[1]})
      for (const ErrorLaw& other : {error_laws()[0], error_laws()[1]}) {
        const Coverage alarms =
            false_alarms_of({.replicates = replicates, .law = law, .trials = 200}, other);
        std::cout << replicates << " replicates, " << law.name << " against " << other.name << ": "
                  << alarms.share() << '\n';
        EXPECT_LE(binomial_interval(alarms.hits, alarms.trials, 1 - 2 * usual_false_alarm).low,
                  0.06);
      }
}

}  // namespace
}  // namespace wander::test

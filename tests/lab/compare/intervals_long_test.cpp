// Coverage of every interval of a comparison, measured: 150 comparisons for each entry.
#include <gtest/gtest.h>

#include <iostream>

#include "tests/lab/compare/intervals.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

constexpr double promised = 0.92;

struct Lengths {
  double shortest, longest;
};

void measure(const std::string& what, const AllKept& all) {
  std::cout << what << ":";
  for (const auto& [name, kept] : all) {
    const auto& [hits, trials] = kept.coverage;
    std::cout << "  " << name << ' ' << kept.coverage.share() << " (" << kept.claimed_over_true()
              << ')';
    EXPECT_GE(binomial_interval(hits, trials, 1 - 2 * usual_false_alarm).high, promised)
        << what << ' ' << name;
  }
  std::cout << '\n';
}

// The root with a sign of what is zero in the mean has two peaks, and no deviation that tells.
void expect_lengths(const std::string& what, const AllKept& all, const Lengths& lengths) {
  for (const auto& [name, kept] : all) {
    if (name == "bias" || kept.estimate.count() == 0) continue;
    EXPECT_GE(kept.claimed_over_true(), lengths.shortest) << what << ' ' << name;
    EXPECT_LE(kept.claimed_over_true(), lengths.longest) << what << ' ' << name;
  }
}

// Of four replicates nobody knows how skewed their law is, and an interval that must hold for all of plausible.h
// is up to three times as long as one that knew; of many it is as long as it must be.
Lengths lengths_of(std::size_t replicates) {
  return {0.9, replicates < 8 ? 3.3 : replicates < 16 ? 2.4 : replicates < 64 ? 2.1 : 1.5};
}

void measure(const std::string& what, const IntervalTrials& options) {
  measure(what + ", " + std::to_string(options.replicates) + " replicates, " + options.law.name,
          intervals_of(options));
}

TEST(IntervalsLong, CoverWithAnExactReferenceAndAreNoLongerThanTheyMustBe) {
  for (const std::size_t replicates : {4, 8, 16, 64})
    for (const ErrorLaw& law : {error_laws()[0], error_laws()[1]}) {
      const AllKept all = intervals_of({.replicates = replicates, .law = law, .trials = 150});
      const std::string what = std::to_string(replicates) + " replicates, " + law.name;
      measure(what, all);
      expect_lengths(what, all, lengths_of(replicates));
    }
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

TEST(IntervalsLong, CoverTheTimeOfACrossing) {
  for (const std::size_t replicates : {4, 8, 16, 64})
    for (const ErrorLaw& law : {error_laws()[0], error_laws()[1]}) {
      const AllKept all{
          {"seconds", crossing_times_of({.replicates = replicates, .law = law, .trials = 150})}};
      const std::string what =
          "crossing, " + std::to_string(replicates) + " replicates, " + law.name;
      measure(what, all);
      expect_lengths(what, all, lengths_of(replicates));
    }
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

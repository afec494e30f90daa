// What a decision says that it would have seen it sees, and half of it it does not.  Sums of a thousand terms
// whose spread is known, 400 times: of 99 % that see 396 ± 2 are expected, so 380 is eight of its errors.
#include "statistics/visible_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/rng.h"
#include "statistics/decision.h"
#include "statistics/median.h"

namespace wander::test {
namespace {

constexpr int replicates = 400, terms = 1000;

// How many sums are rejected that are off by so many times what is visible.
int seen(double times) {
  constexpr double threshold = 5, largest = 1;
  int count = 0;
  Rng random(1, Purpose::test, 8);
  for (std::uint64_t r = 0; r < replicates; ++r) {
    random.start(r);
    double sum = 0, squares = 0;
    for (int i = 0; i < terms; ++i) {
      const double term = 2 * random.uniform() - 1;
      sum += term;
      squares += term * term;
    }
    sum += times * visible_sum(squares, largest, threshold);
    count += std::abs(sum) > threshold * std::sqrt(squares + largest * std::abs(sum) / 2) ? 1 : 0;
  }
  return count;
}

TEST(VisibleErrors, OfSumsAreSeen) {
  EXPECT_GE(seen(1), 380);
  EXPECT_LE(seen(0.5), 40);
}

// Means of 200 with a bias, against others without.
TEST(VisibleErrors, OfMeansAreSeen) {
  constexpr double rate = 1e-7;
  const auto count = [](double times) {
    int found = 0;
    Rng random(1, Purpose::test, 9);
    for (std::uint64_t r = 0; r < replicates; ++r) {
      random.start(r);
      Moments a, b;
      for (int i = 0; i < 200; ++i) {
        a.add(random.uniform());
        b.add(random.uniform());
      }
      const double error = std::hypot(a.standard_error(), b.standard_error());
      const double bias = times * visible_difference(error, 398, rate);
      const Measurement one{a.mean() + bias, a.standard_error(), 199},
          other{b.mean(), b.standard_error(), 199};
      const Decision decision = welch_tests({&one, 1}, {&other, 1}, rate);
      EXPECT_NEAR(decision.visible * other.value, visible_difference(error, 398, rate),
                  1e-2 * error);
      found += decision.passed ? 0 : 1;
    }
    return found;
  };
  EXPECT_GE(count(1), 380);
  EXPECT_LE(count(0.5), 60);
}

TEST(VisibleErrors, SolveTheirEquation) {
  for (const double squares : {1e-6, 1.0, 1e6})
    for (const double largest : {0.0, 1.0, 50.0}) {
      const double s = visible_sum(squares, largest, 6), q = sidak_threshold(0.02, 1);
      EXPECT_NEAR(s - q * std::sqrt(squares), 6 * std::sqrt(squares + largest * s / 2), 1e-9 * s);
    }
}

TEST(Medians, AreInTheMiddle) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

}  // namespace
}  // namespace wander::test

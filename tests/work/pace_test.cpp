// How much is done between two looks at the clock.
#include "work/pace.h"

#include <gtest/gtest.h>

namespace wander::test {
namespace {

// Works at `rate` a second until `end`, and says when it was over.
double time_of_work(double rate, double end, std::uint64_t most, int& looks) {
  Pace pace(0, end, most);
  double now = 0;
  std::uint64_t done = 0;
  for (looks = 0; !pace.is_over(now); ++looks) {
    const std::uint64_t count = pace.next(now, done);
    EXPECT_LE(count, most);
    done += count;
    now += static_cast<double>(count) / rate;
  }
  return now;
}

TEST(Pace, HardlyOverrunsTheEndAndHardlyLooks) {
  for (const double rate : {3e4, 1e6, 3e7})
    for (const double end : {0.25, 5.0}) {
      int looks = 0;
      EXPECT_LT(time_of_work(rate, end, std::uint64_t{1} << 40, looks), 1.01 * end) << rate;
      EXPECT_LT(looks, 40) << rate;
    }
}

// Rounds of one length, as they were once, overrun by as much as a round takes.
TEST(Pace, KeepsToTheMostOfARound) {
  int looks = 0;
  EXPECT_LT(time_of_work(1e6, 0.25, 5000, looks), 1.01 * 0.25);
  EXPECT_GE(looks, 50);
}

TEST(Pace, SlowsDownForAnEndThatComesNearer) {
  Pace pace(0, 10, 1 << 20);
  double now = 0;
  std::uint64_t done = 0;
  for (int i = 0; i < 5; ++i) now = 1e-4 * static_cast<double>(done += pace.next(now, done));
  const std::uint64_t long_round = pace.next(now, done);
  EXPECT_GT(long_round, 5000u);
  now = 1e-4 * static_cast<double>(done += long_round);
  pace.end_at(now + 0.01);
  EXPECT_NEAR(static_cast<double>(pace.next(now, done)), 400, 1) << "0.4 % of the budget";
  pace.end_at(now);
  EXPECT_TRUE(pace.is_over(now));
}

}  // namespace
}  // namespace wander::test

// A busy machine is told of, and an idle one is not.
#include "lab/load_warning.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/expect.h"

namespace wander::test {
namespace {

TEST(LoadWarning, IsForThreadsThatHadMuchLessThanTheyAskedFor) {
  EXPECT_EQ(load_warning(5, 9.8, 2), "");
  EXPECT_EQ(load_warning(5, 7.6, 2), "") << "a run has parts for one thread";
  EXPECT_EQ(load_warning(0.05, 0.01, 2), "") << "too short to tell";
  EXPECT_EQ(load_warning(5, NAN, 2), "");
  const std::string busy = load_warning(5, 4, 2);
  EXPECT_EQ(busy,
            "the machine was busy: in 5 s of wall time 2 threads had only 40 % of the processor "
            "time that they asked for, so a budget of wall time is no fair measure here; give it "
            "in processor time (-b 30cpu-s) or in samples (-b 5M), or take fewer threads (-t)");
  EXPECT_TRUE(load_warning(5, 2, 1).ends_with("or in samples (-b 5M)")) << "none to spare";
}

}  // namespace
}  // namespace wander::test

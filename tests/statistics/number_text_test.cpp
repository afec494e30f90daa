// Numbers in the form in which people write them.
#include "statistics/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wander::test {
namespace {

TEST(NumberText, WritesNumbersOfTheUsualSizeInFull) {
  EXPECT_EQ(number_text(1000), "1000");
  EXPECT_EQ(number_text(1473), "1470");
  EXPECT_EQ(number_text(0.5), "0.5");
  EXPECT_EQ(number_text(0.00012345), "0.000123");
  EXPECT_EQ(number_text(1.23456789, 6), "1.23457");
  EXPECT_EQ(number_text(9999000, 4), "9999000");
  EXPECT_EQ(number_text(-2), "−2");
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
}

TEST(NumberText, NamesThePowerOfTheOthers) {
  EXPECT_EQ(number_text(3.2e-5), "3.2·10⁻⁵");
  EXPECT_EQ(number_text(-1.234e12), "−1.23·10¹²");
  EXPECT_EQ(number_text(1e-6), "10⁻⁶");
  EXPECT_EQ(number_text(5e-320), "5·10⁻³²⁰");
}

TEST(NumberText, RoundsOnceAndBeforeItChooses) {
  EXPECT_EQ(number_text(0.00009996), "0.0001");
  EXPECT_EQ(number_text(9.996e6), "10⁷");
  EXPECT_EQ(number_text(0.996, 2), "1");
}

TEST(NumberText, SaysWhatIsNoNumber) {
  EXPECT_EQ(number_text(NAN), "unknown");
  EXPECT_EQ(number_text(INFINITY), "∞");
  EXPECT_EQ(number_text(-INFINITY), "−∞");
}

}  // namespace
}  // namespace wander::test

// Axes and SVG text: ticks, titles, numbers, and what XML allows.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "draw/figure/axis.h"
#include "tests/draw/figure/figure_checks.h"

namespace wander::figure {
namespace {

TEST(Ticks, AreMultiplesOfOneTwoOrFiveTimesAPowerOfTenInsideTheRange) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-12, 12), mantissa(-10, 10);
  for (int trial = 0; trial < 20000; ++trial) {
    const double scale = std::pow(10, exponent(random));
    const double low = scale * mantissa(random),
                 high = low + scale * (0.01 + std::abs(mantissa(random)));
    const int at_most = 2 + trial % 9;
    const Ticks ticks = nice_ticks({low, high}, at_most);

    const double power = std::pow(10, std::floor(std::log10(ticks.step) + 1e-9));
    const double leading = std::round(ticks.step / power);
    EXPECT_TRUE(leading == 1 || leading == 2 || leading == 5) << ticks.step;
    EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(at_most));
    for (const double value : ticks.values) {
      const double multiple = value / ticks.step, slack = 1e-5 * ticks.step;
      EXPECT_NEAR(multiple, std::round(multiple), 1e-6 * std::max(1., std::abs(multiple)));
      EXPECT_TRUE(value >= low - slack && value <= high + slack);
    }
  }
}

TEST(Ticks, AreAsManyAsAllowed) {
  EXPECT_EQ(nice_ticks({0, 1}, 6).values, (std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_EQ(nice_ticks({0, 1}, 11).values.size(), 11u);
}

TEST(Ticks, ExistForRangesThatAreEmptyReversedOrNotFinite) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Range range : {Range{1, 1}, Range{0, 0}, Range{2, 1}, Range{0, inf}, Range{nan, 1},
                            Range{-1e308, 1e308}, Range{0, 5e-324}, Range{1e15, 1e15 + 1}}) {
    const Axis axis = make_axis({"x", "m"}, range, {0, 100}, 6);
    EXPECT_EQ(axis.labels.size(), axis.ticks.size());
    EXPECT_LE(axis.ticks.size(), 6u);
    for (const double tick : axis.ticks) EXPECT_TRUE(std::isfinite(axis.scale(tick)));
  }
}

TEST(Axis, TakesPowersOfTenAndOffsetsIntoItsTitle) {
  const Axis tiny = make_axis({"x", "m"}, {0, 4e-9}, {0, 100}, 5);
  EXPECT_EQ(tiny.title, "x, 10⁻⁹ m");
  EXPECT_EQ(tiny.labels, (std::vector<std::string>{"0", "1", "2", "3", "4"}));
  const Axis far = make_axis({"x", "m"}, {1e6, 1e6 + 1}, {0, 100}, 3);
  EXPECT_EQ(far.title, "x − 1000000, m");
  EXPECT_EQ(far.labels, (std::vector<std::string>{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(make_axis({"y", "m"}, {-1, 1}, {0, 100}, 3).labels.front(), "−1");
}

TEST(Svg, NumbersAreShortAndNeverNegativeZero) {
  EXPECT_EQ(number(1), "1");
  EXPECT_EQ(number(-0.001), "0");
  EXPECT_EQ(number(2.50), "2.5");
  EXPECT_EQ(number(-1.239), "-1.24");
  EXPECT_EQ(number(nan), "0");
}

TEST(Svg, EscapesMarkupAndReplacesWhatXmlForbids) {
  EXPECT_EQ(escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
  EXPECT_EQ(escaped("αβ → 光"), "αβ → 光");
  for (const std::string& bad : {std::string("\x01"), std::string("\xFF"), std::string("\xC0\x80"),
                                 std::string("\xED\xA0\x80"), std::string("\xEF\xBF\xBE")})
    EXPECT_NE(escaped(bad).find("\xEF\xBF\xBD"), std::string::npos);
  EXPECT_EQ(escaped("\xE2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // cut off
}

TEST(Svg, ShortenedTextFitsAndKeepsWholeCharacters) {
  const std::string text = "αβγδεζηθικλμνξοπ";
  for (double width = 20; width < 120; width += 3) {
    const std::string cut = shortened(text, 7, width);
    EXPECT_LE(text_width(cut, 7), width);
    EXPECT_EQ(escaped(cut), cut);
  }
  EXPECT_EQ(shortened("abc", 7, 100), "abc");
  // Names that differ at their ends stay apart.
  EXPECT_NE(shortened(text + "1", 7, 40), shortened(text + "2", 7, 40));
}

}  // namespace
}  // namespace wander::figure

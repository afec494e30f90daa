// Charts, rows of intervals and bars of shares: whatever the numbers, a figure that says so.
#include "draw/figure/chart.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw/figure/chart_axes.h"
#include "draw/figure/interval_rows.h"
#include "draw/figure/share_bars.h"
#include "tests/draw/figure/figure_checks.h"

namespace wander::figure {
namespace {

std::string document(const Block& block) { return page("t", "d", 516, {block}); }

Chart chart_of(std::vector<Point> points, Spacing spacing = Spacing::linear) {
  Chart chart;
  chart.x.spacing = chart.y.spacing = spacing;
  Series series;
  series.label = "a <b>";
  series.points = std::move(points);
  chart.panels.push_back({.series = {series}, .empty_note = "nothing is known"});
  return chart;
}

TEST(Chart, IsWellFormedWhateverItsPoints) {
  const std::vector<std::vector<Point>> cases{{},
                                              {{1, 1}},
                                              {{0, 0}, {-1, 5}},
                                              {{1e-300, 1e300}, {1e300, 1e-300}},
                                              {{nan, 1}, {1, nan}},
                                              {{1, 1, Range{0, 2}, Range{nan, 3}}, {2, INFINITY}}};
  for (const auto& points : cases)
    for (const Spacing spacing : {Spacing::linear, Spacing::whole, Spacing::logarithmic})
      EXPECT_TRUE(is_well_formed(document(chart_block(chart_of(points, spacing), 500))));
}

TEST(Chart, SaysThatNothingCanBeDrawn) {
  const auto says = [](const Chart& chart) {
    return count(document(chart_block(chart, 500)), ">nothing is known<");
  };
  EXPECT_EQ(says(chart_of({{0, 1}, {-1, 1}}, Spacing::logarithmic)), 1u);
  EXPECT_EQ(says(chart_of({{1, 1}}, Spacing::logarithmic)), 0u);
}

TEST(Chart, LeavesOutWhatALogarithmCannotShow) {
  const std::string svg =
      document(chart_block(chart_of({{1, 1}, {2, 0}, {3, 3}}, Spacing::logarithmic), 500));
  // Two marks, and one in the legend.
  EXPECT_EQ(count(svg, "class=\"marker\""), 3u);
}

TEST(Chart, ItsRangesHoldPointsIntervalsAndGuides) {
  Chart chart = chart_of({{1, 2, Range{0.5, 4}, Range{1, 9}}}, Spacing::logarithmic);
  chart.panels[0].guides.push_back({20, "target"});
  EXPECT_LE(x_range(chart).low, 0.5);
  EXPECT_GE(x_range(chart).high, 4);
  EXPECT_LE(y_range(chart).low, 1);
  EXPECT_GE(y_range(chart).high, 20);
}

TEST(Chart, WholeAxesHaveTicksAtWholeNumbers) {
  const ChartAxis axis = chart_axis({.spacing = Spacing::whole}, {1.8, 5.2}, {0, 400}, 20);
  EXPECT_EQ(axis.axis.labels, (std::vector<std::string>{"2", "3", "4", "5"}));
}

// The labels of vertical guides keep to one side of their lines, in an order in which no line that
// begins above one crosses it.
TEST(Chart, NoGuideCrossesTheLabelOfAnother) {
  Chart chart = chart_of({{1, 1}, {100, 1}}, Spacing::logarithmic);
  chart.guides = {{30, "third"}, {3, "first"}, {10, "second"}};
  const std::string svg = document(chart_block(chart, 500));
  EXPECT_LT(svg.find("first"), svg.find("second"));
  EXPECT_LT(svg.find("second"), svg.find("third"));
  chart.guides.push_back({95, "a label that is long and has no room at the right of its line"});
  const std::string left = document(chart_block(chart, 500));
  EXPECT_GT(left.find("first"), left.find("second"));
}

TEST(Looks, ManyThingsDifferInMoreThanColour) {
  for (std::size_t a = 0; a < 56; ++a)
    for (std::size_t b = a + 1; b < 56; ++b)
      EXPECT_FALSE(look_of(a).marker == look_of(b).marker &&
                   look_of(a).stroke.dashes == look_of(b).stroke.dashes)
          << a << ' ' << b;
}

TEST(IntervalRows, AreWellFormedAndDrawWhatIsKnown) {
  IntervalRows rows;
  rows.groups = {{"<g>",
                  {{.label = "known", .value = 1, .interval = Range{0.5, 1.5}},
                   {.label = "failed", .value = nan, .note = "failed"},
                   {.label = std::string(300, 'x'), .value = 2}}}};
  rows.band = Range{1, 1};
  rows.band_label = "band";
  const std::string svg = document(interval_block(rows, 500));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "class=\"marker\""), 2u);
  EXPECT_EQ(count(svg, "class=\"interval\""), 1u);
  EXPECT_EQ(count(svg, "class=\"expected\""), 1u);
}

TEST(ShareBars, PartsAreAsWideAsTheirShares) {
  const std::string svg = document(
      share_bars("", {{"a", "", {{"p", 0.25}, {"q", 0.75}}}}, {{.key = "p"}, {.key = "q"}}, 400));
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "width=\"100\""), 1u);
  EXPECT_EQ(count(svg, "width=\"300\""), 1u);
}

}  // namespace
}  // namespace wander::figure

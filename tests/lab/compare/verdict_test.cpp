// What is said of a comparison: the same by compare, the report and inspect, and what was not
// measured is said to be extrapolated.
#include "lab/compare/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "draw/report/error_figure.h"
#include "draw/report/report.h"
#include "lab/compare/comparison_json.h"
#include "tests/draw/figure/figure_checks.h"
#include "tests/lab/compare/made_runs.h"
#include "tools/inspection.h"

namespace wander::test::verdict_test {
namespace {

using namespace compare;

std::string told(const Comparison& comparison) {
  std::string text;
  for (const std::string& sentence : comparison.verdict) text += sentence + "\n";
  return text;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

// Runs of 1, 2 and 4 s.  To an error of 6 % they take 0.25, 2.8, 6.3 and 44 s.
Comparison four_methods() {
  Generator random(3);
  Runs runs = made_runs({.bins = 64, .replicates = 8, .seconds = {1, 2, 4}},
                        {{"quick", 0.03}, {"fast", 0.1}, {"slow", 0.15}, {"far", 0.4}}, random);
  runs.target = 0.06;
  return summarize(std::move(runs));
}

TEST(Verdict, TimesBeyondTheLongestRunAreSaidToBeExtrapolated) {
  const Comparison c = four_methods();
  EXPECT_EQ(time_to_target(c, 0), "at most its shortest run (1 s)");
  EXPECT_TRUE(time_to_target(c, 1).starts_with("2.")) << time_to_target(c, 1);
  EXPECT_TRUE(time_to_target(c, 2).starts_with("extrapolated: about 6 s ("))
      << time_to_target(c, 2);
  EXPECT_EQ(time_to_target(c, 3), "more than 4 times its longest run (4 s)");
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_TRUE(says(told(c), c.runs.contenders[k].label + " " + time_to_target(c, k)));
  const auto curves = to_json(c)["curves"];
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(curves[k]["extrapolated"], k == 2) << k;
}

// A black film is off by all of the light, and no two differ: that is no small error without spread.
TEST(Verdict, WhoFoundNoLightIsAheadOfNobody) {
  Generator random(6);
  Runs runs = made_runs({.seconds = {1, 2}}, {{"black", 1}, {"noisy", 6}, {"noisier", 30}}, random);
  for (compare::Run& run : runs.runs)
    if (run.contender == 0) std::ranges::fill(run.film.value, 0.0);
  const Comparison c = summarize(std::move(runs));
  EXPECT_EQ(c.ranking, (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_NEAR(c.cells[c.decisive].relative_rmse.value, 1, 1e-12);
  for (const Crossing& crossing : c.crossings)
    EXPECT_EQ(crossing.significant, crossing.behind != 0 && crossing.ahead != 0);
  EXPECT_TRUE(says(told(c), "No replicate found any light")) << told(c);
  EXPECT_FALSE(says(told(c), "black at most its shortest run")) << told(c);
}

TEST(Verdict, WhatDoesNotFallLikeTheRootIsNotExtrapolated) {
  Generator random(4);
  Runs runs =
      made_runs({.bins = 64, .seconds = {1, 2, 4}}, {{"biased", 0.01, 0.2}, {"fast", 0.1}}, random);
  runs.target = 0.1;
  const Comparison c = summarize(std::move(runs));
  ASSERT_FALSE(c.curves[0].inverse_root);
  EXPECT_EQ(time_to_target(c, 0), "not reached in its longest run (4 s)");
}

TEST(Verdict, FiguresTellWhatIsExtrapolated) {
  const Comparison c = four_methods();
  const std::string errors = report::error_time_figure(c, "errors");
  EXPECT_EQ(figure::count(errors, "class=\"open marker\""), 1u);
  EXPECT_TRUE(says(errors, ">longest run, 4 s; beyond it extrapolated<"));
  // All replicates of `slow`, none of the others.
  EXPECT_EQ(figure::count(report::profile_figure(c), "class=\"open marker\""), 8u);
  // Those of `quick` are there before its shortest run ends, nobody knows when.
  EXPECT_EQ(report::times_shown(c, c.profiles.at(0)), std::vector<double>(8, 1.0));
  Generator random(3);
  const Comparison within = summarize(made_runs({}, {{"fast", 0.1}, {"equal", 0.1}}, random));
  EXPECT_FALSE(report::has_extrapolated(within));
  EXPECT_FALSE(says(report::error_time_figure(within, "errors"), "longest run"));
}

// The third is as good as the second: one pair is told apart, another is not.
TEST(Verdict, WhoIsAheadIsSaidAlikeEverywhere) {
  Generator random(2);
  Comparison c = summarize(
      made_runs({.replicates = 8}, {{"slow", 0.4}, {"fast", 0.1}, {"equal", 0.1}}, random));
  c.runs.provenance.scene_text = R"({ "format": "wanderlight-scene/1", "dimension": 2,
    "materials": { "m": { "type": "diffuse", "reflectance": 0.5 } }, "shapes": [
    { "type": "segment", "from": [0,1], "to": [1,1], "light": { "radiance": 1 } },
    { "type": "segment", "from": [0,0], "to": [1,0], "sensor": { "bins": 16 } } ] })";
  const std::string inspected = text_of_comparison(c), report = report_html(c);
  std::size_t told_apart = 0;
  for (const Crossing& crossing : c.crossings) {
    const std::string words = standing(c, crossing);
    told_apart += crossing.significant ? 1 : 0;
    EXPECT_EQ(says(words, " is ahead of "), crossing.significant) << words;
    EXPECT_EQ(says(words, "cannot be told"), !crossing.significant) << words;
    EXPECT_TRUE(says(inspected, "  " + words)) << words;
    EXPECT_TRUE(says(report, "<li>" + words)) << words;
  }
  EXPECT_EQ(told_apart, 2u);
  EXPECT_TRUE(c.verdict.front().starts_with(standing(c, c.crossings.front())));
}

}  // namespace
}  // namespace wander::test::verdict_test

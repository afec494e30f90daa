// What summarize() makes of runs: small cases by hand, and a comparison whose truth is known.
#include <gtest/gtest.h>

#include <limits>

#include "lab/compare/crossings.h"
#include "lab/compare/curves.h"
#include "lab/compare/yardstick.h"
#include "tests/lab/compare/made_runs.h"

namespace wander::test::summarize_test {
namespace {

using namespace compare;
using compare::Path;

// One contender, one budget: these films against that reference.
Runs runs_of(const std::vector<std::vector<double>>& films, const FilmEstimate& reference) {
  Runs runs;
  runs.contenders = {{"pt", "pt", "", ""}};
  runs.budgets = {"2s"};
  runs.replicates = films.size();
  runs.reference.film = reference;
  for (std::size_t r = 0; r < films.size(); ++r)
    runs.runs.push_back({0, 0, r, r + 1, 100, 2, 0, 0, made_film(films[r], 0.1)});
  return runs;
}

TEST(Summarize, ErrorsByHand) {
  const Comparison c = summarize(runs_of({{1.1, 2}, {1, 1.8}}, made_film({1, 2}, 0)));
  // m_1 = 0.01/5, m_2 = 0.04/5; |bias|² = ((0.1)(0) + (0)(-0.2))/5 = 0
  const Cell& cell = c.cells.at(0);
  EXPECT_EQ(cell.replicates, 2U);
  EXPECT_NEAR(cell.relative_rmse.value, std::sqrt(0.025 / 5), 1e-12);
  EXPECT_NEAR(cell.rmse.value, std::sqrt(0.025 / 2), 1e-12);
  EXPECT_NEAR(cell.mae.value, 0.075, 1e-12);
  EXPECT_NEAR(cell.median_relative_rmse.value, (std::sqrt(0.01 / 5) + std::sqrt(0.04 / 5)) / 2,
              1e-12);
  const double small = 0.015 * 0.015;
  EXPECT_NEAR(cell.rel_mse.value, (0.01 / (1 + small) / 2 + 0.04 / (4 + small) / 2) / 2, 1e-12);
  EXPECT_NEAR(cell.bias.value, 0, 1e-7);
  EXPECT_NEAR(cell.relative_error_of_mean.value, (0.05 - 0.1) / 2 / 1.5, 1e-12);
  EXPECT_NEAR(cell.efficiency.value, 1 / (0.025 / 5 * 2), 1e-9);
  EXPECT_EQ(cell.seconds.value, 2);
  EXPECT_NEAR(c.errors.at(1).relative_rmse, std::sqrt(0.04 / 5), 1e-12);
  EXPECT_NEAR(c.errors.at(1).mean, 1.4, 1e-12);
}

// The mean of two: t of one degree of freedom. The median of twelve: from the third to the tenth, for
// 2 P(Bin(12, 1/2) <= 2) = 0.039 and 2 P(Bin(12, 1/2) <= 3) = 0.146.
TEST(Summarize, IntervalsByHand) {
  const Comparison two = summarize(runs_of({{1.1, 2}, {1, 1.8}}, made_film({1, 2}, 0)));
  const Measured& mean = two.cells.at(0).relative_error_of_mean;
  const double reach = 12.7062047 * (0.05 + 0.1) / 1.5 / 2;
  EXPECT_NEAR(mean.interval.low, mean.value - reach, 1e-6);
  EXPECT_NEAR(mean.interval.high, mean.value + reach, 1e-6);
  std::vector<std::vector<double>> films;
  for (const int r : {7, 3, 12, 1, 9, 5, 11, 2, 8, 4, 10, 6}) films.push_back({1 + 0.01 * r, 2});
  const Measured median =
      summarize(runs_of(films, made_film({1, 2}, 0))).cells.at(0).median_relative_rmse;
  EXPECT_NEAR(median.value, 0.065 / std::sqrt(5), 1e-12);
  EXPECT_NEAR(median.interval.low, 0.03 / std::sqrt(5), 1e-12);
  EXPECT_NEAR(median.interval.high, 0.10 / std::sqrt(5), 1e-12);
}

TEST(Summarize, TheErrorOfTheReferenceIsSubtracted) {
  const FilmEstimate reference = made_film({1, 2}, 0.05);
  const Comparison c = summarize(runs_of({{1.1, 2}, {1, 1.8}}, reference));
  EXPECT_NEAR(c.cells.at(0).relative_rmse.value, std::sqrt((0.025 - 0.005) / 5), 1e-12);
  // Never below zero for a root; what is signed keeps its sign.
  const Comparison same = summarize(runs_of({{1, 2}, {1, 2}}, reference));
  EXPECT_EQ(same.cells.at(0).relative_rmse.value, 0);
  EXPECT_NEAR(same.cells.at(0).bias.value, -std::sqrt(0.001), 1e-12);
  EXPECT_NEAR(same.errors.at(0).relative_mse, -0.001, 1e-12);
  EXPECT_LT(same.cells.at(0).rel_mse.value, 0);
}

// All replicates shifted alike is bias; the diagonal of the pairs would add the variance to it.
TEST(Summarize, BiasIsThatOfPairsOfReplicates) {
  const Comparison c = summarize(runs_of({{1.3, 0.9}, {1.1, 1.1}, {1.2, 1}}, made_film({1, 1}, 0)));
  // y = (0.3,-0.1), (0.1,0.1), (0.2,0): pairs 0.02, 0.06, 0.02, over Σ I² = 2
  EXPECT_NEAR(c.cells.at(0).bias.value, std::sqrt((0.02 + 0.06 + 0.02) / 3 / 2), 1e-12);
  const double diagonal = std::sqrt((0.1 + 0.02 + 0.04 + 2 * 0.1) / 9 / 2);
  EXPECT_GT(std::abs(c.cells.at(0).bias.value - diagonal), 0.01);
}

TEST(Summarize, ASingleReplicateHasValuesAndNoInterval) {
  Generator random(1);
  const Comparison c = summarize(made_runs({.replicates = 1}, {{"a", 0.01}, {"b", 0.1}}, random));
  const Cell& cell = c.cells.front();
  EXPECT_GT(cell.relative_rmse.value, 0);
  EXPECT_TRUE(std::isnan(cell.relative_rmse.interval.low));
  EXPECT_TRUE(std::isnan(cell.bias.value));
  EXPECT_FALSE(c.crossings.at(0).significant);
  EXPECT_GT(c.crossings.at(0).speedup.value, 1);
  EXPECT_TRUE(std::isnan(c.crossings.at(0).speedup.interval.high));
  EXPECT_GE(c.verdict.size(), 2U);
}

// However many others there are: among 30 contenders there are 435 pairs, of which 29 are with the one behind.
TEST(Summarize, ManyContendersHideNoDifference) {
  Generator random(2);
  std::vector<MadeMethod> methods{{"slow", 0.9}};
  for (int i = 1; i < 30; ++i) methods.push_back({"fast" + std::to_string(i), 0.01});
  const Comparison c = summarize(made_runs({.replicates = 16, .seconds = {1}}, methods, random));
  EXPECT_EQ(c.crossings.size(), 435U);
  for (const Crossing& crossing : c.crossings) {
    if (crossing.behind != 0) continue;
    EXPECT_TRUE(crossing.significant) << crossing.ahead;
  }
}

TEST(Summarize, WhatIsFarAheadIsFoundAheadBeyondChance) {
  Generator random(2);
  const Comparison c = summarize(
      made_runs({.replicates = 8}, {{"slow", 0.4}, {"fast", 0.1}, {"equal", 0.1}}, random));
  EXPECT_EQ(c.ranking.back(), 0U);
  EXPECT_EQ(c.crossings.size(), 3U);
  for (const Crossing& crossing : c.crossings) {
    EXPECT_EQ(crossing.significant, crossing.behind == 0);
    if (crossing.behind != 0) continue;
    EXPECT_EQ(crossing.seconds.value, 0);
    EXPECT_LT(crossing.speedup.interval.low, 16);
    EXPECT_GT(crossing.speedup.interval.high, 16);
  }
  for (const Curve& curve : c.curves) {
    EXPECT_LT(curve.slope_time.interval.low, -0.5);
    EXPECT_GT(curve.slope_time.interval.high, -0.5);
    EXPECT_TRUE(curve.inverse_root);
  }
  // 0.1 / √8 = 0.035 has reached the target of 5 %; √(0.01 / t) = 0.05 at 4 s.  The 64 s of the
  // other are beyond what runs of 8 s can tell.
  EXPECT_DOUBLE_EQ(c.target, 0.05);
  EXPECT_NEAR(c.curves.at(1).seconds_to_target.value, 4, 1.5);
  EXPECT_TRUE(std::isnan(c.curves.at(0).seconds_to_target.value));
  EXPECT_EQ(c.profiles.at(1).seconds.size(), 8U);
  EXPECT_DOUBLE_EQ(c.profiles.at(1).share.back(), 1);
}

// ---- curves, by hand

Measurements curves_of(const std::vector<std::vector<double>>& errors,
                       const std::vector<double>& seconds) {
  Measurements all{errors.size(), seconds.size(), {}};
  for (const auto& curve : errors)
    for (std::size_t b = 0; b < seconds.size(); ++b) {
      MeasuredCell cell;
      cell.relative_mse = curve[b] * curve[b];
      cell.cell.relative_rmse.value = curve[b];
      cell.cell.seconds.value = cell.cell.samples.value = seconds[b];
      all.cells.push_back(cell);
    }
  return all;
}

TEST(Crossings, TwoLinesMeetWhereTheyDo) {
  // 0.4 t^-1/2 is below 0.1 from t = 16 on.
  const Measurements all = curves_of({{0.1, 0.1, 0.1}, {0.4, 0.2, 0.05}}, {1, 4, 64});
  const std::vector<std::size_t> ranking = ranking_at(all, 2);
  EXPECT_EQ(ranking.front(), 1U);
  const std::vector<Crossing> crossings = measure_crossings(all, ranking, 2);
  EXPECT_EQ(crossings.at(0).ahead, 1U);
  EXPECT_NEAR(crossings.at(0).seconds.value, 16, 1e-9);
  EXPECT_NEAR(crossings.at(0).speedup.value, 4, 1e-12);
  // The wrong twin exchanges the two: then nobody is ahead at the end.
  EXPECT_TRUE(std::isinf(seconds_ahead(path_of(points_of(all, 0)), path_of(points_of(all, 1)))));
}

TEST(Crossings, TheLastOfSeveralCounts) {
  const Measurements all = curves_of({{1, 1, 1, 1}, {0.5, 2, 2, 0.5}}, {1, 2, 8, 32});
  EXPECT_NEAR(seconds_ahead(path_of(points_of(all, 1)), path_of(points_of(all, 0))), 16, 1e-9);
}

TEST(Crossings, AheadAllAlongIsZeroAndNoCommonTimeIsUnknown) {
  const Path near{{0, -1}, {1, -2}}, far{{5, -1}, {6, -2}}, above{{0, 1}, {1, 0}};
  EXPECT_EQ(seconds_ahead(near, above), 0);
  EXPECT_TRUE(std::isnan(seconds_ahead(near, far)));
  EXPECT_TRUE(std::isnan(seconds_ahead(near, {})));
}

TEST(Crossings, HolmByHand) {
  const std::vector<double> adjusted = holm({0.01, 0.04, 0.03, not_known});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.04);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.09);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.09);  // 2 × 0.04, but not below the one before
  EXPECT_TRUE(std::isnan(adjusted[3]));
}

TEST(Curves, TheTargetIsARoundErrorThatIsReached) {
  EXPECT_DOUBLE_EQ(round_target(curves_of({{0.013}, {0.3}}, {1}), 0), 0.02);
  EXPECT_DOUBLE_EQ(round_target(curves_of({{0.2}}, {1}), 0), 0.2);
  EXPECT_DOUBLE_EQ(round_target(curves_of({{0.6}}, {1}), 0), 1);
  EXPECT_TRUE(std::isnan(round_target(curves_of({{0.0}}, {1}), 0)));
}

TEST(Curves, SlopeAndTimeToATarget) {
  const Measurements root = curves_of({{0.4, 0.2, 0.1}}, {1, 4, 16});
  const Curve curve = measure_curve(root, 0, 0.1);
  EXPECT_NEAR(curve.slope_time.value, -0.5, 1e-12);
  EXPECT_NEAR(curve.seconds_to_target.value, 16, 1e-9);
  // Beyond four times the longest run nothing is said, and before the shortest no more than it.
  EXPECT_NEAR(measure_curve(root, 0, 0.0501).seconds_to_target.value, 63.74, 0.01);
  EXPECT_TRUE(std::isnan(measure_curve(root, 0, 0.0499).seconds_to_target.value));
  EXPECT_NEAR(measure_curve(root, 0, 0.399).seconds_to_target.value, 1.005, 0.001);
  EXPECT_EQ(measure_curve(root, 0, 0.401).seconds_to_target.value, 0);

  const Measurements flat = curves_of({{0.4, 0.2, 0.19}}, {1, 4, 16});
  EXPECT_FALSE(measure_curve(flat, 0, 0.3).inverse_root);
  EXPECT_NEAR(measure_curve(flat, 0, 0.4 / std::sqrt(2)).seconds_to_target.value, 2, 1e-9);
  EXPECT_TRUE(std::isnan(measure_curve(flat, 0, 0.1).seconds_to_target.value));
  EXPECT_EQ(measure_curve(flat, 0, 0.5).seconds_to_target.value, 0);
}

TEST(Curves, AProfileCountsTheReplicatesThatCannotTell) {
  Curve curve;
  curve.inverse_root = true;
  const Profile profile =
      measure_profile({{{0.04, 1}, {0.01, 4}}, {{0.16, 1}, {0.04, 4}}, {{100, 1}}, {}}, curve, 0.1);
  EXPECT_EQ(profile.seconds.size(), 2U);
  EXPECT_NEAR(profile.seconds[0], 4, 1e-12);
  EXPECT_NEAR(profile.seconds[1], 16, 1e-12);
  EXPECT_NEAR(profile.share[1], 2.0 / 3, 1e-12);
}

}  // namespace
}  // namespace wander::test::summarize_test

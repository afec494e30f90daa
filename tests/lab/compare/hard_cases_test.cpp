// Comparisons of what can go wrong: darkness, unknown errors, one bin, one budget, interruptions;
// and what a verdict says of it.
#include <gtest/gtest.h>

#include <limits>

#include "tests/lab/compare/made_runs.h"

namespace wander::test::hard_cases_test {
namespace {

using namespace compare;

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

#define EXPECT_SAYS(sentences, part) \
  EXPECT_NE(joined(sentences).find(part), std::string::npos) << joined(sentences)

const std::vector<MadeMethod> two{{"a", 0.1}, {"b", 0.3}};

TEST(HardCases, DarkFilmsAndADarkReference) {
  Generator random(1);
  Runs runs = made_runs({}, two, random);
  for (compare::Run& run : runs.runs) run.film = made_film(std::vector<double>(16, 0.0), 0);
  const Comparison dark_films = summarize(runs);
  EXPECT_NEAR(dark_films.cells.at(0).relative_rmse.value, 1, 1e-12);
  EXPECT_FALSE(dark_films.crossings.at(0).significant);
  EXPECT_SAYS(dark_films.cautions, "No replicate found any light");
  EXPECT_EQ(joined(dark_films.cautions).find("does not fall like"), std::string::npos)
      << "of black films nothing else is said: " << joined(dark_films.cautions);
  runs.reference.film = made_film(std::vector<double>(16, 0.0), 0);
  const Comparison dark = summarize(runs);
  EXPECT_TRUE(std::isnan(dark.cells.at(0).relative_rmse.value));
  EXPECT_EQ(dark.cells.at(0).rmse.value, 0);
  EXPECT_SAYS(dark.verdict, "The reference is dark");
}

TEST(HardCases, AContenderWhoseRunsAllFailed) {
  Generator random(1);
  Runs runs = made_runs({.replicates = 4, .seconds = {1}}, two, random);
  const auto is_of_b = [](const compare::Run& run) { return run.contender == 1; };
  const auto fail = [&](const compare::Run& run) {
    runs.failures.push_back({run.contender, run.budget, run.replicate, run.seed, "no light"});
  };
  const compare::Run last = *std::ranges::find_if(runs.runs, is_of_b);
  std::ranges::for_each(runs.runs, [&](const auto& run) {
    if (is_of_b(run)) fail(run);
  });
  std::erase_if(runs.runs, is_of_b);
  EXPECT_SAYS(summarize(runs).cautions, "All 4 runs of b failed.");
  runs.failures.erase(runs.failures.begin());  // of one there are errors
  runs.runs.push_back(last);
  EXPECT_SAYS(summarize(runs).cautions,
              "3 of 4 runs of b failed: its errors are those of the rest.");
}

TEST(HardCases, FilmsThatEqualTheReference) {
  Generator random(2);
  Runs runs = made_runs({}, two, random);
  for (compare::Run& run : runs.runs) run.film = runs.reference.film;
  const Comparison c = summarize(runs);
  EXPECT_EQ(c.cells.at(0).relative_rmse.value, 0);
  EXPECT_EQ(c.cells.at(0).relative_rmse.interval.high, 0);
  EXPECT_TRUE(std::isnan(c.target));
  EXPECT_FALSE(c.crossings.at(0).significant);
  EXPECT_GE(c.verdict.size(), 2U);
}

TEST(HardCases, UnknownErrorsOfRunsAndOfTheReference) {
  Generator random(3);
  Runs runs = made_runs({}, two, random);
  for (compare::Run& run : runs.runs) run.film.standard_error.assign(16, not_known);
  runs.reference.film.standard_error.assign(16, not_known);
  const Comparison c = summarize(runs);
  EXPECT_TRUE(std::isnan(c.cells.at(0).claimed_relative_error));
  EXPECT_TRUE(std::isnan(c.cells.at(0).coverage));
  EXPECT_TRUE(c.crossings.at(0).significant);
  EXPECT_SAYS(c.cautions, "does not know its own error in 16 of 16 bins");
}

TEST(HardCases, FilmsThatAreNotFiniteAreLeftOut) {
  Generator random(4);
  Runs runs = made_runs({}, two, random);
  runs.runs.back().film.value[3] = not_known;
  const Comparison c = summarize(runs);
  EXPECT_EQ(c.cells.back().replicates, 7U);
  EXPECT_TRUE(std::isfinite(c.cells.back().relative_rmse.value));
  EXPECT_SAYS(c.verdict, "1 of 64 runs hold values that are not finite");
}

TEST(HardCases, OneBinOneBudgetOneContender) {
  Generator random(5);
  const Comparison c = summarize(made_runs({.bins = 1, .seconds = {3}}, {{"only"}}, random));
  EXPECT_GT(c.cells.at(0).relative_rmse.interval.high, c.cells.at(0).relative_rmse.value);
  EXPECT_TRUE(std::isnan(c.curves.at(0).slope_time.value));
  EXPECT_TRUE(c.curves.at(0).inverse_root);
  EXPECT_EQ(c.curves.at(0).seconds_to_target.value, 0);  // the one budget comes to the target
  EXPECT_TRUE(c.crossings.empty());
  EXPECT_SAYS(c.verdict, "There is one contender");
}

TEST(HardCases, AnInterruptedComparisonIsJudgedWhereAllWereMeasured) {
  Generator random(6);
  Runs runs = made_runs({}, two, random);
  runs.complete = false;
  std::erase_if(runs.runs, [](const compare::Run& r) { return r.budget == 3 && r.contender == 1; });
  const Comparison c = summarize(runs);
  EXPECT_EQ(c.decisive, 2U);
  EXPECT_TRUE(c.crossings.at(0).significant);
  EXPECT_SAYS(c.verdict, "The comparison is not complete: 56 of 64 runs were made.");
  runs.runs.clear();
  EXPECT_GE(summarize(runs).verdict.size(), 2U);
  EXPECT_TRUE(summarize(Runs{}).verdict.empty());
}

TEST(HardCases, FilmsOfHugeOrTinyLightKeepTheirErrors) {
  for (const double power : {1e200, 1e-200}) {
    Generator random(7);
    Runs runs = made_runs({}, two, random);
    const Comparison plain = summarize(runs);
    const auto scale = [power](FilmEstimate& film) {
      for (double& x : film.value) x *= power;
      for (double& x : film.standard_error) x *= power;
    };
    scale(runs.reference.film);
    for (compare::Run& run : runs.runs) scale(run.film);
    const Comparison scaled = summarize(runs);
    EXPECT_NEAR(scaled.cells.at(0).relative_rmse.value, plain.cells.at(0).relative_rmse.value,
                1e-9);
    EXPECT_NEAR(scaled.cells.at(0).mae.value / power, plain.cells.at(0).mae.value, 1e-9);
  }
}

TEST(HardCases, AFilmOfAnotherShapeIsRefused) {
  Generator random(8);
  Runs runs = made_runs({}, two, random);
  runs.runs.front().film = made_film({1}, 0);
  EXPECT_THROW(summarize(runs), std::invalid_argument);
  runs = made_runs({}, two, random);
  runs.runs.front().budget = 4;
  EXPECT_THROW(summarize(runs), std::invalid_argument);
}

// ---- the verdict

TEST(Verdict, SaysWhoIsAheadAndThatItIsSignificant) {
  Generator random(9);
  const Comparison c = summarize(made_runs({}, two, random));
  EXPECT_SAYS(c.verdict, "a is ahead of b from the first budget on: at 8s its relative RMSE is ");
  EXPECT_SAYS(c.verdict, " times the mean square error.");
  EXPECT_SAYS(c.verdict, "Every difference is significant (5 % over 1 pair, Holm).");
  EXPECT_SAYS(c.verdict, "Time to a relative RMSE of 5 %: a ");
  EXPECT_TRUE(c.cautions.empty()) << joined(c.cautions);
}

TEST(Verdict, SaysWhatIsNotSignificant) {
  Generator random(10);
  const Comparison c =
      summarize(made_runs({.replicates = 4}, {{"a", 0.1}, {"b", 0.1}, {"c", 0.9}}, random));
  EXPECT_SAYS(c.verdict, " is ahead cannot be told: at 8s ");
  EXPECT_SAYS(c.verdict, "Not significant: the difference between ");
  EXPECT_LE(c.verdict.size(), 6U);
}

TEST(Verdict, AtEqualSamplesTheEfficiencyIsGivenToo) {
  Generator random(11);
  Runs runs = made_runs({}, two, random);
  runs.budgets = {"1k", "2k", "4k", "8k"};
  for (compare::Run& run : runs.runs)
    if (run.contender == 0) run.seconds *= 100;
  const Comparison c = summarize(runs);
  EXPECT_SAYS(c.verdict, "This is at equal samples");
  EXPECT_NEAR(c.crossings.at(0).efficiency.value, c.crossings.at(0).speedup.value / 100, 1e-9);
  // Who is ahead by samples is far behind by time, and that is said of both.
  ASSERT_EQ(c.crossings.at(0).ahead, 0u);
  EXPECT_SAYS(c.verdict, "a is ahead of b at equal samples: at 8k ");
  EXPECT_SAYS(c.verdict, ": at equal time b is ahead: the efficiency of b is ");
}

TEST(Verdict, KnowsBudgetsOfTimeByTheirUnit) {
  Generator random(11);
  for (const char* unit : {"s", "cpu-s", "min", "cpu-min", "h"}) {
    Runs runs = made_runs({}, two, random);
    for (std::size_t k = 0; k < runs.budgets.size(); ++k)
      runs.budgets[k] = std::to_string(k + 1) + unit;
    for (const std::string& sentence : summarize(runs).verdict)
      EXPECT_EQ(sentence.find("equal samples"), std::string::npos) << sentence;
  }
}

TEST(Verdict, WithoutARunClaimsNoChance) {
  Generator random(11);
  Runs runs = made_runs({}, two, random);
  runs.runs.clear();
  const Comparison c = summarize(runs);
  EXPECT_SAYS(c.verdict, "there is nothing to rank");
  EXPECT_EQ(joined(c.verdict).find("?"), std::string::npos) << joined(c.verdict);
}

TEST(Verdict, NamesTheTimeWhereTheSlowerOneBegins) {
  Generator random(11);
  Runs runs = made_runs({}, {{"a", 0.05}, {"b", 0.4}}, random);
  runs.budgets = {"1k", "2k", "4k", "8k"};
  for (compare::Run& run : runs.runs)
    if (run.contender == 1) run.seconds *= 3;
  EXPECT_SAYS(summarize(runs).verdict, "a is ahead of b from 3 s on, where b begins: at 8k ");
}

TEST(Verdict, WarnsOfAReferenceThatIsNoBetter) {
  Generator random(12);
  EXPECT_SAYS(summarize(made_runs({.reference_error = 0.05}, two, random)).cautions,
              "is not small against the least that is measured");
  // Of squares: a fifth of the least error is a twenty-fifth of its square, less than a tenth.
  const MadeScene better{.bins = 64, .seconds = {1}, .reference_error = 0.02};
  for (const std::string& caution :
       summarize(made_runs(better, {{"a", 0.1}, {"b", 0.2}}, random)).cautions)
    EXPECT_EQ(caution.find("is not small against"), std::string::npos) << caution;
}

TEST(Verdict, WarnsOfReplicatesThatDisagree) {
  Generator random(13);
  Runs runs = made_runs({}, two, random);
  for (compare::Run& run : runs.runs)  // one replicate misses half of the light, and does not know
    if (run.contender == 0 && run.replicate == 5)
      for (double& value : run.film.value) value -= 0.5;
  const Comparison c = summarize(runs);
  EXPECT_SAYS(c.cautions, "Replicates differ by more than their own error bars say");
}

TEST(Verdict, WarnsOfBiasAndOfErrorsThatDoNotFall) {
  Generator random(14);
  const Comparison c = summarize(made_runs({}, {{"a", 0.1, 0.2}, {"b", 0.1}}, random));
  EXPECT_SAYS(c.cautions, "the mean of the replicates is not the reference");
  EXPECT_SAYS(c.cautions, "The runs' own 95 % intervals hold the reference less often: a");
  EXPECT_SAYS(c.cautions,
              "The error does not fall like 1/√t, a slope of −0.5, so that nothing is "
              "extrapolated: a (");
}

TEST(Verdict, WarnsOfUnreliableBins) {
  Generator random(15);
  Runs runs = made_runs({}, two, random);
  for (compare::Run& run : runs.runs) run.film.reliable.assign(16, false);
  EXPECT_SAYS(summarize(runs).cautions, "Few bins of a run are reliable: a (0 %), b (0 %).");
}

}  // namespace
}  // namespace wander::test::hard_cases_test

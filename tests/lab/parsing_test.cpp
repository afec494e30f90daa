#include "lab/parsing.h"

#include <gtest/gtest.h>

#include "lab/failure.h"
#include "lab/shell_words.h"
#include "lab/wording.h"
#include "tools/progress.h"

namespace wander {
namespace {

std::uint64_t samples(std::string_view text) {
  return std::get<SampleBudget>(parse_budget(text)).samples;
}

double seconds(std::string_view text) { return std::get<TimeBudget>(parse_budget(text)).seconds; }

TEST(Budget, CountsAndTimesHaveUnits) {
  EXPECT_EQ(samples("2000000"), 2000000U);
  EXPECT_EQ(samples("300k"), 300000U);
  EXPECT_EQ(samples("5M"), 5000000U);
  EXPECT_EQ(samples("1.1k"), 1100U);
  EXPECT_EQ(samples("1e6"), 1000000U);
  EXPECT_EQ(seconds("30s"), 30);
  EXPECT_EQ(seconds("1.5s"), 1.5);
  EXPECT_EQ(seconds("1500ms"), 1.5);
  EXPECT_EQ(seconds("5min"), 300);
  EXPECT_EQ(seconds("2h"), 7200);
}

TEST(Budget, AnErrorIsAShareOrInPercent) {
  const auto error = [](std::string_view text) {
    return std::get<ErrorBudget>(parse_budget(text)).relative;
  };
  EXPECT_EQ(error("error<0.05"), 0.05);
  EXPECT_EQ(error("error<5%"), 0.05);
  EXPECT_EQ(error("error<0.5%"), 0.005);
  EXPECT_EQ(parse_share("--target", "2%"), 0.02);
}

TEST(Budget, TimeIsOfTheWallOrOfTheProcessors) {
  EXPECT_EQ(std::get<TimeBudget>(parse_budget("30s")).kind, TimeKind::wall);
  const TimeBudget budget = std::get<TimeBudget>(parse_budget("1.5cpu-s"));
  EXPECT_EQ(budget.seconds, 1.5);
  EXPECT_EQ(budget.kind, TimeKind::processor);
  for (const char* text : {"cpu-s", "30cpu-", "30cpu", "30cpus", "0cpu-s", "30scpu-", "30cpu-cpu-s",
                           "30cpu-k", "30cpu-M"})
    EXPECT_THROW(parse_budget(text), UsageError) << text;
}

TEST(Budget, EverythingElseIsAUsageError) {
  for (const char* text :
       {"",        "soon",     "s",       "M",       "0",       "-5",        "-1s",    "0s",
        "1.5",     "5 M",      "5Mx",     "nan",     "infs",    "inf",       "1e400s", "1e30",
        "0.1",     "+5",       "error<0", "error<1", "error<x", "error>0.1", "5m",     "error<100%",
        "error<%", "error<0%", "min",     "0h",      "5%"})
    EXPECT_THROW(parse_budget(text), UsageError) << text;
}

TEST(Mutations, WeightsAreRelativeAndAutoIsAll) {
  EXPECT_TRUE(parse_mutations("auto").empty());
  EXPECT_EQ(parse_mutations("bidirectional=1,primary=0.5"),
            (MutationWeights{{"bidirectional", 1}, {"primary", 0.5}}));
  EXPECT_EQ(parse_mutations("primary=2"), (MutationWeights{{"primary", 2}}));
}

TEST(Mutations, ABadSpecIsAUsageError) {
  for (const char* text : {"", "bidirectional", "bidirectional=", "bidirectional=x", "nope=1",
                           "bidirectional=-1", "bidirectional=0", "bidirectional=1,", "primary=nan",
                           "primary=inf", "primary=1,primary=2", "bidirectional=1;primary=1"})
    EXPECT_THROW(parse_mutations(text), UsageError) << text;
}

TEST(Mutations, ParametersFollowTheWeightOfTheirWord) {
  EXPECT_EQ(parse_mutations("lens=1:angle=1e-5..0.1:position=0.01..0.5,primary=2:step=0.001..0.25"),
            (MutationWeights{{"lens", 1, {{"angle", 1e-5, 0.1}, {"position", 0.01, 0.5}}},
                             {"primary", 2, {{"step", 0.001, 0.25}}}}));
}

TEST(Mutations, ABadParameterIsAUsageError) {
  for (const char* text :
       {"lens=1:angle", "lens=1:angle=", "lens=1:angle=0.1", "lens=1:angle=0.1..",
        "lens=1:angle=..1", "lens=1:angle=0.2..0.1", "lens=1:angle=0..0.1", "lens=1:angle=0.1..4",
        "lens=1:angel=0.1..1", "lens=1:step=0.1..0.2", "lens=1:angle=0.1..0.2:angle=0.1..0.2",
        "lens=1:", "lens:angle=0.1..1", "bidirectional=1:angle=0.1..0.2", "primary=1:step=0.1..0.6",
        "lens=1:angle=nan..1"})
    EXPECT_THROW(parse_mutations(text), UsageError) << text;
}

TEST(Mutations, AnUnknownParameterIsAnsweredWithTheNearest) {
  try {
    parse_mutations("lens=1:angel=0.1..1");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(), std::string("--mutations: unknown parameter of lens \"angel\"; did you "
                                        "mean \"angle\"? allowed are position, angle"));
  }
}

TEST(Estimator, IsOneOfTwoWords) {
  EXPECT_EQ(parse_estimator("kelemen"), StepEstimator::kelemen);
  EXPECT_EQ(parse_estimator("expected"), StepEstimator::expected);
  EXPECT_THROW(parse_estimator("usual"), UsageError);
}

TEST(Number, OptionsTakeWholeNumbersInTheirRange) {
  EXPECT_EQ(parse_seed("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(parse_threads("3"), 3);
  EXPECT_EQ(parse_max_vertices("2"), 2);
  for (const char* text : {"", "-1", "1.5", "x", "18446744073709551616", " 1"})
    EXPECT_THROW(parse_seed(text), UsageError) << text;
  for (const char* text : {"0", "-1", "100000", "2x"})
    EXPECT_THROW(parse_threads(text), UsageError) << text;
  EXPECT_THROW(parse_max_vertices("1"), UsageError);
}

TEST(Quoting, AShellReadsTheQuotedLineBack) {
  const char* arguments[] = {"/usr/bin/wander", "render", "my scene.json", "it's", "", "-b", "5M"};
  EXPECT_EQ(quoted_for_shell(7, arguments), "wander render 'my scene.json' 'it'\\''s' '' -b 5M");
}

TEST(Progress, ABarShowsRateAndTimeLeft) {
  EXPECT_EQ(bar_of({0.5, 2'000'000, 4, "sampling"}),
            "[###############...............]  50 %  sampling  500 k/s  4 s left");
  EXPECT_EQ(bar_of({0, 0, 0, "seed pass"}), "[..............................]   0 %  seed pass");
}

TEST(Progress, AReportIsOneLineOfJson) {
  EXPECT_EQ(json_line_of({0.5, 100, 2, "sampling"}),
            R"({"phase":"sampling","fraction":0.5,"samples":100,"seconds":2.0,)"
            R"("samples_per_second":50.0})");
}

TEST(Wording, NumbersReadNaturally) {
  EXPECT_EQ(count_in_words(950), "950");
  EXPECT_EQ(count_in_words(999'999), "1 M");
  EXPECT_EQ(count_in_words(1'210'000), "1.21 M");
  EXPECT_EQ(duration_in_words(185), "3 min 5 s");
  EXPECT_EQ(duration_in_words(7260), "2 h 1 min");
  EXPECT_EQ(percent(0.0123), "1.23 %");
}

}  // namespace
}  // namespace wander

// The summary of `wander check`: what passed, what failed, and what could not be tested and why.
#include "tools/check_report.h"

#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

Decision decided(bool passed) {
  Decision decision;
  decision.passed = passed;
  decision.statistic = passed ? 1 : 1234;
  decision.threshold = 6;
  decision.comparisons = 9;
  return decision;
}

Decision undecided() {
  Decision decision;
  decision.comparisons = 0;
  return decision;
}

CheckReport report_of(bool flux_passes) {
  InvarianceReport lens;
  lens.one_step = decided(true);
  lens.many_steps = undecided();
  lens.flux = decided(flux_passes);
  lens.starts = 500;
  lens.acted = lens.moved = 40;
  MethodCheck pt, lt;
  pt.method = "pt";
  pt.verdict = Verdict::passed;
  pt.decision = decided(true);
  pt.bins = 12;
  lt.method = "lt";
  lt.reason = "it sees nothing";
  CheckReport report;
  report.samples = 1000;
  report.steps = 20;
  report.false_alarm = 1e-6;
  report.mutations = {{"lens", lens}};
  report.methods = {pt, lt};
  return report;
}

TEST(CheckReport, CountsWhatCouldNotBeTestedAndSaysWhy) {
  const std::string text = text_of(report_of(true));
  EXPECT_HAS(text, "3 tests passed, 0 failed, 2 could not be made:\n");
  EXPECT_HAS(text, "  lens, after 20 steps: it moved 40 of 500 paths");
  EXPECT_HAS(text, "  lt, against bdpt: it sees nothing\n");
  EXPECT_HAS(text, "with a probability of 10⁻⁶\n");
  EXPECT_HAS(text, "of 9 reliable bins, the other 3 are not");
  EXPECT_LACKS(text, "nothing failed");
}

TEST(CheckReport, SaysHowManyTestsFailed) {
  const std::string text = text_of(report_of(false));
  EXPECT_HAS(text, "FAILED: 2 tests passed, 1 failed, 2 could not be made:\n");
  EXPECT_HAS(text, "|z| is 1230, threshold 6.0");
}

TEST(CheckReport, HasTheSameInItsDocument) {
  const auto json = json_of(report_of(true));
  EXPECT_EQ(json["passed"], true);
  EXPECT_EQ(json["tests"]["passed"], 3);
  EXPECT_EQ(json["tests"]["failed"], 0);
  EXPECT_EQ(json["tests"]["could_not_be_made"], 2);
  ASSERT_EQ(json["not_tested"].size(), 2u);
  EXPECT_EQ(json["not_tested"][0]["name"], "lens");
  EXPECT_EQ(json["not_tested"][0]["tests"][0], "after 20 steps");
  EXPECT_EQ(json["not_tested"][1]["name"], "lt");
  EXPECT_EQ(json["not_tested"][1]["reason"], "it sees nothing");
}

TEST(CheckReport, ThatHasNoTestHasNotPassed) {
  CheckReport report = report_of(true);
  EXPECT_TRUE(report.passed());
  report.methods.erase(report.methods.begin());
  report.mutations.front().report.one_step = report.mutations.front().report.flux = undecided();
  EXPECT_FALSE(report.passed());
  EXPECT_HAS(text_of(report),
             "NOTHING COULD BE TESTED: 0 tests passed, 0 failed, 4 could not be made:\n");
  EXPECT_FALSE(report_of(false).passed());
}

// ---- as it goes

TEST_F(CommandLine, CheckSaysWhatItDoesAsItGoes) {
  const std::string arguments = "check box.json --samples 500 --mutations bidirectional=1 ";
  const Outcome plain = wander(arguments);
  EXPECT_EQ(plain.exit_code, 0) << plain.err;
  for (const char* part :
       {"mutation bidirectional", "film by bdpt, the reference", "film by pt", "film by mlt"})
    EXPECT_HAS(plain.err, part);
  EXPECT_EQ(wander(arguments + "-q").err, "");
  const Outcome lines = wander(arguments + "--progress json");
  EXPECT_HAS(lines.err, R"({"phase":"mutation bidirectional","fraction":0.0)");
}

}  // namespace
}  // namespace wander::test

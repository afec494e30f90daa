// Who takes part in a comparison, and the small languages of its options.
#include "lab/compare/lineup.h"

#include <gtest/gtest.h>

#include <functional>

#include "lab/compare/budgets.h"
#include "lab/failure.h"

namespace wander::compare {
namespace {

std::vector<std::string> labels(const std::vector<Entrant>& entrants) {
  std::vector<std::string> result;
  for (const Entrant& entrant : entrants) result.push_back(entrant.contender.label);
  return result;
}

std::vector<Entrant> line_up(std::string_view methods, const std::vector<std::string>& fixed,
                             const std::vector<std::string>& sweeps,
                             std::optional<int> max_vertices = std::nullopt) {
  std::vector<Setting> settings;
  std::vector<Sweep> parsed;
  for (const std::string& text : fixed) settings.push_back(parse_setting(text));
  for (const std::string& text : sweeps) parsed.push_back(parse_sweep(text));
  return line_up(parse_methods(methods), settings, parsed, max_vertices);
}

using Words = std::vector<std::string>;

TEST(Budgets, AreWrittenAsTheyAreGiven) {
  for (const char* text : {"0.25s", "48s", "0.3cpu-s", "20000000"})
    EXPECT_EQ(text_of(parse_budgets(text).front().budget), text);
  // Three times a tenth is not three tenths.
  EXPECT_EQ(text_of(budget_of(3 * 0.1, TimeBudget{0.1})), "0.3s");
}

TEST(LineUp, WithoutSweepsIsTheMethods) {
  const auto entrants = line_up("pt,bdpt", {}, {});
  EXPECT_EQ(labels(entrants), (Words{"pt", "bdpt"}));
  EXPECT_EQ(entrants[1].contender.method, "bdpt");
  EXPECT_EQ(entrants[1].contender.dial, "");
}

TEST(LineUp, ASweepAddsItsValuesToTheMethodsThatHaveTheDial) {
  const auto entrants = line_up("bdpt,pssmlt", {}, {"estimator=kelemen,expected"});
  EXPECT_EQ(labels(entrants),
            (Words{"bdpt", "pssmlt estimator=kelemen (default)", "pssmlt estimator=expected"}));
  EXPECT_EQ(entrants[2].contender.dial, "estimator");
  EXPECT_EQ(entrants[2].contender.setting, "expected");
  EXPECT_EQ(entrants[2].dials.estimator, StepEstimator::expected);
  EXPECT_EQ(entrants[1].dials.estimator, StepEstimator::usual);
}

// Made twice, the base point would cost its runs again and be ahead of itself by chance.
TEST(LineUp, ASettingThatIsTheBasePointIsMadeOnceAndRecognised) {
  EXPECT_EQ(labels(line_up("mlt", {}, {"large_step=0.1,0.3"})),
            (Words{"mlt large_step=0.3 (default)", "mlt large_step=0.1"}));
  EXPECT_EQ(
      labels(line_up("mlt", {}, {"large_step=0.05,0.30", "kernel=auto,2"})),
      (Words{"mlt large_step=0.30 kernel=auto (default)", "mlt large_step=0.05", "mlt kernel=2"}));
  EXPECT_EQ(labels(line_up("mlt", {"kernel=2"}, {"kernel=1,2"})),
            (Words{"mlt kernel=2 (base)", "mlt kernel=1"}));
  EXPECT_EQ(labels(line_up("pssmlt,mmlt", {}, {"estimator=expected"})),
            (Words{"pssmlt", "pssmlt estimator=expected", "mmlt estimator=expected (default)"}));
  EXPECT_EQ(
      labels(line_up("mlt", {"mutations=lens=1,primary=2"}, {"mutations=primary=4,lens=2;auto"})),
      (Words{"mlt mutations=primary=4,lens=2 (base)", "mlt mutations=auto"}));
  EXPECT_EQ(labels(line_up("mlt", {}, {"mutations=auto;"})),
            (Words{"mlt mutations=auto (default)"}));
  const auto entrants = line_up("mlt", {}, {"large_step=0.1,0.3"});
  EXPECT_EQ(entrants[0].contender.dial, "");
}

TEST(LineUp, TheLengthThatTheSceneSaysIsTheUsual) {
  EXPECT_EQ(labels(line_up("pt", {}, {"max_vertices=5,8"}, 8)),
            (Words{"pt max_vertices=8 (default)", "pt max_vertices=5"}));
  EXPECT_EQ(labels(line_up("pt", {}, {"max_vertices=5,8"})),
            (Words{"pt", "pt max_vertices=5", "pt max_vertices=8"}));
}

TEST(LineUp, SweepsAreMadeOneAfterTheOtherFromTheBasePoint) {
  const auto entrants =
      line_up("mmlt", {"max_vertices=5"}, {"max_vertices=3,4", "estimator=kelemen"});
  EXPECT_EQ(labels(entrants), (Words{"mmlt", "mmlt max_vertices=3", "mmlt max_vertices=4",
                                     "mmlt estimator=kelemen"}));
  EXPECT_EQ(entrants[0].dials.max_vertices, 5);
  EXPECT_EQ(entrants[2].dials.max_vertices, 4);
  EXPECT_EQ(entrants[3].dials.max_vertices, 5);
  EXPECT_EQ(entrants[3].dials.estimator, StepEstimator::kelemen);
  EXPECT_EQ(entrants[2].settings.size(), 1u);  // the swept value alone
  EXPECT_EQ(entrants[3].settings.size(), 2u);
}

TEST(LineUp, AFixedDialTurnsTheMethodsThatHaveIt) {
  const auto entrants = line_up("bdpt,mlt", {"mutations=lens=1,primary=2"}, {});
  EXPECT_TRUE(entrants[0].dials.mutations.empty());
  EXPECT_EQ(entrants[1].dials.mutations.size(), 2u);
  EXPECT_EQ(entrants[1].contender.label, "mlt");
}

TEST(Sweeps, PartValuesWithCommasBySemicolons) {
  EXPECT_EQ(parse_sweep("max_vertices=3,4,5").values, (Words{"3", "4", "5"}));
  EXPECT_EQ(parse_sweep("mutations=lens=1,primary=1;auto").values,
            (Words{"lens=1,primary=1", "auto"}));
  EXPECT_EQ(parse_sweep("mutations=lens=1,primary=1;").values, (Words{"lens=1,primary=1"}));
}

std::string usage_error(const std::function<void()>& call) {
  try {
    call();
  } catch (const UsageError& problem) {
    return problem.what();
  }
  return "";
}

TEST(LineUp, RefusesWhatIsNot) {
  EXPECT_NE(usage_error([] { parse_sweep("estimatr=kelemen"); }).find("\"estimator\""),
            std::string::npos);
  EXPECT_NE(usage_error([] { parse_methods("bdpt,mtl"); }).find("\"mlt\""), std::string::npos);
  EXPECT_NE(usage_error([] { parse_sweep("max_vertices"); }).find("max_vertices="),
            std::string::npos);
  for (const char* text :
       {"max_vertices=", "max_vertices=3,,4", "max_vertices=x", "max_vertices=;"})
    EXPECT_NE(usage_error([&] { parse_sweep(text); }), "") << text;
  for (const char* text : {"max_vertices", "max_vertices=1", "estimator=both", "=1", ""})
    EXPECT_NE(usage_error([&] { parse_setting(text); }), "") << text;
  EXPECT_NE(usage_error([] { parse_methods(""); }), "");
}

TEST(LineUp, RefusesADialThatNoMethodHas) {
  EXPECT_NE(usage_error([] { line_up("bdpt", {}, {"estimator=kelemen"}); }), "");
  EXPECT_NE(usage_error([] { line_up("bdpt", {"mutations=lens=1"}, {}); }), "");
}

// By the words of this verb, which has no options of dials.
TEST(LineUp, NamesADialAsItIsTurned) {
  EXPECT_EQ(usage_error([] { line_up("bdpt", {}, {"chains=64"}); }),
            "--sweep: chains is for mlt and pssmlt; bdpt does not have it");
  const std::string refused = usage_error([] { line_up("mlt", {"chains=65"}, {}); });
  EXPECT_TRUE(refused.starts_with("--dial: chains '65': ")) << refused;
  EXPECT_EQ(refused.find("--chains"), std::string::npos) << refused;
}

TEST(LineUp, RefusesTheSameContenderTwice) {
  EXPECT_NE(usage_error([] { line_up("bdpt,bdpt", {}, {}); }).find("twice"), std::string::npos);
  EXPECT_NE(usage_error([] { line_up("bdpt", {}, {"max_vertices=3,3"}); }), "");
  EXPECT_NE(usage_error([] { line_up("mlt", {}, {"large_step=0.1,0.10"}); }), "");
  EXPECT_NE(usage_error([] { line_up("mlt", {}, {"large_step=0.3,0.3"}); }), "");
}

TEST(LineUp, RefusesADialThatIsTurnedTwice) {
  EXPECT_EQ(usage_error([] {
              line_up("mlt", {"chains=128", "chains=512"}, {});
            }),
            "--dial turns chains twice, to 128 and to 512; leave one, or sweep it: --sweep "
            "'chains=128;512'");
  EXPECT_NE(usage_error([] { line_up("mlt", {"chains=128", "chains=128"}, {}); }), "");
  EXPECT_EQ(usage_error([] { line_up("mlt", {"chains=128", "large_step=0.5"}, {}); }), "");
}

TEST(Budgets, AreSortedAndAllOfOneKind) {
  const auto budgets = parse_budgets("4s,0.25s,1s");
  ASSERT_EQ(budgets.size(), 3u);
  EXPECT_EQ(budgets[0].text, "0.25s");
  EXPECT_EQ(budgets[2].text, "4s");
  EXPECT_EQ(effort_of(parse_budgets("20k")[0].budget), 20000);
  for (const char* text : {"1s,20k", "1s,1.0s", "2k,2000", "", "1s,", "soon", "1s,2cpu-s"})
    EXPECT_NE(usage_error([&] { parse_budgets(text); }), "") << text;
}

TEST(Budgets, AreReadBackFromTheirText) {
  for (const char* text : {"0.75s", "36s", "36cpu-s", "240000"}) {
    const Budget budget = parse_budgets(text)[0].budget;
    EXPECT_EQ(text_of(budget), text);
    EXPECT_EQ(effort_of(budget_of(2 * effort_of(budget), budget)), 2 * effort_of(budget));
  }
}

}  // namespace
}  // namespace wander::compare

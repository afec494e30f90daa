// How long a comparison is said to take.
#include "lab/compare/forecast.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lab/compare/trial.h"

namespace wander::compare {
namespace {

Plan plan_of(const char* budgets) {
  return {.source = "box.json",
          .entrants = line_up(parse_methods("bdpt,mlt"), {}, {}, std::nullopt),
          .budgets = parse_budgets(budgets),
          .replicates = 8};
}

// Of a comparison that begins.
Forecast of_all(const Plan& plan, const Paces& paces = {}) {
  return forecast(plan, paces, turns_to_come(plan, {}));
}

TEST(Forecast, OfSecondsIsTheirSum) {
  Forecast ahead = of_all(plan_of("0.25s,1s,4s"));
  EXPECT_DOUBLE_EQ(ahead.of_runs, 84);
  EXPECT_DOUBLE_EQ(ahead.longest, 4);
  EXPECT_EQ(in_words(ahead), "48 runs of 0.25s, 1s, 4s: about 1 min 24 s");
  ahead.of_reference = 96;
  EXPECT_EQ(in_words(ahead),
            "48 runs of 0.25s, 1s, 4s, and a reference of about 1 min 36 s: about 3 min 0 s");
}

TEST(Forecast, OfSamplesIsByThePaceOfEach) {
  const Paces paces{{.of_sample = 1e-6},
                    {.of_sample = 2e-6, .of_seed = 4e-6, .seed_share = 0.25, .fewest_seeds = 5e5}};
  const Forecast ahead = of_all(plan_of("1M,4M"), paces);
  EXPECT_DOUBLE_EQ(ahead.of_runs, 8 * (1 + 4 + (2 + 2) + (8 + 4)));
  EXPECT_DOUBLE_EQ(ahead.longest, 12);
}

TEST(Forecast, OfAComparisonThatIsCarriedOnIsOfWhatIsToCome) {
  const Plan plan = plan_of("1s,4s");
  std::vector<Turn> turns = turns_to_come(plan, {});
  turns.erase(turns.begin(), turns.end() - 2);
  const Forecast ahead = forecast(plan, {}, turns);
  EXPECT_EQ(ahead.runs, 2u);
  EXPECT_DOUBLE_EQ(ahead.of_runs, 8);
  EXPECT_DOUBLE_EQ(ahead.longest, 4);
}

TEST(Forecast, IsALineOfProgress) {
  Forecast ahead = of_all(plan_of("1s"));
  ahead.of_reference = 24;
  const auto line = nlohmann::json::parse(json_line_of(ahead));
  EXPECT_EQ(line["phase"], "forecast");
  EXPECT_EQ(line["fraction"], 0);
  EXPECT_EQ(line["runs"], 16);
  EXPECT_EQ(line["expected_seconds"], 40);
  EXPECT_EQ(line["expected_seconds_of_reference"], 24);
}

}  // namespace
}  // namespace wander::compare

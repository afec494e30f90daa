// Who makes a reference, how long, and when what is known does.
#include "lab/compare/long_reference.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace wander::compare::long_reference_test {
namespace {

Plan plan_of(const char* budgets) {
  return {.source = "box.json",
          .entrants = line_up(parse_methods("mlt"), {}, {}, std::nullopt),
          .budgets = parse_budgets(budgets),
          .replicates = 8};
}

// 1000 samples a second of the first, 500 of the second.
const std::vector<Worth> worths{{"bdpt", 4, 1e-3}, {"pt", 2, 2e-3}, {"mlt", 1, 4e-3}};

LongRuns known(const char* made_by, std::uint64_t samples, std::uint64_t seed = 1) {
  LongRuns runs{made_by, {}};
  runs.runs.push_back({.samples = samples, .seed = seed, .film = {}});
  return runs;
}

std::vector<std::string> makers(const LongPlan& plan) {
  std::vector<std::string> names;
  for (const Maker& maker : plan.makers) names.push_back(maker.worth.method);
  return names;
}
using Names = std::vector<std::string>;

TEST(LongReference, IsMadeByTheBestTwoEvenIfTheyAreNoContenders) {
  const LongPlan plan = plan_reference(plan_of("1s,4s"), worths, {}, 4);
  EXPECT_EQ(makers(plan), (Names{"bdpt", "pt"}));
  EXPECT_EQ(plan.more, 2u);
  EXPECT_DOUBLE_EQ(plan.seconds, 3 * 8 * 4);
  EXPECT_DOUBLE_EQ(effort_of(plan), plan.seconds);
}

TEST(LongReference, WithSamplesBothTakeEquallyLong) {
  const LongPlan plan = plan_reference(plan_of("1M"), worths, {}, 10);
  EXPECT_DOUBLE_EQ(effort_of(plan.makers[0].budget), 0.75 * 8 * 10 / 1e-3);
  EXPECT_DOUBLE_EQ(effort_of(plan.makers[1].budget), 0.75 * 8 * 10 / 2e-3);
  EXPECT_DOUBLE_EQ(plan.seconds, 3 * 8 * 10);
}

TEST(LongReference, OfOneMethodWhereNoOtherFindsLight) {
  EXPECT_EQ(makers(plan_reference(plan_of("1s"), {{"mlt", 1, 1e-3}, {"bdpt", 0, 1e-3}}, {}, 1)),
            (Names{"mlt"}));
  EXPECT_EQ(makers(plan_reference(plan_of("1s"),
                                  {{"bdpt", 0, 1e-3}, {"pt", 0, 1e-3}, {"lt", 0, 1e-3}}, {}, 1)),
            (Names{"bdpt", "pt"}));
}

// Fresh runs would have 48 s × 1000 and 48 s × 500 samples.
TEST(LongReference, WhatIsKnownDoesIfItIsWorthEnough) {
  const auto more = [](std::uint64_t of_bdpt, std::uint64_t of_pt) {
    return plan_reference(plan_of("4s"), worths, {known("bdpt", of_bdpt), known("pt", of_pt)}, 4)
        .more;
  };
  EXPECT_EQ(more(48'000, 24'000), 0u);
  EXPECT_EQ(more(22'000, 11'000), 0u);
  EXPECT_EQ(more(21'000, 10'000), 2u);
}

TEST(LongReference, OneKnownMethodIsNotEnough) {
  EXPECT_EQ(plan_reference(plan_of("4s"), worths, {known("mlt", 1'000'000'000)}, 4).more, 2u);
  const LongPlan plan =
      plan_reference(plan_of("4s"), worths, {known("mlt", 1'000'000'000), known("pt", 1'000)}, 4);
  EXPECT_EQ(makers(plan), (Names{"bdpt", "pt"}));
  const LongPlan other =
      plan_reference(plan_of("4s"), worths, {known("mlt", 1'000'000'000), known("pt", 24'000)}, 4);
  EXPECT_EQ(makers(other), (Names{"mlt", "pt"}));
  EXPECT_EQ(other.more, 0u);
}

TEST(LongReference, FreshRunsAreAddedToWhatIsKnownAndHaveOtherSeeds) {
  const LongPlan plan =
      plan_reference(plan_of("4s"), worths,
                     {known("bdpt", 10, 5), known("mlt --mutations lens=1", 1'000'000'000, 6)}, 4);
  EXPECT_EQ(makers(plan), (Names{"bdpt", "pt"}));
  EXPECT_EQ(plan.makers.front().runs.runs.size(), 1u);
  EXPECT_EQ(plan.taken_seeds, (std::vector<std::uint64_t>{5, 6}));
}

}  // namespace
}  // namespace wander::compare::long_reference_test

// Which methods are worth most, of made runs whose truth is known.
#include "lab/compare/trial.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lab/scene_source.h"
#include "tests/lab/compare/made_runs.h"

namespace wander::test::trial_test {
namespace {

using namespace compare;

struct MadeCandidate {
  std::string method;
  double error = 0.1, seconds = 1;
  double found = 1;  // of the light of the last bin
};

// Four runs of 1000 samples each, of 16 bins of light 1 and a last one of light 5.
Candidate made(const MadeCandidate& given, Generator& random) {
  Candidate candidate{given.method};
  for (int r = 0; r < 4; ++r) {
    std::vector<double> value = independent_errors(random, 17);
    for (double& x : value) x = 1 + given.error * x;
    value.back() += 4 * given.found;
    Rendering run{.samples = 1000, .seconds = given.seconds, .film = {}};
    run.film = made_film(std::move(value), given.error);
    candidate.runs.push_back(std::move(run));
  }
  return candidate;
}

std::vector<std::string> order(const std::vector<MadeCandidate>& given, std::uint64_t seed) {
  Generator random(seed);
  std::vector<Candidate> candidates;
  for (const MadeCandidate& g : given) candidates.push_back(made(g, random));
  std::vector<std::string> names;
  for (const Worth& worth : ranked(candidates)) names.push_back(worth.method);
  return names;
}

using Names = std::vector<std::string>;

TEST(Trial, TheMostEfficientIsFirst) {
  // Variance × time: 1, 0.5 and 4, in the units of the first.
  EXPECT_EQ(order({{"a", 0.1, 1}, {"b", 0.05, 2}, {"c", 0.2, 1}}, 1), (Names{"b", "a", "c"}));
}

TEST(Trial, InformationIsOfOneSampleInOneUnit) {
  Generator random(2);
  const auto worths = ranked({made({"a", 0.1}, random), made({"b", 0.2}, random)});
  EXPECT_NEAR(worths[0].information / worths[1].information, 4, 1.5);
  EXPECT_DOUBLE_EQ(worths[0].seconds, 1e-3);
}

// It claims a hundredth of the variance, for what it misses it does not know.
TEST(Trial, AMethodThatMissesLightIsLast) {
  const std::vector<MadeCandidate> honest{{"a", 0.1}, {"b", 0.2}, {"c", 0.01, 1, 0.0}};
  EXPECT_EQ(order(honest, 3), (Names{"a", "b", "c"}));
  const std::vector<MadeCandidate> all_found{{"a", 0.1}, {"b", 0.2}, {"c", 0.01}};  // control
  EXPECT_EQ(order(all_found, 3).front(), "c");
}

TEST(Trial, AFireflyIsNoLightThatOthersMiss) {
  Generator random(4);
  std::vector<Candidate> candidates{made({"a", 0.1}, random), made({"b", 0.2}, random)};
  Candidate fireflies = made({"c", 0.1}, random);
  fireflies.runs[2].film.value[5] += 100;
  fireflies.runs[2].film.standard_error[5] = 100;
  candidates.push_back(fireflies);
  const auto worths = ranked(candidates);
  EXPECT_EQ(worths.front().method, "a");
  EXPECT_EQ(worths.back().method, "c");
  EXPECT_GT(worths.front().information, 100 * worths.back().information);
}

TEST(Trial, WhatFindsNothingIsWorthNothing) {
  Generator random(5);
  Candidate dark = made({"dark"}, random);
  for (Rendering& run : dark.runs) run.film = made_film(std::vector<double>(17, 0.0), 0);
  const auto worths = ranked({dark, made({"a"}, random)});
  EXPECT_EQ(worths.back().method, "dark");
  EXPECT_EQ(worths.back().information, 0);
  EXPECT_EQ(ranked({dark}).front().information, 0);
}

// Who is worth anything in the trial of a comparison of such a budget, and how many runs it has.
struct Held {
  std::vector<std::string> methods;
  double runs_of_each;
};
Held held(const char* budget) {
  const Plan plan{.source = "article-2.json",
                  .entrants = line_up(parse_methods("bdpt"), {}, {}, std::nullopt),
                  .budgets = parse_budgets(budget),
                  .replicates = 8};
  const description::Scene scene = open_scene(std::string(gallery_prefix) + "article-2").scene;
  Session session;
  session.threads = 1;
  Course course(scene, session, 1);
  Held trial;
  for (const Worth& worth : hold_trial(plan, course)) trial.methods.push_back(worth.method);
  const double of_a_run = std::max(2000., 0.03 * (effort_of(plan) + reference_effort(plan)) / 24);
  trial.runs_of_each = trial_effort(plan) / of_a_run / static_cast<double>(trial.methods.size());
  return trial;
}

// A hundred samples do not wait for chains to find their seeds.
TEST(Trial, OfASmallComparisonHasNoChains) {
  const auto has = [](const Held& trial, const char* method) {
    return std::ranges::count(trial.methods, method) > 0;
  };
  const Held small = held("100"), large = held("60k");
  EXPECT_TRUE(has(small, "bdpt"));
  EXPECT_FALSE(has(small, "mlt"));
  EXPECT_TRUE(has(large, "mlt"));
  EXPECT_NEAR(small.runs_of_each, 4, 1e-9);
  EXPECT_NEAR(large.runs_of_each, 4, 1e-9);
}

}  // namespace
}  // namespace wander::test::trial_test

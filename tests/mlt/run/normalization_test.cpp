// From what groups found to b, to a film with its error bars, and to an alarm.
#include "mlt/run/normalization.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <list>
#include <numeric>

#include "lab/render.h"
#include "mlt/run/normalized_film.h"
#include "mutations/catalogue.h"
#include "tests/support/expect.h"
#include "tests/support/primary_runs.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

// Groups made by hand: each found paths of l = 1 in its samples, and its chains deposited in two
// bins, for two lengths.
class Groups {
 public:
  // `found` paths in 10 samples; deposits of paths of two vertices in the first bin, of three in
  // the second.
  void add(int found, double first, double second) {
    Held& group = held_.emplace_back();
    group.tally.samples = 10;
    for (int i = 0; i < found; ++i) {
      group.tally.total += 1;
      group.tally.total_squares += 1;
      group.tally.sum[0] += 1;
      group.tally.squares[0] += 1;
      group.evidence.ratios[0].add(1);
      group.evidence.film[0] += 1;
      *entries_of(group.evidence.by_class, group.evidence.classes.index(0b1)) += 1;
    }
    group.states.add(1);
    if (first > 0) group.film.add(2, 0, first);
    if (second > 0) group.film.add(3, 1, second);
    findings_.push_back({&group.tally,
                         &group.tally,
                         &group.evidence,
                         &group.film,
                         {},
                         first + second > 0 ? 1.0 : 0.0,
                         {{&group.states, 1.0}},
                         {{0b1, first}, {0b10, second}}});
  }
  std::span<const GroupFindings> findings() const { return findings_; }
  // Of chains whose states have no class.
  std::vector<GroupFindings> without_classes() const {
    std::vector<GroupFindings> result = findings_;
    for (GroupFindings& group : result) group.classes.clear();
    return result;
  }

 private:
  struct Held {
    SeedTally tally{4};
    SeedEvidence evidence{1, 2};
    GroupFilm film{2, 4};
    RatioHistogram states;
  };
  std::list<Held> held_;
  std::vector<GroupFindings> findings_;
};

// b = 0.3 with its own spread; shares 3/4 and 1/4.
TEST(NormalizedFilm, IsBTimesTheShareOfTheDepositsWithTheErrorOfBoth) {
  Groups groups;
  groups.add(2, 4, 0);
  groups.add(3, 2, 2);
  groups.add(4, 3, 1);
  const Constant b{.b = {0.3, 0.01}, .without = {0.35, 0.3, 0.25}};
  const FilmEstimate film = normalized_film(groups.findings(), b, {2});
  EXPECT_DOUBLE_EQ(film.value[0], 2 * 0.3 * 0.75);
  EXPECT_DOUBLE_EQ(film.value[1], 2 * 0.3 * 0.25);
  // Without each group: shares 5/8, 7/8, 6/8 of the first bin.
  const std::vector<double> first{2 * 0.35 * 5 / 8, 2 * 0.3 * 7 / 8, 2 * 0.25 * 6 / 8};
  const double mean = std::accumulate(first.begin(), first.end(), 0.0) / 3;
  double squares = 0;
  for (const double v : first) squares += (v - mean) * (v - mean);
  EXPECT_DOUBLE_EQ(film.standard_error[0], std::sqrt(squares * 2 / 3));
  EXPECT_DOUBLE_EQ(film.by_length.at(2)[0], film.value[0]);
  EXPECT_DOUBLE_EQ(film.by_length.at(3)[1], film.value[1]);
  EXPECT_FALSE(film.reliable[0]) << "three groups";
  EXPECT_LE(film.degrees_of_freedom, 2);
}

TEST(NormalizedFilm, TrustsBinsOfEnoughGroupsAndSamples) {
  Groups groups;
  Constant b{.b = {0.3, 0.015}};
  for (int g = 0; g < 20; ++g) {
    groups.add(3, 100, g == 0 ? 8 : 0);
    b.without.push_back(g % 2 == 0 ? 0.297 : 0.303);
  }
  const FilmEstimate film = normalized_film(groups.findings(), b, {2});
  EXPECT_TRUE(film.reliable[0]);
  EXPECT_FALSE(film.reliable[1]) << "one group alone reached it";
}

// Fifteen that found light, and five that found none, whose error is small enough.
TEST(NormalizedFilm, CountsTheGroupsThatFoundLight) {
  for (const int lit : {15, 16}) {
    Groups groups;
    for (int g = 0; g < 20; ++g) groups.add(3, g < lit ? 10 + g % 2 : 0, g < lit ? 8 : 0);
    const Constant b{.b = {0.3, 0}, .without = std::vector<double>(20, 0.3)};
    const FilmEstimate film = normalized_film(groups.findings(), b, {2});
    EXPECT_GT(film.value[0], 20 * film.standard_error[0]);
    EXPECT_EQ(film.reliable[0], lit == 16);
  }
}

TEST(Constants, AreThreeAndTheSeedPassStandsInForWhatFails) {
  Groups groups;
  for (int g = 0; g < 3; ++g) groups.add(2 + g, 3, 1);  // too few for least squares
  const Constants b = constants(groups.findings());
  EXPECT_DOUBLE_EQ(b.seed_pass.b.value, 0.3);
  EXPECT_DOUBLE_EQ(b.seed_pass.without[0], 0.35);
  EXPECT_FALSE(b.least_squares.failure.empty());
  EXPECT_EQ(b.usable(NormalizationMethod::least_squares), NormalizationMethod::seed_pass);
  EXPECT_EQ(b.usable(NormalizationMethod::bridge), NormalizationMethod::bridge);
  // All l are equal: the chains add nothing.
  EXPECT_NEAR(b.bridge.b.value, 0.3, 1e-9);
  const Normalization record =
      normalization(groups.findings(), b, NormalizationMethod::least_squares);
  EXPECT_EQ(record.method, "seed_pass");
  EXPECT_EQ(record.estimates.size(), 3u);
  EXPECT_FALSE(record.estimates.at("least_squares").failure.empty());
}

TEST(Constants, SharesOfLengthsSumToB) {
  Groups groups;
  for (int g = 0; g < 8; ++g) groups.add(2 + g % 3, 3, 1 + g % 2);
  const Normalization record =
      normalization(groups.findings(), constants(groups.findings()), NormalizationMethod::bridge);
  ASSERT_EQ(record.by_length.size(), 2u);
  EXPECT_NEAR(record.by_length[0].value + record.by_length[1].value, record.value,
              1e-12 * record.value);
  EXPECT_GT(record.by_length[0].standard_error, 0);
}

// Of light that every sample and every state measures alike both have no error.
TEST(ConstantsAlarm, IsNotRaisedByRounding) {
  Groups groups;
  for (int g = 0; g < 32; ++g) groups.add(4 + g % 2, 1, 3);
  Constants b = constants(groups.findings());
  b.seed_pass.b.standard_error = 0;
  b.bridge.b = {b.seed_pass.b.value * (1 + 1e-13), 0};
  EXPECT_EQ(disagreement_of_constants(groups.findings(), b), "");
  b.bridge.b.value = b.seed_pass.b.value * (1 + 1e-6);
  EXPECT_NE(disagreement_of_constants(groups.findings(), b), "");
}

TEST(ConstantsAlarm, NamesTheClassThatTheChainsMissed) {
  Groups groups;
  for (int g = 0; g < 32; ++g) groups.add(4 + g % 2, 1, 3);
  Constants b = constants(groups.findings());
  EXPECT_EQ(disagreement_of_constants(groups.findings(), b), "");
  b.bridge.b = {0.5 * b.seed_pass.b.value, 0.01 * b.seed_pass.b.value};
  const std::string alarm = disagreement_of_constants(groups.findings(), b);
  // The seed pass saw LE alone, a quarter of what the chains saw.
  EXPECT_NE(alarm.find("paths LE "), std::string::npos) << alarm;
  EXPECT_NE(alarm.find("the chains have missed light"), std::string::npos) << alarm;
  b.bridge.b.value = 2 * b.seed_pass.b.value;
  EXPECT_NE(disagreement_of_constants(groups.findings(), b).find("the seed pass has missed light"),
            std::string::npos);
  b.bridge.failure = "none";
  EXPECT_EQ(disagreement_of_constants(groups.findings(), b), "");
}

// Where states have no class, lengths tell.  3 of 4 parts of the chains' light are of three vertices, of which the seed pass saw nothing.
TEST(ConstantsAlarm, NamesTheLengthWhereStatesHaveNoClass) {
  Groups groups;
  for (int g = 0; g < 32; ++g) groups.add(4 + g % 2, 1, 3);
  Constants b = constants(groups.findings());
  b.bridge.b = {b.seed_pass.b.value, 0};
  b.seed_pass.b.standard_error = 0.01 * b.seed_pass.b.value;
  b.bridge.b.value *= 1.2;
  const std::string alarm = disagreement_of_constants(groups.without_classes(), b);
  EXPECT_NE(alarm.find("of 3 vertices (0 by the seed pass"), std::string::npos) << alarm;
}

TEST(ConstantsAlarm, TakesWhatSamplesFoundByClassWhereChainsOfAGroupFoundNoLight) {
  Groups groups;
  groups.add(4, 4, 0);
  groups.add(4, 0, 0);
  Constants b;
  b.seed_pass.b = {0.4, 0.01};
  b.bridge.b = {0.6, 0.01};
  const std::vector<GroupFindings> findings{groups.findings()[0], groups.without_classes()[1]};
  EXPECT_NE(disagreement_of_constants(findings, b).find("paths LE (0.4 by the seed pass, 0.6 by"),
            std::string::npos)
      << disagreement_of_constants(findings, b);
}

// Deposits are light only with the constant of their group: 1 · (3, 1) and 4 · (1, 1) are 7 : 5.
TEST(Constants, SharesOfLengthsKnowTheScaleOfEachGroup) {
  Groups groups;
  groups.add(2, 3, 1);
  groups.add(3, 1, 1);
  std::vector<GroupFindings> findings(groups.findings().begin(), groups.findings().end());
  findings[1].scale = 4;
  const Normalization record =
      normalization(findings, constants(findings), NormalizationMethod::bridge);
  ASSERT_EQ(record.by_length.size(), 2u);
  EXPECT_NEAR(record.by_length[0].value, record.value * 7 / 12, 1e-12);
  EXPECT_NEAR(record.by_length[1].value, record.value * 5 / 12, 1e-12);
}

// Of the seed pass alone, by hand: 10 samples with Σ = 6 and Σ² = 20, of which 5 and 13 are of four
// vertices.
TEST(NormalizationOfATally, IsTheMeanWithItsError) {
  SeedTally tally(4);
  tally.samples = 10;
  tally.total += 6, tally.total_squares += 20;
  tally.sum[2] += 5, tally.squares[2] += 13;
  const Normalization b = normalization(tally);
  EXPECT_DOUBLE_EQ(b.value, 0.6);
  EXPECT_DOUBLE_EQ(b.standard_error, std::sqrt((2 - 0.36) / 9));
  EXPECT_EQ(b.estimates.at("seed_pass").degrees_of_freedom, 9);
  EXPECT_EQ(b.estimates.at("seed_pass").samples, 10u);
  ASSERT_EQ(b.by_length.size(), 1u);
  EXPECT_EQ(b.by_length[0].vertices, 4);
  EXPECT_DOUBLE_EQ(b.by_length[0].value, 0.5);
  EXPECT_DOUBLE_EQ(b.by_length[0].standard_error, std::sqrt((1.3 - 0.25) / 9));
}

// (Σ x)² / Σ x², in whatever unit.
TEST(SeedTallies, KnowHowManySamplesCarryThem) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    SeedTally tally(2);
    tally.samples = 10;
    tally.total += 6 * unit, tally.total_squares += 20 * unit * unit;
    EXPECT_NEAR(tally.effective_samples(), 1.8, 1e-12);
  }
  EXPECT_EQ(SeedTally(2).effective_samples(), 0);
  SeedTally one(2);
  EXPECT_EQ(one.mean(2), 0);
  one.samples = 1;
  one.sum[0] += 3, one.total += 3;
  EXPECT_EQ(one.mean(2), 3);
  EXPECT_EQ(one.mean(), 3);
}

// What a group counts more, all that is said of it counts more, and nothing else of it changes.
TEST(GroupFindings, WeighAllThatTheySay) {
  Groups groups;
  groups.add(2, 3, 1);
  const GroupFindings one = groups.findings()[0], twice = one.weighing(2);
  EXPECT_EQ(weights_of(std::array{one, twice}), (std::vector<double>{1, 2}));
  EXPECT_EQ(twice.scale, 2 * one.scale);
  EXPECT_EQ(twice.states[0].weight, 2 * one.states[0].weight);
  EXPECT_EQ(twice.states[0].ratios, one.states[0].ratios);
  for (std::size_t c = 0; c < 2; ++c) EXPECT_EQ(twice.classes[c].light, 2 * one.classes[c].light);
  EXPECT_EQ(twice.seeds, one.seeds);
  EXPECT_EQ(twice.film, one.film);
}

// Exactly from four standard errors of both together.
TEST(ConstantsAlarm, IsOfMoreThanFourStandardErrors) {
  Groups groups;
  for (int g = 0; g < 32; ++g) groups.add(4 + g % 2, 1, 3);
  Constants b = constants(groups.findings());
  b.seed_pass.b.standard_error = 0.03;
  for (const double side : {-1.0, 1.0})
    for (const double errors : {3.99, 4.01}) {
      b.bridge.b = {b.seed_pass.b.value + side * errors * 0.05, 0.04};
      EXPECT_EQ(disagreement_of_constants(groups.findings(), b).empty(), errors < 4);
    }
}

// Each method in a run: what the record says is the mean of the film, and lengths sum to it.
class NormalizationOfARun : public ::testing::TestWithParam<NormalizationMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, NormalizationOfARun,
                         ::testing::Values(NormalizationMethod::seed_pass,
                                           NormalizationMethod::least_squares,
                                           NormalizationMethod::bridge));

TEST_P(NormalizationOfARun, IsTheMeanOfItsFilm) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  Session session;
  session.budget = SampleBudget{60'000};
  const Rendering r = ChainRenderer(space, make_family({}, space.max_vertices()), session,
                                    ChainSettings{.normalization = GetParam()})
                          .render("mlt");
  ASSERT_TRUE(r.normalization);
  EXPECT_EQ(r.normalization->method, name_of(GetParam()));
  EXPECT_EQ(r.normalization->estimates.size(), 3u);
  double mean = 0, lengths = 0;
  for (const double v : r.film.value) mean += v / static_cast<double>(r.film.value.size());
  for (const LengthShare& share : r.normalization->by_length) lengths += share.value;
  EXPECT_NEAR(r.normalization->value, mean, 1e-9 * mean);
  EXPECT_NEAR(lengths, mean, 1e-9 * mean);
  for (const auto& [name, estimate] : r.normalization->estimates)
    EXPECT_NEAR(estimate.value, mean, 7 * std::hypot(estimate.standard_error, 0.01 * mean)) << name;
}

// Whole samples, and each length by itself: what the seed pass found is the same light.
class NormalizationOfPrimaryChains : public ::testing::TestWithParam<PrimaryMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, NormalizationOfPrimaryChains,
                         ::testing::ValuesIn(primary_methods),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(NormalizationOfPrimaryChains, AgreesWithTheSeedPass) {
  const FlatScene scene = build(diffuse_room());
  const Rendering r = GetParam().render(*scene, budget_of(100'000), {});
  const auto& estimates = r.normalization->estimates;
  const Estimate &bridge = estimates.at("bridge"), &seeds = estimates.at("seed_pass");
  EXPECT_EQ(r.normalization->method, "bridge");
  EXPECT_GT(bridge.value, 0);
  EXPECT_LT(bridge.standard_error, 1.2 * seeds.standard_error);
  // False alarms: 1e-9 for |z| < 6.1, were the two independent; they share the seed pass.
  EXPECT_NEAR(bridge.value, seeds.value,
              6.1 * std::hypot(bridge.standard_error, seeds.standard_error));
  EXPECT_LT(std::abs(bridge.value / seeds.value - 1), 0.05);
}

}  // namespace
}  // namespace wander::test

// Doubts about runs: none about chains that mix, and one about each way of not mixing.
#include "mlt/run/warnings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "core/rng.h"

namespace wander::test {
namespace {

constexpr std::size_t chains_per_group = 4;

struct Kind {
  double phi = 0.5;         // of an autoregression from draw to draw
  double group_offset = 0;  // standard deviation of what a group adds to all its draws
  double late_offset = 0;   // … to its second halves only
  std::size_t groups = 64;
};

// Chains that start in their stationary distribution, of variance 1.
Draws draws_of(const Kind& kind, std::uint64_t seed) {
  Draws draws{kind.groups * chains_per_group, 400, {}};
  Rng random(seed, Purpose::test, 0);
  const auto normal = [&] {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.uniform();
    return sum;
  };
  for (std::size_t g = 0; g < kind.groups; ++g) {
    random.start(g);
    const double offset = kind.group_offset * normal();
    const double late = kind.late_offset * normal();
    for (std::size_t c = 0; c < chains_per_group; ++c) {
      double x = normal();
      for (std::size_t i = 0; i < draws.length; ++i) {
        x = kind.phi * x + std::sqrt(1 - kind.phi * kind.phi) * normal();
        draws.values.push_back(x + offset + (i < draws.length / 2 ? 0 : late));
      }
    }
  }
  return draws;
}

// False alarms: disagreement_false_alarm for each of the 30 runs, 3e-5 in all; the bound of the
// test is on the p-value as it is used.
TEST(Disagreement, IsNotFoundAmongGroupsThatMix) {
  for (const double phi : {0.0, 0.5, 0.9})
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Disagreement found = disagreement(draws_of({.phi = phi}, seed), chains_per_group);
      EXPECT_GT(found.p_value, disagreement_false_alarm) << phi << " " << seed;
      EXPECT_LT(found.ratio, 2.5);
    }
}

TEST(Disagreement, IsFoundWhereEveryGroupStaysByItself) {
  const Disagreement found = disagreement(draws_of({.group_offset = 0.5}, 1), chains_per_group);
  EXPECT_LT(found.p_value, disagreement_false_alarm);
  EXPECT_GT(found.ratio, 2);
}

// Of 64 groups with 128 draws each one draw in 2000 has another value: some four in all, which few groups have.
// The law of F is told that they disagree, with p < 1e-6, in seven runs of a thousand.  False alarms:
// disagreement_false_alarm for each run.
TEST(Disagreement, IsNotFoundInAHandfulOfDraws) {
  Rng random(5, Purpose::test, 12);
  for (int run = 0; run < 1000; ++run) {
    Draws draws{64, 128, {}};
    for (std::size_t i = 0; i < draws.chains * draws.length; ++i) {
      const double u = random.uniform();
      draws.values.push_back(u < 1.0 / 2000 ? 1 : 0);
    }
    ASSERT_GT(disagreement(draws, 1).p_value, disagreement_false_alarm) << run;
  }
}

// What changes within a group is no disagreement of the groups.
TEST(Disagreement, IsNotFoundWhereGroupsChange) {
  const Disagreement found = disagreement(draws_of({.late_offset = 0.5}, 1), chains_per_group);
  EXPECT_GT(found.p_value, disagreement_false_alarm);
}

// Two values, and in each chain only one of them.
Draws trapped_draws() {
  Draws draws{64 * chains_per_group, 100, {}};
  for (std::size_t i = 0; i < draws.chains * draws.length; ++i)
    draws.values.push_back(i < 100 * chains_per_group * 20 ? 1 : 0);
  return draws;
}

TEST(Disagreement, OfTrappedChainsIsInfinite) {
  const Disagreement found = disagreement(trapped_draws(), chains_per_group);
  EXPECT_EQ(found.p_value, 0);
  EXPECT_EQ(found.ratio, std::numeric_limits<double>::infinity());
}

TEST(Disagreement, IsUnknownOfWhatTellsNothing) {
  EXPECT_EQ(disagreement({}, chains_per_group).p_value, 1);
  EXPECT_EQ(disagreement({8, 100, std::vector<double>(800, 0.1)}, chains_per_group).p_value, 1);
  EXPECT_EQ(disagreement({4, 1, {1, 2, 3, 4}}, 1).p_value, 1);
}

// By the definition, slowly: the cell of a draw by the mean rank of all that are equal to it; F of a
// cell is the variance between groups over that within, each of a group's mean of its two halves.
void expect_as_defined(const Draws& draws) {
  constexpr int groups = 6, cells = 16;
  const auto all = static_cast<double>(draws.values.size());
  double counts[cells][groups][2] = {};
  for (std::size_t i = 0; i < draws.values.size(); ++i) {
    const double below = static_cast<double>(
        std::ranges::count_if(draws.values, [&](double v) { return v < draws.values[i]; }));
    const double equal = static_cast<double>(std::ranges::count(draws.values, draws.values[i]));
    const double rank = below + (equal - 1) / 2;  // from 0
    const auto cell = static_cast<std::size_t>(cells * rank / all);
    ++counts[cell][i / (draws.length * chains_per_group)][i % draws.length / (draws.length / 2)];
  }
  double worst = 0;
  for (const auto& cell : counts) {
    double mean = 0, between = 0, within = 0;
    for (const auto& group : cell) mean += (group[0] + group[1]) / 2 / groups;
    for (const auto& group : cell) {
      between += std::pow((group[0] + group[1]) / 2 - mean, 2) / (groups - 1);
      within += std::pow((group[0] - group[1]) / 2, 2) / groups;
    }
    worst = std::max(worst, between / within);
  }
  const Disagreement found = disagreement(draws, chains_per_group);
  EXPECT_NEAR(found.ratio, std::sqrt(worst), 1e-12 * found.ratio);
  const boost::math::fisher_f expected(groups - 1, groups);
  const double p = boost::math::cdf(boost::math::complement(expected, worst));
  EXPECT_NEAR(found.p_value, std::min(1.0, cells * p), 1e-12);
}

TEST(Disagreement, IsTheWorstOfTheRatiosOfVariances) {
  Rng random(3, Purpose::test, 9);
  Draws levels{6 * chains_per_group, 50, {}}, distinct = levels;
  for (std::size_t i = 0; i < levels.chains * levels.length; ++i) {
    const double u = random.uniform();
    const auto drift = static_cast<double>(i / 300);
    levels.values.push_back(std::floor(40 * u) + drift);
    distinct.values.push_back(40 * u + drift);
  }
  expect_as_defined(levels);
  expect_as_defined(distinct);
}

// ---- the words

class Warnings : public ::testing::Test {
 protected:
  Warnings() {
    for (int i = 0; i < 100'000; ++i) add_seed(1);
    for (std::size_t g = 0; g < 64; ++g) groups_.push_back(none_);
    for (MutationStatistics& group : groups_) visit(group, 0b10, 1000);
  }
  void add_seed(double x) {
    ++seeds_.samples;
    seeds_.total += x;
    seeds_.total_squares += x * x;
  }
  static void visit(MutationStatistics& group, PathClass path_class, int steps,
                    Reason reason = Reason::none) {
    RejectionRuns runs(1);
    Observation seen;
    seen.current.vertices = 3;
    seen.current.path_class = path_class;
    seen.reason = reason;
    for (int i = 0; i < steps; ++i) group.observe(seen, runs);
  }
  // Chains whose position on the sensor is this, and whose log f may change, too.
  std::vector<std::string> warnings_of(const Draws& film, const Draws& log_f = {},
                                       double light_of_chains = 1) {
    std::vector<ThinnedDraws> chains(film.chains);
    ChainDraws draws;
    for (std::size_t c = 0; c < film.chains; ++c) {
      for (std::size_t i = 0; i < film.length; ++i)
        chains[c].offer([&] {
          return Functionals{film.chain(c)[i], log_f.length > 0 ? log_f.chain(c)[i] : 0, 3, 0};
        });
      draws.add(chains[c]);
    }
    MutationStatistics statistics = none_;
    for (const MutationStatistics& group : groups_) statistics.merge(group);
    return warnings({.seeds = seeds_,
                     .draws = draws,
                     .chains = diagnostics(draws),
                     .statistics = statistics,
                     .chains_per_group = chains_per_group,
                     .light_of_chains = light_of_chains});
  }

  static constexpr std::array<std::string_view, 1> names_{"only"};
  MutationStatistics none_{names_, 1, 8};
  std::vector<MutationStatistics> groups_;
  SeedTally seeds_{8};
};

TEST_F(Warnings, AreNoneOfARunThatMixes) {
  EXPECT_EQ(warnings_of(draws_of({}, 1)), std::vector<std::string>{});
}

// How chains mix matters as far as the film is theirs.
TEST_F(Warnings, OfMixingAreOfFilmsThatChainsHaveAPartIn) {
  for (const Draws& draws : {draws_of({.group_offset = 0.5}, 1), draws_of({.phi = 0.99}, 1)}) {
    EXPECT_EQ(warnings_of(draws, {}, least_light_of_chains).size(), 1u);
    EXPECT_EQ(warnings_of(draws, {}, 0.9 * least_light_of_chains), std::vector<std::string>{});
  }
}

TEST_F(Warnings, SayThatASeedPassRestsOnFewSamples) {
  add_seed(1e5);
  const auto few = warnings_of(draws_of({}, 1));
  ASSERT_EQ(few.size(), 1u);
  EXPECT_NE(few[0].find("rests on about 3 of 100001 samples"), std::string::npos) << few[0];
  EXPECT_TRUE(rests_on_few_samples(seeds_));
}

TEST_F(Warnings, SayThatChainsShareTheirSeeds) {
  add_seed(1e4);
  const auto few = warnings_of(draws_of({}, 1));
  ASSERT_EQ(few.size(), 1u);
  EXPECT_NE(few[0].find("fewer than the 256 chains"), std::string::npos) << few[0];
  EXPECT_FALSE(rests_on_few_samples(seeds_));
}

// Chains of 400 draws need to be 1.7 times as long: the cheapest is to have two of the four.
TEST_F(Warnings, SayHowManyChainsWouldBeLongEnough) {
  const auto slow = warnings_of(draws_of({.phi = 0.8}, 1));
  ASSERT_EQ(slow.size(), 1u);
  EXPECT_NE(slow[0].find("R-hat of their position on the sensor is 1.017"), std::string::npos)
      << slow[0];
  EXPECT_NE(slow[0].find("; --chains 128 would do"), std::string::npos) << slow[0];
}

// Where a quarter of the chains is not enough, the budget must grow, by as much as is left.
TEST_F(Warnings, SayHowMuchLargerABudgetShouldBe) {
  const auto slow = warnings_of(draws_of({.phi = 0.98}, 1));
  ASSERT_EQ(slow.size(), 1u);
  EXPECT_NE(slow[0].find("; --chains 64 and a budget "), std::string::npos) << slow[0];
  EXPECT_NE(slow[0].find(" times as large would do"), std::string::npos) << slow[0];
}

// What is slow and does not tell on the film is no doubt about it.
TEST_F(Warnings, AreOfWhatTellsOnTheFilm) {
  const Draws slow = draws_of({.phi = 0.98}, 1);
  EXPECT_EQ(warnings_of(draws_of({}, 2), slow), std::vector<std::string>{});
  EXPECT_EQ(warnings_of(slow, draws_of({}, 2)).size(), 1u);
}

// One warning for one matter: such chains are short for their mixing, too.
TEST_F(Warnings, SayThatGroupsDisagree) {
  const auto apart = warnings_of(draws_of({.group_offset = 0.5}, 1));
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_NE(apart[0].find("the groups of chains disagree on position on the sensor"),
            std::string::npos)
      << apart[0];
}

TEST_F(Warnings, SayThatGroupsDisagreeWithoutAnyChange) {
  const auto trapped = warnings_of(trapped_draws());
  ASSERT_FALSE(trapped.empty());
  EXPECT_NE(trapped.back().find("they differ from each other, and none of them changes"),
            std::string::npos)
      << trapped.back();
  for (const std::string& warning : trapped)
    EXPECT_EQ(warning.find("inf "), std::string::npos) << warning;
}

TEST_F(Warnings, SayWhichClassesFewGroupsMet) {
  for (std::size_t g = 0; g < 3; ++g) visit(groups_[g], 0b101, 9000);
  const auto rare = warnings_of(draws_of({}, 1));
  ASSERT_EQ(rare.size(), 1u);
  EXPECT_NE(rare[0].find("LDSE (30 % of all steps, 3 of 64 groups)"), std::string::npos) << rare[0];
  // Of a pooled film it is a share of what chains carry.
  EXPECT_EQ(warnings_of(draws_of({}, 1), {}, 0.02).size(), 1u);
  EXPECT_TRUE(warnings_of(draws_of({}, 1), {}, 0.01).empty());
  for (MutationStatistics& group : groups_) visit(group, 0b101, 1);
  EXPECT_TRUE(warnings_of(draws_of({}, 1)).empty());
}

TEST_F(Warnings, SayThatChainsCannotMove) {
  for (MutationStatistics& group : groups_) visit(group, 0b10, 200, Reason::not_applicable);
  EXPECT_TRUE(warnings_of(draws_of({}, 1)).empty());
  for (MutationStatistics& group : groups_) visit(group, 0b10, 800, Reason::not_applicable);
  const auto idle = warnings_of(draws_of({}, 1));
  ASSERT_EQ(idle.size(), 1u);
  EXPECT_NE(idle[0].find("in 50 % of their steps where none of the mutations can act"),
            std::string::npos)
      << idle[0];
  EXPECT_TRUE(warnings_of(draws_of({}, 1), {}, 0.9 * least_light_of_chains).empty());
}

FilmEstimate film_with(double degrees) {
  return {.shape = {2}, .value = {1, 3}, .standard_error = {0.3, 0.4}, .degrees_of_error = degrees};
}

TEST(DominatedFilms, SayHowFewGroupsDecide) {
  const std::string warning = dominated_film(film_with(1.06), 64);
  EXPECT_NE(warning.find("16 %, rests on 2 of 64 groups of chains (1.1 degrees"), std::string::npos)
      << warning;
}

TEST(DominatedFilms, SayThatNobodyKnowsAnErrorThatIsNotKnown) {
  FilmEstimate film = film_with(0);
  film.standard_error.assign(2, not_known);
  EXPECT_TRUE(dominated_film(film, 64).starts_with("nobody knows the error of the film: "));
}

TEST(DominatedFilms, AreNoneWhereGroupsAgreeOrAreFew) {
  EXPECT_EQ(dominated_film(film_with(fewest_film_degrees), 64), "");
  EXPECT_EQ(dominated_film(film_with(40), 64), "");
  EXPECT_EQ(dominated_film(film_with(1.06), 4), "");
  EXPECT_EQ(dominated_film(film_with(not_known), 64), "");
}

}  // namespace
}  // namespace wander::test

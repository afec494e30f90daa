// The border between samples and chains, chosen from a pilot.
#include "mlt/run/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/partition_pilots.h"

namespace wander::test::partition_test {
namespace {

constexpr std::size_t bins = bins_of_pilot;

TEST(Partition, LeavesNothingOut) {
  for (const double c : {1e-3, 1.0, 50.0})
    for (const double l : {1e-6, 0.3, 1.0, 1e9}) {
      EXPECT_NEAR(Partition{c}.of_samples(l) + Partition{c}.of_chains(l), 1, 1e-15);
      EXPECT_LE(l * Partition{c}.of_samples(l), c) << "no sample is a firefly";
    }
  EXPECT_EQ(Partition{}.of_chains(0.5), 1) << "no border: all is left to the chains";
  for (const double l : {1e-6, 0.3, 5.0, 40.0, 1e9}) {
    const Partition band{2, 50};
    EXPECT_NEAR(band.of_samples(l) + band.of_chains(l), 1, 1e-15);
    EXPECT_NEAR(band.of_chains(l), Partition{2}.of_chains(l) * 50 / (l + 50), 1e-15);
  }
}

// Of an image there are more, after those of a curve: none so narrow that chains have less than half of anything.
TEST(Partition, MayHaveAnEndOnAnImage) {
  const double b = 3;
  const std::vector<Partition> curve = partitions_around(b, FilmKind::curve),
                               image = partitions_around(b, FilmKind::image);
  ASSERT_EQ(curve.size(), borders_around(b).size());
  ASSERT_GT(image.size(), curve.size());
  for (std::size_t k = 0; k < image.size(); ++k) {
    EXPECT_EQ(image[k].has_end(), k >= curve.size()) << k;
    if (k < curve.size())
      EXPECT_EQ(image[k].c, curve[k].c);
    else
      EXPECT_GT(image[k].of_chains(std::sqrt(image[k].c * image[k].end)), 0.5) << k;
  }
}

TEST(Pooling, IsTheBalanceOfSamplesAndDraws) {
  const Pooling even = pooling(pilot_of({{2, 5000}}), 0.5, bins);
  EXPECT_DOUBLE_EQ(even.samples_per_step, 0.5);
  EXPECT_NEAR(std::log2(even.partition.c / (1.0 * 0.5 * usual_steps_per_draw)), 0, 1.01) << "b = 1";
  EXPECT_EQ(even.steps_per_draw, usual_steps_per_draw);
  EXPECT_EQ(even.cost_of_sample, 0.5);
}

// What is chosen, by going through all there is.
Pooling by_rule(const Pilot& pilot) {
  std::vector<Pooling> all = all_choices(pilot);
  const auto of = [&](const Pooling& one) { return work(pilot, one); };
  const Pooling best = std::ranges::min(all, {}, of);
  const double enough = 1.25 * work(pilot, best);
  std::erase_if(all, [&](const Pooling& one) { return work(pilot, one) > enough; });
  // The largest up to 2¹⁰ b, or, if the best lies beyond, of all.
  const bool beyond = best.partition.c > 1024 * pilot.b();
  double c = 0;
  for (const Pooling& one : all)
    if (beyond || one.partition.c <= 1024 * pilot.b()) c = std::max(c, one.partition.c);
  std::erase_if(all, [&](const Pooling& one) { return one.partition.c != c; });
  return std::ranges::min(all, {}, of);
}

TEST(Pooling, TakesTheLargestBorderThatIsAboutAsGoodAsTheBest) {
  for (const Pilot& pilot :
       {pilot_of({{1, 9000}, {2, 500}}), pilot_of({{1, 5000}, {400, 80}}),
        pilot_of({{0.1, 3000}, {30, 100}}), pilot_of({{1, 5000}, {1e4, 80}})}) {
    ASSERT_TRUE(is_telling(pilot));
    const Pooling chosen = best_pooling(pilot, bins), expected = by_rule(pilot);
    EXPECT_EQ(chosen.samples_per_step, expected.samples_per_step);
    EXPECT_EQ(chosen.partition.c, expected.partition.c);
  }
}

// Where even chains that mix at once would hardly do better than samples, none are asked.
TEST(Pooling, OfEasyLightIsThatOfSamplesAlone) {
  int easy = 0, hard = 0;
  for (int count = 0; count <= 60; count += 2) {
    const Pilot pilot = pilot_of({{1, 50'000}, {100, count}}, 100'000);
    ASSERT_TRUE(tells_enough(pilot));
    std::vector<Pooling> all = all_choices(pilot);
    const auto of = [&](const Pooling& one) { return work(pilot, one); };
    const double best = of(std::ranges::min(all, {}, of));
    std::erase_if(all, [&](const Pooling& one) {
      return one.partition.c != 1024 * pilot.b() || of(one) > 1.05 * best;
    });
    const double least = all.empty() ? 0 : of(std::ranges::min(all, {}, of));
    std::erase_if(all, [&](const Pooling& one) { return of(one) > 1.02 * least; });
    const auto chosen = pooling_of_easy_light(pilot, bins);
    ASSERT_EQ(chosen.has_value(), !all.empty()) << count;
    ++(chosen ? easy : hard);
    if (!chosen) continue;
    EXPECT_EQ(chosen->partition.c, all.front().partition.c) << count;
    EXPECT_EQ(chosen->samples_per_step, all.front().samples_per_step) << count;
  }
  EXPECT_GE(easy, 2);
  EXPECT_GE(hard, 2);
  EXPECT_FALSE(pooling_of_easy_light(pilot_of({{1, 500}}), bins)) << "from so few samples";
}

// Of a pilot that cannot tell, what samples leave unknown is not known: the best is taken.
TEST(Pooling, WithGivenSamplesTakesTheLeastWork) {
  for (const Pilot& pilot : {pilot_of({{1, 5000}, {400, 80}}), pilot_of({{1e4, 3}})}) {
    const Pooling best = pooling(pilot, 0.5, bins);
    for (const double c : borders_around(pilot.b()))
      EXPECT_LE(work(pilot, best), work(pilot, {{c}, 0.5}) * (1 + 1e-8)) << c;
  }
}

// Where all paths have the same l samples have no variance but that of their number; where a few carry
// all light they are hopeless.
TEST(Pooling, MakesManySamplesWhereLightIsEasyAndFewWhereItIsHard) {
  EXPECT_EQ(best_pooling(pilot_of({{1, 10'000}}), bins).samples_per_step, most_samples_per_step);
  const Pilot hard = pilot_of({{1e4, 100}});
  ASSERT_TRUE(is_telling(hard));
  EXPECT_LE(best_pooling(hard, bins).samples_per_step, 0.5);
  const Pilot dark = pilot_of({{1e4, 3}});
  EXPECT_FALSE(is_telling(dark));
  EXPECT_EQ(best_pooling(dark, bins).samples_per_step, fewest_samples_per_step);
  const Pooling of_one = best_pooling(pilot_of({{1e4, 1}}), bins);
  EXPECT_EQ(of_one.samples_per_step, fewest_samples_per_step);
  EXPECT_GT(of_one.partition.c, 0);
}

// Few samples, because they were dear, say nothing of how rare light is.
TEST(Pooling, CallsLightRareIfManySamplesFindHardlyAny) {
  constexpr double many = most_samples_of_a_pilot;
  EXPECT_TRUE(finds_rare_light(pilot_of({{1e4, 3}}, many)));
  EXPECT_TRUE(finds_rare_light(pilot_of({}, many)));
  EXPECT_FALSE(finds_rare_light(pilot_of({{1e4, 3}}, many - 1)));
  EXPECT_FALSE(finds_rare_light(pilot_of({{1e4, 100}}, many)));
}

TEST(Pooling, KnowsNoUnitOfLight) {
  Pilot one = pilot_of({{1.3, 4000}, {77, 50}}), other = pilot_of({});
  for (int i = one.found.first(); i < one.found.end(); ++i) {
    const auto [count, sum] = one.found[i];
    for (int k = 0; k < static_cast<int>(count); ++k) other.found.add(0x1p40 * sum / count);
  }
  const Pooling a = best_pooling(one, bins), b = best_pooling(other, bins);
  EXPECT_EQ(a.samples_per_step, b.samples_per_step);
  EXPECT_NEAR(b.partition.c, 0x1p40 * a.partition.c, 1e-9 * b.partition.c);
}

// Here two samples cost as much as a step.
TEST(Pooling, OfGivenStepsTakesNotMuchLongerThanThese) {
  const Pilot easy = pilot_of({{1, 10'000}});
  EXPECT_EQ(best_pooling(easy, bins).samples_per_step, most_samples_per_step);
  EXPECT_EQ(best_pooling(easy, bins, most_cost_of_given_steps).samples_per_step, 8);
}

// Samples whose paths come together are worth as many fewer.
TEST(Pooling, CountsPathsThatComeTogetherOnce) {
  Pilot apart = pilot_of({{1, 5000}, {400, 80}});
  for (const double c : borders_around(apart.b())) apart.borders.push_back({.c = c});
  Pilot together = apart;
  for (Pilot::Border& border : together.borders) border.together = 16;
  EXPECT_NE(pooling(apart, 8, bins).partition.c, pooling(apart, 0.5, bins).partition.c);
  EXPECT_EQ(pooling(together, 8, bins).partition.c, pooling(apart, 0.5, bins).partition.c);
}

TEST(Pooling, KnowsWhatASampleCostsBesideAStep) {
  Pilot pilot = pilot_of({{1, 5000}, {400, 80}});
  const double cost = pooling(pilot, 1, bins).cost_of_sample;
  pilot.rays_per_step /= 2;
  EXPECT_EQ(pooling(pilot, 1, bins).cost_of_sample, 2 * cost);
}

TEST(Pooling, LeavesAllToTheChainsWhereThePilotSawNothing) {
  EXPECT_EQ(best_pooling(pilot_of({}), bins).partition.c, 0);
}

// Of chains that see the hard light half of the time.
TEST(Pooling, HearsOfFirefliesFromTheChains) {
  Pilot pilot = pilot_of({{1, 10'000}});
  EXPECT_EQ(best_pooling(pilot, bins).samples_per_step, most_samples_per_step);
  pilot.chains.resize(1);
  for (int i = 0; i < 1000; ++i) pilot.chains[0].add(i % 2 == 0 ? 1 : 1e5);
  EXPECT_LT(best_pooling(pilot, bins).samples_per_step, 1);
}

// Of chains none of which has come to the light that carries half of what the samples found.
TEST(Pooling, HearsFromTheSamplesWhatChainsHaveNotSeen) {
  Pilot seen = pilot_of({{1, 10'000}, {1000, 10}});
  seen.chains.resize(1);
  Pilot unseen = seen;
  for (int i = 0; i < 1000; ++i) {
    seen.chains[0].add(i % 2 == 0 ? 1 : 1000);
    unseen.chains[0].add(1);
  }
  for (const double c : borders_around(seen.b())) {
    seen.borders.push_back({.c = c, .steps_per_draw = 1000, .steps_per_draw_of_total = 1000});
    unseen.borders.push_back({.c = c, .steps_per_draw = 1000, .steps_per_draw_of_total = 1000});
  }
  const Pooling a = pooling(seen, 1, bins), b = pooling(unseen, 1, bins);
  EXPECT_NEAR(std::log2(b.partition.c / a.partition.c), 0, 2.01) << "a border more or less";
}

TEST(Pooling, LeavesLessToChainsThatMixBadly) {
  Pilot quick = pilot_of({{1, 5000}, {50, 100}}), slow = quick;
  for (const double c : borders_around(quick.b())) {
    quick.borders.push_back({.c = c, .steps_per_draw = 10, .steps_per_draw_of_total = 10});
    slow.borders.push_back({.c = c, .steps_per_draw = 1000, .steps_per_draw_of_total = 1000});
  }
  const Pooling a = pooling(quick, 1, bins), b = pooling(slow, 1, bins);
  EXPECT_EQ(a.steps_per_draw, 10);
  EXPECT_EQ(b.steps_per_draw, 1000);
  EXPECT_GT(b.partition.c, 8 * a.partition.c);
}

// A tenth of the light is hard.  Chains that stay where they began have it from the seed pass, which has
// one sample for so many steps.
TEST(Pooling, LeavesToChainsWhatTheyKnowBetterThanTheirSeeds) {
  const auto samples_per_step = [](double steps_per_draw, double steps_per_seed) {
    Pilot pilot = pilot_of({{1, 10'000}});
    pilot.chains.resize(1);
    for (int i = 0; i < 1000; ++i) pilot.chains[0].add(i % 10 == 0 ? 1e5 : 1);
    pilot.steps_per_chain = 1000;
    pilot.steps_per_seed = steps_per_seed;
    for (const double c : borders_around(pilot.b()))
      pilot.borders.push_back(
          {.c = c, .steps_per_draw = steps_per_draw, .steps_per_draw_of_total = steps_per_draw});
    return best_pooling(pilot, bins).samples_per_step;
  };
  EXPECT_LE(samples_per_step(1, 30), 2) << "they move";
  EXPECT_LE(samples_per_step(1000, 0.01), 2) << "the seed pass is long";
  EXPECT_EQ(samples_per_step(1000, 30), most_samples_per_step);
}

// Where all samples are seeds there is one for each 1/ρ steps.
TEST(Pooling, KnowsTheSeedsOfAllSamples) {
  for (double rho = fewest_samples_per_step; rho <= most_samples_per_step; rho *= 2) {
    Pilot all = pilot_of({{1, 10'000}});
    all.chains.resize(1);
    for (int i = 0; i < 1000; ++i) all.chains[0].add(i % 10 == 0 ? 1e5 : 1);
    all.steps_per_chain = 1000;
    for (const double c : borders_around(all.b()))
      all.borders.push_back({.c = c, .steps_per_draw = 300, .steps_per_draw_of_total = 300});
    Pilot as_many = all, few = all;
    all.steps_per_seed.reset();
    as_many.steps_per_seed = 1 / rho;
    few.steps_per_seed = 1000 / rho;
    EXPECT_EQ(pooling(all, rho, bins).partition.c, pooling(as_many, rho, bins).partition.c) << rho;
    EXPECT_LT(pooling(all, rho, bins).partition.c, pooling(few, rho, bins).partition.c) << rho;
  }
}

// However few are asked for beside the steps.
TEST(Pooling, CountsTheSamplesOfTheSeedPass) {
  Pilot many = pilot_of({{1, 5000}, {50, 100}});
  const Pilot none = many;
  many.seeds_per_step = 4;
  for (const double rho : {1. / 16, 1., 4.}) {
    EXPECT_EQ(pooling(many, rho, bins).partition.c, pooling(none, 4, bins).partition.c) << rho;
    EXPECT_EQ(pooling(many, rho, bins).samples_per_step, rho);
  }
  EXPECT_EQ(pooling(many, 16, bins).partition.c, pooling(none, 16, bins).partition.c);
  EXPECT_GT(pooling(none, 4, bins).partition.c, 4 * pooling(none, 1. / 16, bins).partition.c);
}

TEST(StepsPerDraw, AreTheSharesOfVarianceOfLongChainsAndMoreOfShortOnes) {
  EXPECT_NEAR(steps_per_draw(0.001, 1e5), 100, 0.5);
  EXPECT_NEAR(steps_per_draw(2 * (std::exp(-1.)), 1000), 2000, 4) << "x = 1";
  EXPECT_NEAR(steps_per_draw(1, 1000), 4000, 10) << "not moved";
  EXPECT_NEAR(steps_per_draw(0, 1000), 1, 0.01);
}

}  // namespace
}  // namespace wander::test::partition_test

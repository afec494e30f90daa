// Groups of pssmlt and mmlt: seeds, sums of deposits, budgets, and the same bits from any number of
// threads.  False alarms: 1e-9 per decision.
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "tests/support/allocation_counter.h"
#include "tests/support/expect.h"
#include "tests/support/primary_runs.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

const std::vector<description::Scene (*)()> makers{&diffuse_room, &mirror_and_glass, &pinhole_room};

class PrimaryRooms : public ::testing::TestWithParam<int> {
 protected:
  static description::Scene describe() {
    description::Scene scene = makers[static_cast<std::size_t>(GetParam())]();
    scene.max_vertices = 5;
    return scene;
  }
  FlatScene scene_ = build(describe());
  Flat space_{*scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Rooms, PrimaryRooms, ::testing::Range(0, static_cast<int>(makers.size())));

// ---- seeds

TEST_P(PrimaryRooms, SeedsOfSamplesAreDrawnInProportionToTheirLight) {
  constexpr int chains = 20'000;
  constexpr std::uint64_t samples = 200, cell = 5;
  std::vector<double> light(samples / cell), observed(light.size());
  PathSampler<Flat> sampler(space_.with(SampleSeeds::roulette), all_techniques, Heuristic::balance);
  Rng random(3, Purpose::seed_pass, 2);
  for (std::uint64_t i = 0; i < samples; ++i) {
    random.start(i);
    sampler.sample(random, [&](const Path<W>&, int, double weight) { light[i / cell] += weight; });
  }
  SeedSlice<Flat, SampleSeeds> slice(space_, 3, 2, chains);
  slice.run(samples);
  for (int k = 0; k < chains; ++k) observed[slice.seed(k).sample / cell] += 1;
  std::vector<double> expected = light, alike(light.size(), chains / double(light.size()));
  const double total = slice.tally().total.value();
  for (double& value : expected) value *= chains / total;
  EXPECT_TRUE(passes(chi_square_test(observed, expected, usual_false_alarm)));
  EXPECT_TRUE(rejects(chi_square_test(observed, alike, usual_false_alarm)));
}

TEST_P(PrimaryRooms, SeedsOfLengthsHaveTheirLengthAndAreThoseOfTheirLengthAlone) {
  const int lengths = space_.max_vertices() - 1;
  SeedSlice<Flat, LengthSeeds> slice(space_, 4, 0, lengths);
  slice.run(500);
  for (int k = 0; k < lengths; ++k) {
    const Seed& seed = slice.seed(k);
    EXPECT_EQ(seed.weight > 0, slice.tally().mean(k + 2) > 0);
    EXPECT_EQ(seed.vertices, seed.weight > 0 ? k + 2 : 0);
  }
}

// The numbers of a sample, at their places, make the sample again; the numbers of one of its paths,
// moved to the places of a single technique, make that path.
TEST_P(PrimaryRooms, SeedsAreMadeAgainFromTheirNumbersBitForBit) {
  constexpr int chains = 100;
  SplatSampler<Flat> splats(space_);
  SeedSlice<Flat, SampleSeeds> whole(space_, 5, 1, chains);
  const int lengths = space_.max_vertices() - 1;
  SeedSlice<Flat, LengthSeeds> paths(space_, 5, 1, lengths);
  whole.run(300);
  paths.run(300);
  PrimaryChain<SplatSampler<Flat>, Kelemen> chain(splats, {Kelemen{}, 0.3});
  for (int k = 0; k < chains; ++k) {
    ASSERT_TRUE(chain.start(splats, whole.numbers(whole.seed(k), splats.layout())));
    EXPECT_EQ(chain.current().total, whole.seed(k).weight);
  }
  for (int k = 0; k < lengths; ++k) {
    const Seed& seed = paths.seed(k);
    if (!(seed.weight > 0)) continue;
    MultiplexedSampler<Flat> single(space_, seed.vertices);
    PrimaryChain<MultiplexedSampler<Flat>, Kelemen> path_chain(single, {Kelemen{}, 0.3});
    for (const double place : {0.0, 0.3, std::nextafter(1.0, 0.0)}) {
      const PrimaryNumbers numbers = single.coordinates_of(paths.numbers(seed, splats.layout()),
                                                           splats.layout(), seed.technique, place);
      const double cell = numbers[0] * single.techniques() - seed.technique;
      EXPECT_TRUE(std::abs(cell - place) < 1e-9 || place > 0.9) << cell;
      ASSERT_TRUE(path_chain.start(single, numbers));
      EXPECT_EQ(path_chain.current().technique, seed.technique);
      EXPECT_EQ(path_chain.current().total, single.techniques() * seed.weight);
    }
    // Without its numbers nothing starts.
    EXPECT_FALSE(path_chain.start(single, PrimaryNumbers(single.coordinates())));
  }
}

// No two chains of a run, of whatever length and group, draw the same numbers.
TEST(LengthNumbers, HaveAStreamForEachChain) {
  std::set<double> firsts;
  constexpr int groups = 6, lengths = 5;
  for (int g = 0; g < groups; ++g) {
    const LengthNumbers numbers(7, g, lengths);
    for (int k = 0; k < lengths; ++k) {
      Rng random = numbers.chain(k);
      random.start(0);
      firsts.insert(random.uniform());
      EXPECT_GE(numbers.place(k), 0);
      firsts.insert(numbers.place(k));
    }
    firsts.insert(numbers.first_length());
  }
  EXPECT_EQ(firsts.size(), static_cast<std::size_t>(groups * (2 * lengths + 1)));
}

// ---- deposits

// With expected values the deposits of n steps sum to n b_g.
TEST_P(PrimaryRooms, DepositsOfExpectedValuesSumToTheNumberOfSteps) {
  const Rendering r = render_primary<PssmltGroup, ExpectedValues>(*scene_, budget_of(20'000),
                                                                  {.fewest_seeds = 2048});
  const double mean = std::accumulate(r.film.value.begin(), r.film.value.end(), 0.0) /
                      static_cast<double>(r.film.value.size());
  EXPECT_NEAR(mean, r.normalization->value, 1e-12 * mean);
}

TEST(KelemenWeights, AreThoseOfKelemenWhereAllConstantsAreOne) {
  const PrimaryConstants b{2, 2, 0.3};
  SampleSplats<Flatland> x(2), y(2);
  x.total = 5;
  y.total = 0.5;
  for (const PrimaryMove move : {PrimaryMove::small, PrimaryMove::large}) {
    const double large = move == PrimaryMove::large ? 1 : 0;
    for (const Reason reason : {Reason::none, Reason::metropolis}) {
      const PrimaryStep<SampleSplats<Flatland>> step{x, y, move, 1, 0.1, reason};
      const PrimaryDeposit d = KelemenWeights::deposit(step, b);
      EXPECT_NEAR(d.current, (1 - 0.1) / (5 / 2.0 + 0.3) * 5, 1e-15);
      EXPECT_NEAR(d.proposed, (0.1 + large) / (0.5 / 2.0 + 0.3) * 0.5, 1e-15);
    }
  }
  // Without other groups there is nothing to weigh by: expected values.
  const PrimaryStep<SampleSplats<Flatland>> step{x, y, PrimaryMove::large, 1, 0.1, Reason::none};
  const PrimaryDeposit alone = KelemenWeights::deposit(step, {2, 0, 0.3});
  EXPECT_EQ(alone.current, ExpectedValues::deposit(step, {2, 0, 0.3}).current);
  EXPECT_EQ(alone.proposed, ExpectedValues::deposit(step, {2, 0, 0.3}).proposed);
}

TEST(LengthSequence, GivesEachLengthItsShareOfAnyNumberOfSteps) {
  const std::vector<double> shares{0.5, 0.03, 0.27, 0.2};
  for (const double first : {0.0, 0.4, 0.999}) {
    LengthSequence sequence(shares, first);
    std::vector<double> count(shares.size());
    for (int n = 1; n <= 20'000; ++n) {
      count[sequence.next()] += 1;
      for (std::size_t k = 0; k < shares.size(); ++k)
        ASSERT_LT(std::abs(count[k] - n * shares[k]), 6);
    }
  }
}

TEST(SharesOfSteps, SumToOneAndLeaveNoLengthOut) {
  SeedTally others(6);
  for (const double q : shares_of_steps(others)) EXPECT_DOUBLE_EQ(q, 0.2);
  others.samples = 10;
  others.sum[1] += 3;
  others.sum[3] += 1;
  others.total += 4;
  const std::vector<double> q = shares_of_steps(others);
  EXPECT_NEAR(std::accumulate(q.begin(), q.end(), 0.0), 1, 1e-15);
  EXPECT_DOUBLE_EQ(q[0], even_share_of_steps / 5);
  EXPECT_DOUBLE_EQ(q[1], even_share_of_steps / 5 + (1 - even_share_of_steps) * 0.75);
}

// ---- runs

class PrimaryRuns : public ::testing::TestWithParam<PrimaryMethod> {};
INSTANTIATE_TEST_SUITE_P(Methods, PrimaryRuns, ::testing::ValuesIn(primary_methods),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(PrimaryRuns, GiveTheSameBitsForAnyNumberOfThreads) {
  const ChainSettings settings{.fewest_seeds = 2048};
  for (const auto& make : {&mirror_and_glass, &pinhole_room}) {
    const FlatScene scene = build(make());
    Session session = budget_of(10'001);
    session.threads = 1;
    const Rendering one = GetParam().render(*scene, session, settings);
    for (const int threads : {2, 7}) {
      session.threads = threads;
      const Rendering many = GetParam().render(*scene, session, settings);
      EXPECT_EQ(one.film.value, many.film.value);
      EXPECT_EQ(one.film.standard_error, many.film.standard_error);
      EXPECT_EQ(one.film.by_length, many.film.by_length);
      EXPECT_EQ(one.normalization->value, many.normalization->value);
      ASSERT_EQ(one.mutations.size(), many.mutations.size());
      for (std::size_t m = 0; m < one.mutations.size(); ++m) {
        EXPECT_EQ(one.mutations[m].failures, many.mutations[m].failures);
        EXPECT_EQ(one.mutations[m].acceptance_per_bin, many.mutations[m].acceptance_per_bin);
      }
    }
    session.seed = 2;
    EXPECT_NE(one.film.value, GetParam().render(*scene, session, settings).film.value);
  }
}

TEST_P(PrimaryRuns, MeetTheirBudgetExactly) {
  const FlatScene scene = build(diffuse_room());
  for (const std::uint64_t budget : {1u, 2u, 63u, 257u, 5003u}) {
    const Rendering r = GetParam().render(*scene, budget_of(budget), {.fewest_seeds = 2048});
    EXPECT_EQ(r.samples, budget);
    EXPECT_TRUE(r.complete);
    std::uint64_t proposed = 0;
    for (const MutationRecord& m : r.mutations) {
      EXPECT_TRUE(m.name == "primary_small" || m.name == "primary_large");
      std::uint64_t outcomes = m.accepted;
      for (const auto& [reason, count] : m.failures) outcomes += count;
      EXPECT_EQ(outcomes, m.proposed);
      proposed += m.proposed;
    }
    EXPECT_EQ(proposed, budget);
  }
}

TEST(PrimaryRun, WhereThereIsNoLightSaysSo) {
  const FlatScene scene = build(dark_room());
  for (const PrimaryMethod& method : primary_methods)
    EXPECT_THROW(method.render(*scene, budget_of(1000), {.fewest_seeds = 1024}), NoLightFound);
}

template <class Chains>
void expect_no_allocation(const Flat& space) {
  Chains group(space, PrimaryKernel<Kelemen>{Kelemen{}, 0.3}, 1, 0, 4);
  group.add_seeds(500);
  group.start_chains(SeedTally(space.max_vertices()));
  group.advance(500);  // until all of its chains have begun
  const AllocationCounter allocations;
  group.advance(3000);
  // The film of a length is made when its first path comes.
  EXPECT_LE(allocations.count(), space.max_vertices());
}
TEST_P(PrimaryRooms, StepsNeverAllocate) {
  expect_no_allocation<PssmltGroup<Flat, Kelemen, KelemenWeights>>(space_);
  expect_no_allocation<MmltGroup<Flat, Kelemen, KelemenWeights>>(space_);
}

// A chain begins with its first step: of so many lengths a run of few steps comes to few, and makes the paths of no
// others.  With 3 of 59 chains there are a sixth of the allocations, films of lengths included; had all begun, nine tenths.
TEST_P(PrimaryRooms, OfFewStepsFewChainsBegin) {
  description::Scene scene = describe();
  scene.max_vertices = 60;
  const FlatScene long_scene = build(scene);
  const Flat space(*long_scene, Roulette::off);
  MmltGroup<Flat, Kelemen, KelemenWeights> group(space, {Kelemen{}, 0.3}, 1, 0, 1);
  group.add_seeds(200);
  group.end_seeds();
  const AllocationCounter allocations;
  group.start_chains(SeedTally(space.max_vertices()));
  group.advance(3);
  const long of_few = allocations.count();
  group.advance(2000);
  EXPECT_LT(4 * of_few, allocations.count());
}

}  // namespace
}  // namespace wander::test

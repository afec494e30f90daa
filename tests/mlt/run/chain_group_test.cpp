// A group of chains, made again by hand: its slice of seeds, a stream for each chain, a number for
// each step, and the film that these alone determine.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lab/render.h"
#include "mlt/primary/multiplexed_chain.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/catalogue.h"
#include "mutations/kelemen.h"
#include "tests/support/deposits.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

constexpr std::uint64_t seed = 5;
constexpr int group = 2, chains = 3;
constexpr std::uint64_t samples = 300;

class PathGroups : public ::testing::Test {
 protected:
  // Step i of chain k draws from its own stream, and deposits in the bin where the path is.
  void run_chain(int k, std::uint64_t steps, GroupFilm& film, MutationStatistics& statistics) {
    Chain<Flat, Family> chain(space_, family_,
                              slice_.replay(slice_.seed(k), space_.max_vertices()));
    Rng random(seed, Purpose::chain, static_cast<std::uint32_t>(group * chains + k));
    RejectionRuns runs(Family::count);
    for (std::uint64_t i = 0; i < steps; ++i) {
      random.start(i);
      chain.step(random, [&](const Step<W>& step) {
        deposit(space_, step, space_.bin(step.current), film);
        statistics.observe(observation(space_, step, features(space_, step.current)), runs);
      });
    }
  }
  // The kernel learns from other groups than its own.
  void SetUp() override {
    slice_.run(samples);
    SeedSlice<Flat> slice(space_, seed, group + 1, chains);
    slice.run(samples);
    others_.merge(slice.tally());
    family_.learn(others_);
  }

  FlatScene scene_ = build(diffuse_room());
  Flat space_{*scene_, Roulette::off};
  Family family_ = make_family({}, scene_->max_vertices());
  SeedSlice<Flat> slice_{space_, seed, group, chains};
  SeedTally others_{space_.max_vertices()};
};

// 107 steps of three chains are 36, 36 and 35, whatever the rounds that they are made in.
TEST_F(PathGroups, MakesTheStepsOfItsOwnStreams) {
  GroupsFilm expected({scene_->bins()}), actual({scene_->bins()});
  MutationStatistics expected_statistics(Family::names, scene_->bins(), scene_->max_vertices());
  MutationStatistics actual_statistics(Family::names, scene_->bins(), scene_->max_vertices());
  GroupFilm film(scene_->bins(), scene_->max_vertices());
  for (const auto& [k, steps] : {std::pair(0, 36u), {1, 36u}, {2, 35u}})
    run_chain(k, steps, film, expected_statistics);
  expected.add(film, slice_.tally().mean(), 107);

  PathGroup<Flat, Family> made(space_, make_family({}, space_.max_vertices()), seed, group, chains);
  made.add_seeds(samples);
  made.start_chains(others_);
  for (const std::uint64_t round : {2u, 98u, 7u}) made.advance(round);
  EXPECT_EQ(made.steps(), 107u);
  ChainDraws draws;
  made.deliver(actual, actual_statistics, draws);

  const FilmEstimate a = actual.estimate(), e = expected.estimate();
  for (std::size_t bin = 0; bin < e.value.size(); ++bin)
    EXPECT_NEAR(a.value[bin], e.value[bin], 1e-12 * slice_.tally().mean()) << "bin " << bin;
  EXPECT_EQ(a.by_length.size(), e.by_length.size());
  const auto records = actual_statistics.records(), by_hand = expected_statistics.records();
  ASSERT_EQ(records.size(), by_hand.size());
  for (std::size_t m = 0; m < records.size(); ++m) {
    EXPECT_EQ(records[m].accepted, by_hand[m].accepted);
    EXPECT_EQ(records[m].failures, by_hand[m].failures);
    EXPECT_EQ(records[m].proposed_per_bin, by_hand[m].proposed_per_bin);
  }
}

// Samples play roulette, whether the space of the chains does or not.
TEST_F(PathGroups, CompareTheirStatesWithSamples) {
  const PathChains<Flat, Family> states(space_, family_, seed, group, chains);
  const Flat of_samples = space_.with(Roulette::by_albedo);
  double least = 1;
  constexpr int paths = 32;  // so that some are long enough for roulette
  SeedSlice<Flat> slice(space_, seed, group, paths);
  slice.run(samples);
  for (int k = 0; k < paths; ++k) {
    Path<W> x = slice.replay(slice.seed(k), space_.max_vertices()), sample = x;
    for (int i = 0; i < x.size(); ++i) of_samples.evaluate(sample, i);
    weigh(space_, x);
    weigh(of_samples, sample);
    const double ratio = (sample.contribution / sample.intensity).value();
    EXPECT_NEAR(states.ratio(x), ratio, 1e-12 * ratio);
    least = std::min(least, (sample.intensity / x.intensity).value());
  }
  EXPECT_LT(least, 0.999);
}

// The same for chains of whole samples; a refused step leaves their state as it was.
TEST(PssmltGroups, MakeTheStepsOfTheirOwnStreams) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  const PrimaryKernel<Kelemen> kernel{Kelemen{}, 0.3};
  SeedSlice<Flat, SampleSeeds> slice(space, seed, group, chains);
  slice.run(samples);
  GroupFilm film(scene->bins(), scene->max_vertices());
  SplatSampler<Flat> sampler(space);
  for (int k = 0; k < chains; ++k) {
    PrimaryChain<SplatSampler<Flat>, Kelemen> chain(sampler, kernel);
    ASSERT_TRUE(chain.start(sampler, slice.numbers(slice.seed(k), sampler.layout())));
    Rng random(seed, Purpose::chain, static_cast<std::uint32_t>(group * chains + k));
    for (std::uint64_t i = 0; i < 100; ++i) {
      random.start(i);
      double expected = chain.current().total;
      chain.step(sampler, random, [&](const PrimaryStep<SampleSplats<Flatland>>& step) {
        deposit(step, ExpectedValues::deposit(step, {slice.tally().mean(), 0, 0.3}), film);
        if (step.accepted()) expected = step.proposed.total;
      });
      ASSERT_EQ(chain.current().total, expected);
    }
  }
  PssmltGroup<Flat, Kelemen, ExpectedValues> made(space, kernel, seed, group, chains);
  made.add_seeds(samples);
  made.start_chains(SeedTally(space.max_vertices()));
  made.advance(100 * chains);
  GroupsFilm actual({scene->bins()}), by_hand({scene->bins()});
  MutationStatistics statistics(made.move_names(), scene->bins(), scene->max_vertices());
  ChainDraws draws;
  made.deliver(actual, statistics, draws);
  by_hand.add(film, 1, 100 * chains);
  const std::vector<double> a = actual.estimate().value, e = by_hand.estimate().value;
  for (std::size_t bin = 0; bin < e.size(); ++bin)
    EXPECT_NEAR(a[bin], e[bin], 1e-12 * slice.tally().mean()) << "bin " << bin;
}

// The first step goes to the length in whose interval the given number lies.
TEST(LengthSequences, BeginWhereTheyAreTold) {
  for (const double first : {0.0, 0.1, 0.3, 0.9}) {
    LengthSequence lengths({0.25, 0.5, 0.25}, first);
    EXPECT_EQ(lengths.next(), first < 0.25 ? 0u : first < 0.75 ? 1u : 2u) << first;
  }
}

// What two of them drew alike would show in no film: each by itself is right.
TEST(LengthNumbers, GiveEveryChainOfEveryGroupAStreamOfItsOwn) {
  std::set<double> first;
  for (int group = 0; group < 3; ++group) {
    const LengthNumbers numbers(7, group, 4);
    for (int k = 0; k < 4; ++k) first.insert(numbers.chain(k).uniform());
  }
  EXPECT_EQ(first.size(), 12u);
}

// All light that others found is in paths of two vertices: 0.9 of the steps go there, and a tenth
// is spread evenly, whatever the group's own slice holds.
TEST(MmltGroups, ShareTheirStepsByTheLightThatOtherGroupsFound) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  const int lengths = space.max_vertices() - 1;
  MmltGroup<Flat, Kelemen, ExpectedValues> made(space, {Kelemen{}, 0.3}, seed, group, 1);
  made.add_seeds(2000);
  SeedTally others(space.max_vertices());
  others.samples = 1;
  others.total += 1;
  others.sum[0] += 1;
  made.start_chains(others);
  made.advance(10'000);
  GroupsFilm film({scene->bins()});
  MutationStatistics statistics(made.move_names(), scene->bins(), scene->max_vertices());
  ChainDraws draws;
  made.deliver(film, statistics, draws);
  std::map<int, double> steps;
  for (const MutationRecord& record : statistics.records())
    for (const PathsRecord& part : record.by_length)
      steps[part.vertices] += static_cast<double>(part.proposed);
  ASSERT_EQ(steps.size(), static_cast<std::size_t>(lengths)) << "a seed of each length";
  for (const auto& [vertices, count] : steps) {
    const double share = 0.1 / lengths + (vertices == 2 ? 0.9 : 0);
    EXPECT_NEAR(count, 10'000 * share, 5) << vertices << " vertices";
  }
}

}  // namespace
}  // namespace wander::test

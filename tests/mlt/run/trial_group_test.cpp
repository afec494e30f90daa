// A trial keeps what a group of chains with the same seed brings to its film, item by item.
#include "mlt/run/trial_group.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "lab/copied_seeds.h"
#include "mlt/run/chain_groups.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/path_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/catalogue.h"
#include "mutations/kelemen.h"
#include "tests/support/test_scenes.h"

namespace wander::test::trial_group_test {
namespace {

using Flat = Transport<Flatland>;

class TrialGroups : public ::testing::Test {
 protected:
  template <class Chains, class Kernel>
  void expect_the_same(const Kernel& kernel) {
    ChainGroup<Chains> group(space_, kernel, 3, 1, 2, {});
    TrialGroup<Chains> trial(space_, kernel, 3, 1, 2, {});
    SeedTally others(space_.max_vertices());
    const auto run = [&](auto& made) {
      for (int round = 0; round < 2; ++round) made.add_seeds(150);
      made.end_seeds();
      made.start_chains(others);
      for (const std::uint64_t steps : {2u, 98u, 7u}) made.advance(steps);
    };
    run(group);
    run(trial);
    compare(group.findings(), trial.findings());
    EXPECT_EQ(trial.steps(), 107);
    EXPECT_EQ(trial.findings().rays, static_cast<double>(group.tally().rays));

    TrialGroup<Chains> first(space_, kernel, 3, 1, 2, {}), other(space_, kernel, 3, 1, 2, {});
    first.add_seeds(150);
    CopiedSeeds(first).give(other);
    other.add_seeds(150);
    other.end_seeds();
    other.start_chains(others);
    other.advance(107);
    compare(group.findings(), other.findings());
  }

 private:
  void compare(const GroupFindings& group, const TrialFindings& trial) const {
    std::vector<double> film(group.film->bins());
    std::set<std::pair<int, double>> places;
    for (const auto& [bin, weight, ratio] : trial.log->deposits) {
      film[static_cast<std::size_t>(bin)] += weight;
      places.emplace(bin, ratio);
    }
    for (const auto& [bin, stratum, ratio] : trial.log->states)
      EXPECT_TRUE(places.contains({bin, ratio})) << "a state deposits where it is";
    const std::vector<double> expected = group.film->weights();
    for (std::size_t j = 0; j < film.size(); ++j)
      EXPECT_NEAR(film[j], expected[j], 1e-12 * (1 + film[j])) << j;
    expect_equal(of_states(trial), of_states(group));
    expect_equal(of_samples(trial), of_samples(group));
    EXPECT_EQ(trial.log->samples, 300);
    EXPECT_LT(trial.log->found.back().sample, 300);
    EXPECT_GT(trial.log->found.back().sample, 150);
  }
  static RatioHistogram of_states(const TrialFindings& trial) {
    RatioHistogram all;
    for (const auto& [bin, stratum, ratio] : trial.log->states)
      all.add(ratio, trial.light_of_states[stratum]);
    return all;
  }
  static RatioHistogram of_states(const GroupFindings& group) {
    RatioHistogram all;
    for (const StateRatios& stratum : group.states) all.add(*stratum.ratios, stratum.weight);
    return all;
  }
  static RatioHistogram of_samples(const TrialFindings& trial) {
    RatioHistogram all;
    for (const auto& [sample, bin, light, ratio] : trial.log->found) all.add(ratio, light / ratio);
    return all;
  }
  static RatioHistogram of_samples(const GroupFindings& group) {
    RatioHistogram all;
    for (const RatioHistogram& stratum : group.evidence->ratios) all.add(stratum, 1);
    return all;
  }
  static void expect_equal(const RatioHistogram& a, const RatioHistogram& b) {
    EXPECT_GT(a.count(), 0);
    EXPECT_NEAR(a.count(), b.count(), 1e-9 * b.count());
    for (int i = std::min(a.first(), b.first()); i < std::max(a.end(), b.end()); ++i)
      EXPECT_NEAR(a[i].sum, b[i].sum, 1e-9 * b[i].sum) << i;
  }

  FlatScene scene_ = build(diffuse_room());

 protected:
  Flat space_{*scene_, Roulette::off};
};

TEST_F(TrialGroups, OfPathsKeepWhatTheirFilmIsMadeOf) {
  expect_the_same<PathChains<Flat, Family>>(make_family({}, space_.max_vertices()));
}
TEST_F(TrialGroups, OfSamplesKeepWhatTheirFilmIsMadeOf) {
  expect_the_same<PssmltGroup<Flat, Kelemen, KelemenWeights>::Source>(
      PrimaryKernel<Kelemen>{Kelemen{}, 0.3});
}
TEST_F(TrialGroups, OfLengthsKeepWhatTheirFilmIsMadeOf) {
  expect_the_same<MmltGroup<Flat, Kelemen, ExpectedValues>::Source>(
      PrimaryKernel<Kelemen>{Kelemen{}, 0.3});
}

// To a pilot whose target is f v that is the light, of samples as of chains.
TEST_F(TrialGroups, OfAnUnevenTargetFindWhatIsMeasured) {
  std::vector<double> factors(static_cast<std::size_t>(space_.scene().bins()));
  for (std::size_t j = 0; j < factors.size(); ++j) factors[j] = j % 2 == 0 ? 4 : 0.5;
  const ImportanceMap importance(Raster(space_.scene().bins()), factors);
  const Flat measuring = space_.measuring(importance);
  const Family family = make_family({}, space_.max_vertices());
  TrialGroup<PathChains<Flat, Family>> of_light(space_, family, 3, 1, 2, {}),
      measured(measuring, family, 3, 1, 2, {});
  of_light.add_seeds(150);
  measured.add_seeds(150);
  const TrialFindings light = of_light.findings(), measure = measured.findings();
  ASSERT_GT(light.log->found.size(), 50u);
  ASSERT_EQ(light.log->found.size(), measure.log->found.size());
  for (std::size_t i = 0; i < light.log->found.size(); ++i) {
    const auto &x = light.log->found[i], &y = measure.log->found[i];
    const double v = factors[static_cast<std::size_t>(x.bin)];
    EXPECT_EQ(y.bin, x.bin);
    EXPECT_EQ(y.light, v * x.light);
    EXPECT_EQ(y.ratio, v * x.ratio);
  }
}

// A step or sample of n vertices may cost n².
TEST(Turns, HaveFewerStepsWherePathsAreLong) {
  EXPECT_EQ(turn_of(1024, 2), 1024u);
  EXPECT_EQ(turn_of(1024, 32), 1024u);
  EXPECT_EQ(turn_of(1024, 64), 256u);
  EXPECT_EQ(turn_of(1024, 300), 11u);
  EXPECT_EQ(turn_of(256, 1000), 1u) << "none makes nothing";
}

}  // namespace
}  // namespace wander::test::trial_group_test

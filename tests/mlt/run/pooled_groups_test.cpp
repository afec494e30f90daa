// What a group brings to a pooled film, samples and chains together, has no bias for any number of
// either: E[E_j + b_g D^M_j] = I_j, for any border that does not know the group's own samples.
//
// False alarms: 1e-9 per method.  Groups have one sample before the chain and one beside it, and two
// steps, so that many are dark and chains are where they began: there the flaws of the twins show most.
#include <gtest/gtest.h>

#include <cmath>

#include "core/exact/radiosity.h"
#include "mlt/run/mmlt_group.h"
#include "mlt/run/path_group.h"
#include "mlt/run/pssmlt_group.h"
#include "mutations/catalogue.h"
#include "mutations/kelemen.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/statistics.h"

namespace wander::test::pooled_groups_test {
namespace {

using Flat = Transport<Flatland>;

constexpr int groups = 70'000, chains = 1;
constexpr std::uint64_t samples = 1, steps = 2, beside = 1;

// How a twin may go wrong.
enum class Flaw {
  none,
  sides_overlap,      // the chains deposit all, whatever samples take
  another_constant,   // b of all groups instead of b_g
  late_constant,      // b_g of the samples beside the chains as well
  border_of_its_own,  // c by the samples that it weighs
};

double border_of(double light) { return 2 * light; }

template <class Group, class Kernel>
class Trial {
 public:
  Trial(const Kernel& kernel, Flaw flaw) : kernel_(kernel), flaw_(flaw) {
    SeedSlice<Flat> slice(space_, 2, 0, 1);
    slice.run(20'000);
    others_.merge(slice.tally());
  }

  // The mean over all groups of each bin, and of all together, against the exact film.
  Decision run() {
    const std::vector<double> exact =
        exact::solve_radiosity(exact::radiosity_scene(room_.description())).film().mean_irradiance;
    std::vector<Moments> bins(exact.size());
    Moments total;
    for (int g = 0; g < groups; ++g) add(g, bins, total);
    const double each = sidak_rate(usual_false_alarm, exact.size() + 1);
    double mean = 0;
    for (const double value : exact) mean += value / static_cast<double>(exact.size());
    Decision worst = t_test(total, mean, each);
    for (std::size_t j = 0; j < exact.size(); ++j) {
      const Decision decision = t_test(bins[j], exact[j], each);
      if (decision.p_value <= worst.p_value) worst = decision;
    }
    return worst;
  }

 private:
  Group made(int g, double light) const {
    Group group(space_, kernel_, 1, g, chains);
    group.divide({{border_of(light)}});
    group.add_seeds(samples);
    return group;
  }

  void add(int g, std::vector<Moments>& bins, Moments& total) {
    double light = others_.mean();
    if (flaw_ == Flaw::border_of_its_own) light = made(g, light).tally().mean();
    Group group = made(g, light);
    group.end_seeds();
    group.start_chains(others_);
    if (group.takes_steps()) group.advance(steps);
    group.add_seeds(beside);
    const GroupFindings found = group.findings();
    const double scale = found.scale * factor(group);
    const auto count = static_cast<double>(bins.size());
    const GroupFilm& hard =
        flaw_ == Flaw::sides_overlap ? *found.film : found.parts.front().of_chains();
    double sum = 0;
    for (std::size_t j = 0; j < bins.size(); ++j) {
      const double light =
          found.parts.front().of_samples().weight(j) / (samples + beside) + scale * hard.weight(j);
      bins[j].add(count * light);
      sum += light;
    }
    total.add(sum);
  }
  double factor(const Group& group) const {
    if (group.seed_tally().mean() == 0) return 1;
    if (flaw_ == Flaw::another_constant) return others_.mean() / group.seed_tally().mean();
    if (flaw_ == Flaw::late_constant) return group.tally().mean() / group.seed_tally().mean();
    return 1;
  }

  SceneMaker room_ = open_room(5);
  decltype(room_.build()) scene_ = room_.build();
  Flat space_{*scene_, Roulette::off};
  Kernel kernel_;
  Flaw flaw_;
  SeedTally others_{space_.max_vertices()};
};

Decision by_paths(Flaw flaw) {
  return Trial<PathGroup<Flat, Family>, Family>(make_family({}, 5), flaw).run();
}
template <template <class, class, class> class Chains, class Estimator>
Decision by_numbers(Flaw flaw) {
  using Kernel = PrimaryKernel<Kelemen>;
  return Trial<Chains<Flat, Kelemen, Estimator>, Kernel>({Kelemen{}, default_large_step}, flaw)
      .run();
}

TEST(PooledGroups, OfPathsHaveNoBias) { EXPECT_TRUE(passes(by_paths(Flaw::none))); }
TEST(PooledGroups, OfWholeSamplesHaveNoBias) {
  EXPECT_TRUE(passes(by_numbers<PssmltGroup, ExpectedValues>(Flaw::none)));
  EXPECT_TRUE(passes(by_numbers<PssmltGroup, KelemenWeights>(Flaw::none)));
}
TEST(PooledGroups, OfMultiplexedPathsHaveNoBias) {
  EXPECT_TRUE(passes(by_numbers<MmltGroup, ExpectedValues>(Flaw::none)));
  EXPECT_TRUE(passes(by_numbers<MmltGroup, KelemenWeights>(Flaw::none)));
}

TEST(PooledTwins, WhoseSidesOverlapAreCaught) {
  EXPECT_TRUE(rejects(by_paths(Flaw::sides_overlap)));
  EXPECT_TRUE(rejects(by_numbers<PssmltGroup, ExpectedValues>(Flaw::sides_overlap)));
}
TEST(PooledTwins, WithTheConstantOfAllGroupsAreCaught) {
  EXPECT_TRUE(rejects(by_paths(Flaw::another_constant)));
}
TEST(PooledTwins, WithAConstantThatSamplesBesideTheChainsHaveMovedAreCaught) {
  EXPECT_TRUE(rejects(by_paths(Flaw::late_constant)));
}
TEST(PooledTwins, WithABorderByTheSamplesThatItWeighsAreCaught) {
  EXPECT_TRUE(rejects(by_paths(Flaw::border_of_its_own)));
}

}  // namespace
}  // namespace wander::test::pooled_groups_test

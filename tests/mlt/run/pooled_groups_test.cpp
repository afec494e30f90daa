// What a group brings to a pooled film, samples and chains together, has no bias for any number of
// either: E[E_j + b_g D^M_j] = I_j, for any border that does not know the group's own samples, with or without an end; and
// for any target f v, if seeds are drawn by it, b_g is that of it, and deposits count 1/v times.
//
// False alarms: 1e-9 per method.  Groups have one sample before the chain and one beside it, and two
// steps, so that many are dark and chains are where they began: there the flaws of the twins show most.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
  constant_of_light,  // b_g of f, of chains whose target is f v
  undivided,          // deposits of such chains count once
};

double border_of(double light) { return 2 * light; }

// Chains come to some bins much more often than light does.
ImportanceMap uneven() { return {Raster(4), {0.25, 4, 1, 8}}; }

template <class Group, class Kernel>
class Trial {
 public:
  Trial(const Kernel& kernel, Flaw flaw, double end, const ImportanceMap* importance)
      : importance_(importance),
        space_(importance ? plain_.measuring(*importance) : plain_),
        kernel_(kernel),
        flaw_(flaw),
        end_(end) {
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
    group.divide({{border_of(light), end_ * light}});
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
    const std::vector<double> easy = found.parts.front().of_samples().weights(),
                              of_hard = hard.weights();
    double sum = 0;
    for (std::size_t j = 0; j < bins.size(); ++j) {
      const double of_chains = scale * of_hard[j] * factor_of_bin(static_cast<int>(j));
      const double light = easy[j] / (samples + beside) + of_chains;
      bins[j].add(count * light);
      sum += light;
    }
    total.add(sum);
  }
  double factor(const Group& group) const {
    if (group.seed_tally().mean() == 0) return 1;
    if (flaw_ == Flaw::another_constant) return others_.mean() / group.seed_tally().mean();
    if (flaw_ == Flaw::late_constant) return group.tally().mean() / group.seed_tally().mean();
    if (flaw_ == Flaw::constant_of_light)
      return group.seed_tally().mean() / group.seed_tally().mean_measure();
    return 1;
  }
  double factor_of_bin(int bin) const {
    return flaw_ == Flaw::undivided ? 1 / light_of_measure(space_, bin) : 1;
  }

  SceneMaker room_ = open_room(5);
  decltype(room_.build()) scene_ = room_.build();
  Flat plain_{*scene_, Roulette::off};
  const ImportanceMap* importance_;
  Flat space_;
  Kernel kernel_;
  Flaw flaw_;
  double end_;  // over the light
  SeedTally others_{space_.max_vertices()};
};

constexpr double no_end = std::numeric_limits<double>::infinity();

Decision by_paths(Flaw flaw, double end = no_end, const ImportanceMap* importance = nullptr) {
  return Trial<PathGroup<Flat, Family>, Family>(make_family({}, 5), flaw, end, importance).run();
}
Decision by_uneven_paths(Flaw flaw) {
  const ImportanceMap importance = uneven();
  return by_paths(flaw, no_end, &importance);
}
template <template <class, class, class> class Chains, class Estimator>
Decision by_numbers(Flaw flaw) {
  using Kernel = PrimaryKernel<Kelemen>;
  return Trial<Chains<Flat, Kelemen, Estimator>, Kernel>({Kelemen{}, default_large_step}, flaw,
                                                         no_end, nullptr)
      .run();
}

TEST(PooledGroups, OfPathsHaveNoBias) { EXPECT_TRUE(passes(by_paths(Flaw::none))); }
TEST(PooledGroups, OfABorderWithAnEndHaveNoBias) { EXPECT_TRUE(passes(by_paths(Flaw::none, 3))); }
TEST(PooledGroups, OfAnUnevenTargetHaveNoBias) { EXPECT_TRUE(passes(by_uneven_paths(Flaw::none))); }
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

TEST(PooledTwins, WhoseUnevenTargetHasTheConstantOfLightAreCaught) {
  EXPECT_TRUE(rejects(by_uneven_paths(Flaw::constant_of_light)));
}
TEST(PooledTwins, WhoseUnevenTargetIsTakenForLightAreCaught) {
  EXPECT_TRUE(rejects(by_uneven_paths(Flaw::undivided)));
}

}  // namespace
}  // namespace wander::test::pooled_groups_test

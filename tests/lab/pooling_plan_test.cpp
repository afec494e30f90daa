// What a run of chains decides by its pilot, and that a run which is carried on has decided the same.
#include "lab/pooling_plan.h"

#include <gtest/gtest.h>

#include "lab/drive.h"
#include "lab/scene_source.h"
#include "lab/world_methods.h"

namespace wander::test::pooling_plan_test {
namespace {

constexpr std::size_t bins = 100;
constexpr ChainSettings usual{.film_parts = FilmParts::pooled};

// So many of its samples found a path of ratio 10⁴.
Pilot pilot_that_found(int paths) {
  constexpr double samples = most_samples_of_a_pilot;
  Pilot pilot{.samples = samples, .rays = 5 * samples};
  for (int i = 0; i < paths; ++i) pilot.found.add(1e4);
  return pilot;
}
const Pilot rare = pilot_that_found(3), telling = pilot_that_found(100);

Session session_of(const Budget& budget) {
  Session session;
  session.budget = budget;
  session.threads = 2;
  return session;
}

PoolingPlan plan(const Pilot& pilot, const Budget& budget, const ChainSettings& settings = usual) {
  const Session session = session_of(budget);
  const Run run(session);
  return PoolingPlanner(run, settings, bins).by_chains(pilot);
}
int chains(const PoolingPlan& plan, std::uint64_t steps) {
  return plan.settings.groups * plan.settings.chains_for(steps);
}

TEST(PoolingPlan, HasManySeedsAndChainsWhereLightIsRare) {
  EXPECT_EQ(plan(rare, SampleBudget{1'000'000}).seed_share, RareLight::samples_per_step);
  EXPECT_EQ(plan(rare, TimeBudget{10}).seed_share, RareLight::seed_share_of_time);
  EXPECT_EQ(chains(plan(rare, SampleBudget{10'000'000}), 10'000'000),
            64 * RareLight::chains_per_group);
  EXPECT_EQ(chains(plan(telling, SampleBudget{10'000'000}), 10'000'000), 64 * 2);
  EXPECT_EQ(chains(plan(rare, SampleBudget{100'000}), 100'000), 64) << "none that is too short";
}

TEST(PoolingPlan, LeavesWhatIsAskedFor) {
  ChainSettings asked = usual;
  asked.seed_share = 0.5;
  const PoolingPlan of_share = plan(rare, SampleBudget{10'000'000}, asked);
  EXPECT_EQ(of_share.seed_share, 0.5);
  EXPECT_EQ(of_share.pooling.samples_per_step, 0) << "all samples before the chains";

  ChainSettings given = usual;
  given.chains_per_group = 3;
  given.steps_per_chain = 0;
  EXPECT_EQ(chains(plan(rare, SampleBudget{10'000'000}, given), 10'000'000), 64 * 3);
}

TEST(PoolingPlan, HasAsManySeedsAsSlicesNeedWhereSamplesGoOn) {
  const PoolingPlan made = plan(telling, SampleBudget{10'000'000});
  EXPECT_EQ(made.seed_share, 0);
  // 16 effective samples for each of 64 groups, where one in 327 is effective
  EXPECT_NEAR(static_cast<double>(made.settings.fewest_seeds), 16 * 64 * 32'768 / 100., 1);
  EXPECT_EQ(plan(telling, SampleBudget{100'000}).settings.fewest_seeds, usual.fewest_seeds)
      << "no more than a quarter of the steps, but for the fewest";
}

// They may promise a multiple of what they keep.
TEST(PoolingPlan, AsksMuchOfChains) {
  int otherwise = 0;
  for (int count = 5; count <= 1280; count *= 2) {
    Pilot pilot{.samples = 10'000, .rays = 25'000};
    for (int i = 0; i < 5000; ++i) pilot.found.add(1);
    for (int i = 0; i < count; ++i) pilot.found.add(400);
    const double c = plan(pilot, TimeBudget{10}).pooling.partition.c;
    EXPECT_EQ(c, cautious_pooling(pilot, bins).partition.c) << count;
    if (c != best_pooling(pilot, bins).partition.c) ++otherwise;
  }
  EXPECT_GE(otherwise, 1);
}

struct OfRareLight {
  OfRareLight()
      : session(session_of(SampleBudget{steps})),
        execution(session),
        job(open_scene(std::string(gallery_prefix) + "article-4").scene, find_method("mlt"),
            {.chains = usual}),
        methods(job, execution) {}

  static constexpr std::uint64_t steps = 10'000'000;
  Session session;
  Run execution;
  Job job;
  WorldMethods<Flatland> methods;
};

// Kept before its chains start, it has what the pilot said of them.
TEST(PoolingPlan, IsThatOfTheRunThatIsCarriedOn) {
  const OfRareLight made;
  const auto first = made.methods.make(), second = made.methods.make();
  first->prepare();
  first->seed(1);
  EXPECT_EQ(first->settings().chains_for(made.steps), RareLight::chains_per_group);
  restore(*second, state_of(*first));
  EXPECT_EQ(second->settings(), first->settings());
  EXPECT_EQ(second->seed_share(), first->seed_share());
}

}  // namespace
}  // namespace wander::test::pooling_plan_test

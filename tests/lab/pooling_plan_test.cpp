// What a run of chains decides by its pilot, and that a run which is carried on has decided the same.
#include "lab/pooling_plan.h"

#include <gtest/gtest.h>

#include "lab/drive.h"
#include "lab/run_state.h"
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

PoolingPlan plan(const Pilot& pilot, const Budget& budget, const ChainSettings& settings = usual,
                 FilmKind film = FilmKind::curve, int max_vertices = 10) {
  const Session session = session_of(budget);
  const Run run(session);
  return PoolingPlanner(run, settings, {film, bins, max_vertices}).by_chains(pilot);
}
PoolingPlan plan_of_image(const Pilot& pilot, const Budget& budget,
                          const ChainSettings& settings = usual, int max_vertices = 10) {
  return plan(pilot, budget, settings, FilmKind::image, max_vertices);
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

// Nobody knows how many steps that takes: if all samples were made before the chains their error would stay.
TEST(PoolingPlan, OfAnErrorHasTheSamplesThatAreAskedForBesideItsChains) {
  ChainSettings asked = usual;
  asked.seed_share = 0.3;
  for (const FilmKind film : {FilmKind::curve, FilmKind::image}) {
    const Pooling made = plan(telling, ErrorBudget{0.01}, asked, film).pooling;
    EXPECT_EQ(made.samples_per_step, 0.3);
    EXPECT_GT(made.partition.c, 0);
  }
}

double steps_per_chain(const Budget& budget, const ChainSettings& settings,
                       FilmKind film = FilmKind::curve) {
  const Session session = session_of(budget);
  const Run run(session);
  return PoolingPlanner(run, settings, {film, bins, 10}).steps_per_chain();
}

// Of an error a run starts one chain of each group, unless more are asked for; it may take as many steps as give each of
// the most chains the usual number.
TEST(PoolingPlan, KnowsHowLongItsChainsWillBe) {
  ChainSettings given = usual;
  given.chains_per_group = 3;
  given.steps_per_chain = 0;
  const double of_each = static_cast<double>(usual.steps_per_chain);
  EXPECT_EQ(steps_per_chain(ErrorBudget{0.01}, given), of_each);
  for (const FilmKind film : {FilmKind::curve, FilmKind::image})
    EXPECT_EQ(steps_per_chain(ErrorBudget{0.01}, usual, film), 4 * of_each);
  EXPECT_EQ(steps_per_chain(SampleBudget{192'000}, given), 1000);
  EXPECT_EQ(steps_per_chain(SampleBudget{6'400'000}, usual), 100'000);
  EXPECT_EQ(steps_per_chain(SampleBudget{6'553'600}, usual, FilmKind::image), 1600);
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

// Of an image, if the budget or the user does not say how many samples there are.
TEST(PoolingPlan, LeavesToSamplesWhatItsPartitionDoes) {
  const Session session = session_of(TimeBudget{10});
  const wander::Run run(session);
  ChainSettings given = usual;
  given.seed_share = 0.5;
  int left = 0, shared = 0;
  for (const double ratio : {1.0, 4e2, 1e5})
    for (int count = 5; count <= 1280; count *= 2) {
      Pilot pilot{.samples = 10'000, .rays = 25'000};
      for (int i = 0; i < 5000; ++i) pilot.found.add(1);
      for (int i = 0; i < count; ++i) pilot.found.add(ratio);
      const PoolingPlanner image(run, usual, {FilmKind::image, bins, 10});
      const bool is_left = image.leaves_to_samples(pilot);
      EXPECT_EQ(is_left, is_left_to_samples(image.by_chains(pilot).pooling, pilot.b())) << count;
      (is_left ? left : shared) += 1;
      EXPECT_FALSE(
          PoolingPlanner(run, usual, {FilmKind::curve, bins, 10}).leaves_to_samples(pilot));
      EXPECT_FALSE(
          PoolingPlanner(run, given, {FilmKind::image, bins, 10}).leaves_to_samples(pilot));
    }
  EXPECT_GE(left, 1);
  EXPECT_GE(shared, 1);
}

// So much of its light is hard, and chains that hardly move know of that what their seeds do.
Pilot of_hard_light(int percent) {
  Pilot pilot{.samples = 10'000, .rays = 25'000, .steps_per_chain = 1000};
  for (int i = 0; i < 9000; ++i) pilot.found.add(1);
  pilot.chains.resize(1);
  for (int i = 0; i < 1000; ++i) pilot.chains[0].add(i % 100 < percent ? 1e5 : 1);
  for (const double c : borders_around(pilot.b()))
    pilot.borders.push_back({.c = c, .steps_per_draw = 500, .steps_per_draw_of_total = 500});
  return pilot;
}

// Chains that know its light at once.
Pilot of_quick_chains() {
  Pilot pilot{.samples = 10'000, .rays = 25'000, .steps_per_chain = 1e6};
  for (int i = 0; i < 5000; ++i) pilot.found.add(1);
  for (int i = 0; i < 80; ++i) pilot.found.add(400);
  for (const double c : borders_around(pilot.b()))
    pilot.borders.push_back({.c = c, .steps_per_draw = 1, .steps_per_draw_of_total = 1});
  return pilot;
}

// A thousand steps tell less than the 32768 samples before them.
TEST(PoolingPlan, LeavesTheLightToTheSeedPassWhereStepsAreFew) {
  const Pilot pilot = of_quick_chains();
  for (const FilmKind film : {FilmKind::curve, FilmKind::image}) {
    const auto border = [&](std::uint64_t steps) {
      return plan(pilot, SampleBudget{steps}, usual, film).pooling.partition.c;
    };
    EXPECT_GE(border(1000), 16 * border(10'000'000));
  }
}

TEST(PoolingPlan, OfAnImageHasAllSamplesBeforeItsChains) {
  int otherwise = 0;
  for (const int percent : {1, 10, 50})
    for (const Budget& budget : {Budget{SampleBudget{10'000'000}}, Budget{TimeBudget{10}}}) {
      const Pilot pilot = of_hard_light(percent);
      Pilot with_all = pilot;
      with_all.steps_per_seed.reset();
      const bool is_of_time = std::holds_alternative<TimeBudget>(budget);
      const Pooling expected =
          cautious_pooling(with_all, bins, is_of_time ? usual_most_cost : most_cost_of_given_steps);
      const PoolingPlan made = plan_of_image(pilot, budget), of_curve = plan(pilot, budget);
      EXPECT_EQ(made.pooling.partition.c, expected.partition.c) << percent;
      EXPECT_EQ(made.pooling.samples_per_step, expected.samples_per_step) << percent;
      EXPECT_DOUBLE_EQ(made.seed_share,
                       expected.samples_per_step * (is_of_time ? expected.cost_of_sample : 1));
      EXPECT_EQ(of_curve.seed_share, 0);
      if (made.pooling.partition.c != of_curve.pooling.partition.c) ++otherwise;
    }
  EXPECT_GE(otherwise, 1) << "chains of few seeds know less";
  EXPECT_EQ(plan_of_image(of_hard_light(50), ErrorBudget{0.01}).seed_share, 0)
      << "who knows how many";
}

TEST(PoolingPlan, OfAnImageHasManyChains) {
  EXPECT_EQ(chains(plan_of_image(rare, SampleBudget{10'000'000}), 10'000'000), 4096);
  EXPECT_EQ(chains(plan_of_image(rare, SampleBudget{100'000}), 100'000), 64);
  int few = 0, many = 0;
  for (const Pilot& pilot : {of_hard_light(0), of_hard_light(50), of_quick_chains()}) {
    const PoolingPlan made = plan_of_image(pilot, TimeBudget{10});
    const bool has_more_samples = made.pooling.samples_per_step >= 1;
    EXPECT_EQ(chains(made, 10'000'000), 4096);
    EXPECT_EQ(chains(made, 1'000'000), has_more_samples ? 4096 : 960);
    ++(has_more_samples ? many : few);
  }
  EXPECT_GE(many, 1);
  EXPECT_GE(few, 1);
  ChainSettings given = usual;
  given.chains_per_group = 3;
  given.steps_per_chain = 0;
  EXPECT_EQ(chains(plan_of_image(telling, SampleBudget{10'000'000}, given), 10'000'000), 64 * 3);
}

TEST(PoolingPlan, HasFewerChainsOfLongPaths) {
  const auto of_vertices = [](int max_vertices) {
    return chains(plan_of_image(rare, SampleBudget{10'000'000}, usual, max_vertices), 10'000'000);
  };
  EXPECT_EQ(of_vertices(64), of_vertices(32) / 2);
  EXPECT_EQ(of_vertices(1000), 64 * usual.chains_per_group);
}

// What few samples have not seen may be as bright as a pixel is.
TEST(PoolingPlan, OfAnImageAlwaysAsksChains) {
  Pilot easy{.samples = 10'000, .rays = 25'000};
  for (int i = 0; i < 5000; ++i) easy.found.add(1);
  const auto decides = [&](FilmKind film) {
    const Session session = session_of(TimeBudget{10});
    const wander::Run run(session);
    return PoolingPlanner(run, usual, {film, bins, 10}).by_samples(easy).has_value();
  };
  EXPECT_TRUE(decides(FilmKind::curve));
  EXPECT_FALSE(decides(FilmKind::image));
}

// Where hardly any light was found an image has the border of the samples that it will have.
TEST(PoolingPlan, OfAnImageInTheDarkKnowsOfItsLongSeedPass) {
  ChainSettings asked = usual;
  asked.seed_share = RareLight::seed_share_of_time;
  const PoolingPlan made = plan_of_image(rare, TimeBudget{10}),
                    by_hand = plan_of_image(rare, TimeBudget{10}, asked);
  EXPECT_EQ(made.seed_share, RareLight::seed_share_of_time);
  EXPECT_EQ(made.pooling.partition.c, by_hand.pooling.partition.c);
  EXPECT_GT(made.pooling.partition.c, plan(rare, TimeBudget{10}).pooling.partition.c);
  EXPECT_EQ(plan_of_image(rare, ErrorBudget{0.01}).pooling.samples_per_step,
            fewest_samples_per_step)
      << "or the error of the samples' part would stay";
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

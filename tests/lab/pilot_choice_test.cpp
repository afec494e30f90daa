// What the pilot of a run leaves to samples and what to chains, on scenes of which it is known who does
// better.  Fixed seeds; whatever the seed, these are far from what is asked here.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lab/compare/make_runs.h"
#include "lab/engine.h"
#include "lab/scene_source.h"

namespace wander::test::pilot_choice_test {
namespace {

constexpr std::uint64_t steps = 200'000;

Rendering rendering(const char* scene) {
  Session session;
  session.budget = SampleBudget{steps};
  session.threads = 2;
  session.seed = 1;
  return render(Job(open_scene(std::string(gallery_prefix) + scene).scene, find_method("mlt")),
                session);
}
PoolingRecord choice(const char* scene) { return rendering(scene).pooling.value(); }

// Light comes from everywhere: as many samples as a budget of steps allows.
TEST(ChoicesInSpace, LeaveAnOpenBoxToSamples) {
  const PoolingRecord pooling = choice("cornell");
  EXPECT_GT(pooling.light_of_samples, 0.8);
  EXPECT_GT(2 * pooling.how.samples_per_step * pooling.how.cost_of_sample,
            most_cost_of_given_steps);
}

// All light comes through a slit that no connection finds.  With eight seeds samples carried 0.17 to 0.48
// of it, that of bright parts most of all, and there were as few as may be.
TEST(ChoicesInSpace, LeaveASlitToChains) {
  const PoolingRecord pooling = choice("slit-3d");
  EXPECT_LT(pooling.light_of_samples, 0.75);
  EXPECT_LE(pooling.how.samples_per_step, 4 * fewest_samples_per_step);
}

TEST(Choices, AskNoChainsAboutEasyLight) {
  EXPECT_EQ(choice("article-1").how.steps_per_draw, usual_steps_per_draw);
  EXPECT_NE(choice("slit").how.steps_per_draw, usual_steps_per_draw);
}

std::vector<double> film_of(const char* scene, const char* method, Target target) {
  Session session;
  session.budget = SampleBudget{20'000};
  session.seed = 1;
  return render(Job(open_scene(std::string(gallery_prefix) + scene).scene, find_method(method),
                    {.chains = {.target = target}}),
                session)
      .film.value;
}

// Of curves, and of chains of numbers, there is one target.
TEST(Targets, AreEvenOnImagesOfChainsOfPaths) {
  EXPECT_NE(film_of("cornell-glass", "mlt", Target::even),
            film_of("cornell-glass", "mlt", Target::light));
  EXPECT_EQ(film_of("article-1", "mlt", Target::even), film_of("article-1", "mlt", Target::light));
  EXPECT_EQ(film_of("cornell-glass", "pssmlt", Target::even),
            film_of("cornell-glass", "pssmlt", Target::light));
}

// One sample of sixty thousand finds light, and how many do says how bright the film is.  Where more find it, samples
// are few if steps earn more.
TEST(SeedPass, IsLongWhereLightIsRare) {
  constexpr std::uint64_t slices = 64;
  EXPECT_EQ(compare::seed_samples_of(rendering("article-4")), 4 * steps / slices * slices);
  EXPECT_LT(compare::seed_samples_of(rendering("corridor")), 3 * steps / 4);
}

}  // namespace
}  // namespace wander::test::pilot_choice_test

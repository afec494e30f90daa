// What samples and chains carry of each class of path is what they carry of the film: the mean over
// classes of what is left to chains is E_π[w_M], which the film's parts are made of, too.  Eight seeds,
// from both sides; false-alarm rate 1e-9 per decision.  The wrong twin, which must be caught, takes the
// samples' share for that of the chains.
#include <gtest/gtest.h>

#include <numeric>

#include "lab/engine.h"
#include "tests/support/expect.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

Rendering pooled(const char* method, std::uint64_t seed, int threads = 2) {
  Session session;
  session.budget = SampleBudget{40'000};
  session.threads = threads;
  session.seed = seed;
  return render(Job(mirror_and_glass(), find_method(method)), session);
}

TEST(ClassParts, AreThoseOfTheFilm) {
  std::vector<double> of_classes, of_film, of_twin;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const PoolingRecord pooling = pooled("mlt", seed).pooling.value();
    ASSERT_GE(pooling.classes.size(), 4u);
    double light = 0, of_chains = 0, twin = 0;
    for (const ClassRecord& each : pooling.classes) {
      light += each.light;
      of_chains += each.light * (1 - each.of_samples);
      twin += each.light * each.of_samples;
      EXPECT_GE(each.of_samples, 0) << each.path_class;
      EXPECT_LE(each.of_samples, 1) << each.path_class;
    }
    EXPECT_NEAR(light, 1, 1e-12);
    EXPECT_GE(pooling.classes.front().light, pooling.classes.back().light);
    of_classes.push_back(of_chains);
    of_twin.push_back(twin);
    of_film.push_back(1 - pooling.light_of_samples);
  }
  EXPECT_TRUE(passes(paired_t_test(of_classes, of_film, 1e-9)));
  EXPECT_TRUE(rejects(paired_t_test(of_twin, of_film, 1e-9)));
}

// A budget of mutations: on this scene samples would be worth more.
TEST(ClassParts, AreNotMadeByFarMoreSamplesThanStepsWereAskedFor) {
  const Pooling how = pooled("mlt", 1).pooling->how;
  EXPECT_LE(how.samples_per_step * how.cost_of_sample, most_cost_of_given_steps);
  EXPECT_GT(2 * how.samples_per_step * how.cost_of_sample, most_cost_of_given_steps);
}

TEST(ClassParts, OfTheFilmHaveTheMeanThatTheySay) {
  const Rendering run = pooled("mlt", 1);
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  EXPECT_NEAR(mean(run.pooling->film_of_samples),
              run.pooling->light_of_samples * mean(run.film.value), 1e-12 * mean(run.film.value));
}

TEST(ClassParts, DoNotDependOnTheThreads) {
  const PoolingRecord one = pooled("mlt", 1, 1).pooling.value(),
                      three = pooled("mlt", 1, 3).pooling.value();
  EXPECT_EQ(one.film_of_samples, three.film_of_samples);
  ASSERT_EQ(one.classes.size(), three.classes.size());
  for (std::size_t c = 0; c < one.classes.size(); ++c) {
    EXPECT_EQ(one.classes[c].path_class, three.classes[c].path_class);
    EXPECT_EQ(one.classes[c].light, three.classes[c].light);
    EXPECT_EQ(one.classes[c].of_samples, three.classes[c].of_samples);
  }
}

// States of chains in primary sample space are samples of many paths.
TEST(ClassParts, AreNoneWhereStatesHaveNoClass) {
  for (const char* method : {"pssmlt", "mmlt"}) {
    const PoolingRecord pooling = pooled(method, 1).pooling.value();
    EXPECT_TRUE(pooling.classes.empty()) << method;
    EXPECT_FALSE(pooling.film_of_samples.empty()) << method;
  }
}

}  // namespace
}  // namespace wander::test

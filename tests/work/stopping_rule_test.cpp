// Budgets of error: where the runs end, that the clock and the threads have no part in it, and that
// what they end with is what was asked for.
#include "work/stopping_rule.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/film_statistics.h"
#include "lab/estimate.h"
#include "lab/render.h"
#include "mutations/catalogue.h"
#include "tests/support/expect.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

Session until(double error, int threads) {
  Session session;
  session.budget = ErrorBudget{error};
  session.threads = threads;
  return session;
}

TEST(NextLook, FollowsTheSquareRootAndNeverCreeps) {
  EXPECT_EQ(next_look(1000, 0.012, 0.01), 1440u);
  EXPECT_EQ(next_look(1000, 0.0101, 0.01), 1100u);
  EXPECT_EQ(next_look(1000, 1, 0.01), 2000u);
  EXPECT_EQ(next_look(1000, NAN, 0.01), 2000u);
}

Rendering by_samples(const Scene<Flatland>& scene, const Session& session) {
  return estimate(scene, estimators()[2], session);
}
Rendering by_chains(const Scene<Flatland>& scene, const Session& session) {
  const Flat space(scene, Roulette::off);
  return ChainRenderer(space, make_family({}, space.max_vertices()), session, ChainSettings{})
      .render("mlt");
}

class ErrorBudgets
    : public ::testing::TestWithParam<Rendering (*)(const Scene<Flatland>&, const Session&)> {};
INSTANTIATE_TEST_SUITE_P(Methods, ErrorBudgets, ::testing::Values(&by_samples, &by_chains));

TEST_P(ErrorBudgets, AreMetAndHardlyMoreThanMet) {
  const FlatScene scene = build(diffuse_room());
  for (const double target : {0.01, 0.006}) {
    const Rendering r = GetParam()(*scene, until(target, 2));
    EXPECT_TRUE(r.complete);
    EXPECT_LE(relative_error(r.film), target);
    EXPECT_GT(relative_error(r.film), 0.7 * target);
  }
}

TEST_P(ErrorBudgets, GiveTheSameFilmForAnyNumberOfThreads) {
  const FlatScene scene = build(diffuse_room());
  const Rendering one = GetParam()(*scene, until(0.04, 1)),
                  three = GetParam()(*scene, until(0.04, 3));
  EXPECT_EQ(one.samples, three.samples);
  EXPECT_EQ(one.film.value, three.film.value);
  EXPECT_EQ(one.film.standard_error, three.film.standard_error);
}

// Looking at a film changes nothing of it.
TEST(ErrorBudgetOfSamples, GivesTheFilmOfSoManySamples) {
  const FlatScene scene = build(diffuse_room());
  const Rendering r = by_samples(*scene, until(0.006, 2));
  Session counted;
  counted.budget = SampleBudget{r.samples};
  const Rendering expected = by_samples(*scene, counted);
  EXPECT_GT(r.samples, std::uint64_t{1} << 16) << "more than one look";
  EXPECT_EQ(r.film.value, expected.film.value);
  EXPECT_EQ(r.film.standard_error, expected.film.standard_error);
}

TEST(ErrorBudgetInTheDark, EndsWithAZeroFilmOrWithoutLight) {
  const FlatScene scene = build(dark_room());
  const Rendering r = by_samples(*scene, until(0.1, 2));
  EXPECT_GE(r.samples, samples_in_the_dark);
  EXPECT_LE(r.samples, 2 * samples_in_the_dark);
  for (const double v : r.film.value) EXPECT_EQ(v, 0);
  EXPECT_THROW(by_chains(*scene, until(0.1, 2)), NoLightFound);
}

}  // namespace
}  // namespace wander::test

// Runs to an error that they cannot reach: all samples are made, and what these left unknown is more.  They end, and say so.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/film_statistics.h"
#include "lab/scene_source.h"
#include "lab/world_methods.h"
#include "tests/lab/counting_run.h"
#include "work/stopping_rule.h"

namespace wander::test::error_that_stays {
namespace {

constexpr double of_samples = 0.1;
constexpr std::uint64_t equal =
    1 << 20;  // mutations, after which chains leave as much unknown as samples

double error_after(std::uint64_t steps, double stays) {
  const double of_chains =
      of_samples * std::sqrt(static_cast<double>(equal) / static_cast<double>(steps));
  return std::hypot(stays, of_chains);
}

class RunOfFewSamples final : public CountingRun {
 public:
  explicit RunOfFewSamples(bool lacks) : CountingRun(30, 0), lacks_(lacks) {}

  bool lacks_samples(double) const override { return lacks_; }
  Rendering findings() const override {
    Rendering r = CountingRun::findings();
    r.film.standard_error = {error_after(samples(), lacks_ ? of_samples : 0)};
    r.film.degrees_of_freedom = 63;
    return r;
  }

 private:
  bool lacks_;
};

Rendering to_error(RunOfFewSamples& run, double error) {
  Session session;
  session.budget = ErrorBudget{error};
  session.threads = 1;
  Run execution(session);
  return drive(run, execution);
}

TEST(ErrorThatStays, EndsARun) {
  RunOfFewSamples run(true);
  const Rendering r = to_error(run, 0.9 * of_samples);
  EXPECT_GT(relative_error(r.film), 0.9 * of_samples);
  EXPECT_LT(run.samples(), 8 * equal);
  ASSERT_EQ(r.warnings.size(), 1u);
  EXPECT_NE(r.warnings[0].find("about 10 %"), std::string::npos) << r.warnings[0];
  EXPECT_NE(r.warnings[0].find("9 %"), std::string::npos) << r.warnings[0];
}

TEST(ErrorThatStays, IsNotThatOfARunThatGetsThere) {
  RunOfFewSamples above(true), without(false);
  const Rendering reached = to_error(above, 1.1 * of_samples),
                  far = to_error(without, of_samples / 20);
  EXPECT_LE(relative_error(reached.film), 1.1 * of_samples);
  EXPECT_LE(relative_error(far.film), of_samples / 20);
  EXPECT_TRUE(reached.warnings.empty());
  EXPECT_TRUE(far.warnings.empty());
}

bool lacks_samples(const ChainSettings& settings, double error) {
  Session session;
  session.budget = SampleBudget{20'000};
  session.threads = 1;
  Run execution(session);
  const Job job(open_scene(std::string(gallery_prefix) + "article-1").scene, find_method("mlt"),
                {.chains = settings});
  WorldMethods<Flatland> methods(job, execution);
  const auto run = methods.make();
  run->prepare();
  run->seed(512);
  return run->lacks_samples(error);
}

// Of a pooled film what samples know less well than chains could is their own part of it, not the brightness alone.
TEST(ErrorThatStays, IsWatchedWhereNoMoreSamplesAreMade) {
  ChainSettings pooled{.film_parts = FilmParts::pooled}, by_hand = pooled;
  by_hand.seed_share = 0.25;
  EXPECT_FALSE(lacks_samples(pooled, 1e-4)) << "they go on beside the chains";
  EXPECT_TRUE(lacks_samples(by_hand, 0.5));
  EXPECT_TRUE(lacks_samples({.film_parts = FilmParts::chains}, 1e-4));
  EXPECT_FALSE(lacks_samples({.film_parts = FilmParts::chains}, 0.5));
}

// Of 64 degrees of freedom e₂ may be e^½ times what steps alone would have left, and of 16 e times.
TEST(ErrorThatStays, IsSeenWhereItIsNoChance) {
  constexpr double by_steps = 0.1 / 2.828427;
  const auto is_seen = [](std::uint64_t samples, double error, double degrees,
                          double target = 0.01) {
    ErrorThatStays stays(target);
    EXPECT_FALSE(stays.seen(1000, 0.1, degrees));
    return stays.seen(samples, error, degrees).has_value();
  };
  EXPECT_TRUE(is_seen(8000, 1.66 * by_steps, 64));
  EXPECT_FALSE(is_seen(8000, 1.64 * by_steps, 64));
  EXPECT_TRUE(is_seen(8000, 2.73 * by_steps, 16));
  EXPECT_FALSE(is_seen(8000, 2.71 * by_steps, 16));
  EXPECT_FALSE(is_seen(7999, 0.1, 64)) << "too early";
}

// 0.06 after eight times the samples are 0.0519 and what steps leave.
TEST(ErrorThatStays, MayBeLessThanTheTarget) {
  for (const auto& [target, expected] : {std::pair(0.051, true), std::pair(0.053, false)}) {
    ErrorThatStays stays(target);
    EXPECT_FALSE(stays.seen(1000, 0.1, 64));
    EXPECT_EQ(stays.seen(8000, 0.06, 64).has_value(), expected) << target;
  }
}

}  // namespace
}  // namespace wander::test::error_that_stays

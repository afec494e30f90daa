// Runs to an error that they cannot reach: all samples are made, and what these left unknown is more.  They end, and say so.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "core/film_statistics.h"
#include "lab/scene_source.h"
#include "lab/world_methods.h"
#include "tests/lab/counting_run.h"
#include "work/stopping_rule.h"

namespace wander::test::error_that_stays_test {
namespace {

constexpr double of_samples = 0.1;
constexpr std::uint64_t equal =
    1 << 20;  // mutations, after which chains leave as much unknown as samples

double error_after(std::uint64_t steps, double stays) {
  const double of_chains =
      of_samples * std::sqrt(static_cast<double>(equal) / static_cast<double>(steps));
  return std::hypot(stays, of_chains);
}

// After `forever` mutations it has no error at all, so that a test that waits for an end has one.
class RunOfFewSamples final : public CountingRun {
 public:
  static constexpr std::uint64_t forever = std::uint64_t{1} << 40;

  explicit RunOfFewSamples(bool lacks, double degrees_of_freedom = 63)
      : CountingRun(30, 0), lacks_(lacks), degrees_of_freedom_(degrees_of_freedom) {}

  bool lacks_samples(double) const override { return lacks_; }
  Rendering findings() const override {
    Rendering r = CountingRun::findings();
    r.film.standard_error = {samples() < forever ? error_after(samples(), lacks_ ? of_samples : 0)
                                                 : 0};
    r.film.degrees_of_error = degrees_of_freedom_;
    return r;
  }

 private:
  bool lacks_;
  double degrees_of_freedom_;
};

Rendering to_error(LiveRun& run, double error, const Headway& begin = {}, const Keeper& keeper = {},
                   const std::atomic<bool>* interrupted = nullptr) {
  Session session;
  session.budget = ErrorBudget{error};
  session.threads = 1;
  session.interrupted = interrupted;
  Run execution(session);
  return drive(run, execution, begin, keeper);
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

// Of seven degrees of freedom two looks have to lie 64 times apart.
TEST(ErrorThatStays, EndsARunWhoseErrorIsRoughlyKnown) {
  RunOfFewSamples run(true, 7);
  EXPECT_EQ(to_error(run, 0.9 * of_samples).warnings.size(), 1u);
  EXPECT_GT(run.samples(), 8 * equal);
  EXPECT_LE(run.samples(), 64 * equal);
}

// It is carried on with what it has seen: to where it would have come, and when it is there, to there again.
TEST(ErrorThatStays, IsKnownToARunThatIsCarriedOn) {
  constexpr double target = 0.9 * of_samples;
  RunOfFewSamples straight(true);
  Headway end;
  const Keeper keep_end{[&](const Headway& headway, const StateWriter&) { end = headway; }};
  to_error(straight, target, {}, keep_end);
  const std::uint64_t samples = straight.samples();
  const Rendering again = to_error(straight, target, end);
  EXPECT_EQ(straight.samples(), samples);
  EXPECT_EQ(again.warnings.size(), 1u);

  RunOfFewSamples stopped(true);
  std::atomic<bool> interrupted = false;
  Headway middle;
  const Keeper keep_middle{[&](const Headway& headway, const StateWriter&) {
                             middle = headway;
                             interrupted = stopped.samples() > samples / 2;
                           },
                           1e-9, 1e-9};
  to_error(stopped, target, {}, keep_middle, &interrupted);
  EXPECT_GT(stopped.samples(), samples / 2);
  EXPECT_LT(stopped.samples(), samples);
  to_error(stopped, target, middle);
  EXPECT_EQ(stopped.samples(), samples);
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

class RunOfUnknownError final : public CountingRun {
 public:
  explicit RunOfUnknownError(double value) : CountingRun(30, 0), value_(value) {}

  Rendering findings() const override {
    Rendering r = CountingRun::findings();
    r.film.value = {value_};
    r.film.standard_error = {std::nan("")};
    return r;
  }

 private:
  double value_;
};

// A film without light is as dark as it will be; of another its record says that nothing tells its error.
TEST(ErrorThatIsUnknown, EndsARunWhichSaysSo) {
  for (const double value : {0., 1.}) {
    RunOfUnknownError run(value);
    const Rendering r = to_error(run, 0.1);
    EXPECT_LT(run.samples(), 4 * samples_in_the_dark);
    EXPECT_EQ(r.warnings.size(), value > 0 ? 1u : 0u);
  }
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

bool stays(std::initializer_list<Look> looks, double target) {
  return error_that_stays(std::vector<Look>(looks), target).has_value();
}

// Of 64 degrees of freedom e₂ may be e^½ times what steps alone would have left, and of 16 e times.
TEST(ErrorThatStays, IsSeenWhereItIsNoChance) {
  constexpr double by_steps = 0.1 / 2.828427;
  const auto is_seen = [](std::uint64_t samples, double error, double before, double degrees) {
    return stays({{1000, 0.1, before}, {samples, error, degrees}}, 0.01);
  };
  EXPECT_TRUE(is_seen(8000, 1.66 * by_steps, 64, 64));
  EXPECT_FALSE(is_seen(8000, 1.64 * by_steps, 64, 64));
  EXPECT_TRUE(is_seen(8000, 2.73 * by_steps, 16, 16));
  EXPECT_FALSE(is_seen(8000, 2.71 * by_steps, 16, 16));
  EXPECT_FALSE(is_seen(7999, 0.1, 64, 64)) << "too early";
  // √(1/8 + 1/72) is 0.3727, and e^(4 · 0.3727) 4.44.
  for (const auto& [before, now] : {std::pair(4., 36.), std::pair(36., 4.)}) {
    EXPECT_TRUE(is_seen(8000, 4.45 * by_steps, before, now));
    EXPECT_FALSE(is_seen(8000, 4.43 * by_steps, before, now));
  }
  EXPECT_FALSE(error_that_stays({}, 0.01));
  EXPECT_FALSE(stays({{1000, 0.1, 64}}, 0.01));
}

// Where the look eight times before cannot tell, one that is 64 times before may; one that is 63 times before is not asked.
TEST(ErrorThatStays, IsSeenByOneOfTheLooksBefore) {
  const Look now{64'000, 0.1, 8};  // by chance e^√2 = 4.1 times
  EXPECT_FALSE(stays({{8000, 0.1, 8}, now}, 0.01));
  EXPECT_TRUE(stays({{1000, 0.1, 8}, {8000, 0.1, 8}, now}, 0.01));
  EXPECT_FALSE(stays({{1010, 0.1, 8}, {8000, 0.1, 8}, now}, 0.01));
}

// 0.06 after eight times the samples are 0.0519 and what steps leave.
TEST(ErrorThatStays, MayBeLessThanTheTarget) {
  EXPECT_TRUE(stays({{1000, 0.1, 64}, {8000, 0.06, 64}}, 0.051));
  EXPECT_FALSE(stays({{1000, 0.1, 64}, {8000, 0.06, 64}}, 0.053));
}

}  // namespace
}  // namespace wander::test::error_that_stays_test

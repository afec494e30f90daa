// Chains in primary sample space leave their target invariant: from independent starts u_0,
// weighted with C*(u_0), E[C*(u_0) (h(u_n) - h(u_0))] = 0, and after one step with a h(v) + (1 - a)
// h(u_0).
//
// False alarms: 1e-7 per decision, over all functions.
#include <gtest/gtest.h>

#include "mlt/multiplexed_path.h"
#include "mlt/sample_splats.h"
#include "mutations/kelemen.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// h(u) in [0, 1]: the share of the light in each stripe of the film, by length; the largest share;
// how many splats there are.
FunctionValues values_of(const Flat& space, const SampleSplats& sample) {
  FunctionValues h{};
  sample.for_each_share([&](int vertices, int bin, double share) {
    const auto stripe = static_cast<std::size_t>(bin) * film_stripes /
                        static_cast<std::size_t>(space.scene().bins());
    const auto length = static_cast<std::size_t>(std::min(vertices, 5) - 2);
    h[length * film_stripes + stripe] += share;
    h[function_count - 2] = std::max(h[function_count - 2], share);
  });
  h[function_count - 1] = std::min(1.0, static_cast<double>(sample.splats.size()) / 16);
  return h;
}
FunctionValues values_of(const Flat& space, const MultiplexedPath<W>& sample) {
  return PathFunctions(space).values(sample.path);
}

// A chain that forgets to restore the numbers of a state when a step is rejected.
template <class Sampler, class SmallStep>
class ForgetfulChain {
 public:
  ForgetfulChain(const Sampler& sampler, const PrimaryKernel<SmallStep>& kernel)
      : kernel_(kernel),
        numbers_(sampler.coordinates()),
        current_(sampler.make_sample()),
        proposed_(sampler.make_sample()) {}

  const typename Sampler::Sample& current() const { return current_; }
  bool start(Sampler& sampler, const PrimaryNumbers& numbers) {
    numbers_ = numbers;
    PrimarySource source(sampler.layout(), [&](std::size_t k) { return numbers_[k]; });
    sampler.draw(source, current_);
    return true;
  }
  template <class Random, class Observer>
  void step(Sampler& sampler, Random& random, Observer&&) {
    const bool large = random.uniform() < kernel_.large_step;
    PrimarySource source(sampler.layout(), [&](std::size_t k) {
      const double u = large || !numbers_.holds(k) ? random.uniform()
                                                   : kernel_.small_step.move(numbers_[k], random).u;
      numbers_.set(k, u);
      return u;
    });
    sampler.draw(source, proposed_);
    if (random.uniform() * current_.total < proposed_.total) std::swap(current_, proposed_);
  }

 private:
  PrimaryKernel<SmallStep> kernel_;
  PrimaryNumbers numbers_;
  typename Sampler::Sample current_, proposed_;
};

// A start: fresh numbers, and what a sampler makes of them.
template <class Sampler>
double draw_start(Sampler& sampler, Rng& random, PrimaryNumbers& numbers,
                  typename Sampler::Sample& sample) {
  numbers.clear();
  PrimarySource source(sampler.layout(), [&](std::size_t k) {
    numbers.set(k, random.uniform());
    return numbers[k];
  });
  sampler.draw(source, sample);
  return sample.total;
}

struct Report {
  Decision one_step, many_steps;
  int lit = 0;  // starts with light
};
struct Options {
  std::uint64_t samples = 30'000;
  double large_step = 0.3;
  int steps = 15;
};

template <template <class, class> class Chain, class Sampler>
Report invariance(const Flat& space, Sampler sampler, const Options& options) {
  Rng random(1, Purpose::test, 70);
  PrimaryNumbers numbers(sampler.coordinates());
  typename Sampler::Sample sample = sampler.make_sample();
  Chain<Sampler, Kelemen> chain(sampler, {Kelemen{}, options.large_step});
  int lit = 0;
  double heaviest = 0;
  Deviations one_step, many_steps;
  for (std::uint64_t i = 0; i < options.samples; ++i) {
    random.start(i);
    const double weight = draw_start(sampler, random, numbers, sample);
    if (!(weight > 0)) continue;
    ++lit;
    const FunctionValues before = values_of(space, sample);
    heaviest = std::max(heaviest, weight);
    EXPECT_TRUE(chain.start(sampler, numbers));
    EXPECT_EQ(chain.current().total, weight);
    for (int n = 0; n < options.steps; ++n)
      chain.step(sampler, random, [&](const auto& step) {
        if (n == 0 && step.acceptance > 0)
          one_step.add(before, values_of(space, step.proposed), weight * step.acceptance);
      });
    many_steps.add(before, values_of(space, chain.current()), weight);
  }
  return {one_step.decide(heaviest, usual_false_alarm),
          many_steps.decide(heaviest, usual_false_alarm), lit};
}

description::Scene short_paths(description::Scene scene) {
  scene.max_vertices = 5;
  return scene;
}

struct Room {
  const char* name;
  description::Scene (*make)();
};
class PrimaryInvariance : public ::testing::TestWithParam<Room> {
 protected:
  FlatScene scene_ = build(short_paths(GetParam().make()));
  Flat space_{*scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Rooms, PrimaryInvariance,
                         ::testing::Values(Room{"Diffuse", diffuse_room},
                                           Room{"MirrorAndGlass", mirror_and_glass},
                                           Room{"Rough", rough_room}, Room{"Camera", pinhole_room}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(PrimaryInvariance, OfWholeSamples) {
  for (const double large : {0.0, 0.3}) {
    const Report report = invariance<PrimaryChain>(space_, SplatSampler<Flat>(space_),
                                                   {.samples = 8'000, .large_step = large});
    EXPECT_TRUE(passes(report.one_step));
    EXPECT_TRUE(passes(report.many_steps));
    EXPECT_GE(report.many_steps.comparisons, std::size_t{15});
  }
}

TEST_P(PrimaryInvariance, OfPathsOfEachLength) {
  int lengths = 0;
  for (int n = 2; n <= space_.max_vertices(); ++n) {
    const Report report =
        invariance<PrimaryChain>(space_, MultiplexedSampler<Flat>(space_, n), {.samples = 15'000});
    if (report.lit == 0) continue;  // the camera does not see a light
    ++lengths;
    EXPECT_TRUE(passes(report.one_step)) << n;
    EXPECT_TRUE(passes(report.many_steps)) << n;
    EXPECT_GE(report.many_steps.comparisons, std::size_t{15}) << n;
  }
  EXPECT_GE(lengths, 3);
}

TEST(PrimaryTwin, AChainThatDoesNotRestoreARejectedStateIsCaught) {
  const FlatScene scene = build(short_paths(diffuse_room()));
  const Flat space(*scene, Roulette::off);
  const Options options{.samples = 10'000, .large_step = 0.1};
  EXPECT_TRUE(
      rejects(invariance<ForgetfulChain>(space, SplatSampler<Flat>(space), options).many_steps));
}

// Where C* varies most the flaw shows best: it is that of a chain whose state is one path, too.
TEST(PrimaryTwin, AChainOfPathsThatDoesNotRestoreARejectedStateIsCaught) {
  const FlatScene scene = build(short_paths(rough_room()));
  const Flat space(*scene, Roulette::off);
  const Options options{.samples = 40'000};
  const MultiplexedSampler<Flat> sampler(space, 4);
  EXPECT_TRUE(passes(invariance<PrimaryChain>(space, sampler, options).many_steps));
  EXPECT_TRUE(rejects(invariance<ForgetfulChain>(space, sampler, options).many_steps));
}

}  // namespace
}  // namespace wander::test

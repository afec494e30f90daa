// Chains in primary sample space leave their target C* invariant: the identity of
// mlt/check/invariance.h with u for x.  A start u_0, uniform, has the weight
//   v = C*(u_0) c(u_0),  c(u) = min(1, B / C*(u)),  so that E[v h(u_0)] = ∫ c C* h du,
// and a chain that is reversible with respect to C* du has
//   E[v c(u_n) (h(u_n) - h(u_0))] = 0,  after one step to u_1 with probability a:
//   E[v a c(u_1) (h(u_1) - h(u_0))] = 0.
//
// False alarms: 1e-9 per decision, over all functions.
#include <gtest/gtest.h>

#include <optional>

#include "mlt/primary/multiplexed_path.h"
#include "mlt/primary/sample_splats.h"
#include "mutations/kelemen.h"
#include "tests/support/expect.h"
#include "tests/support/invariance.h"
#include "tests/support/space_box.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;

// h(u) in [0, 1]: the share of the light in each stripe of the film, by length; the largest share;
// how many splats there are.
template <class Space>
FunctionValues values_of(const Space& space, const SampleSplats<typename Space::Universe>& sample) {
  FunctionValues h{};
  sample.for_each_share([&](int vertices, int bin, double share, Tint<1>) {
    const auto stripe = static_cast<std::size_t>(bin) * film_stripes /
                        static_cast<std::size_t>(space.scene().bins());
    const auto length = static_cast<std::size_t>(std::min(vertices, 5) - 2);
    h[length * film_stripes + stripe] += share;
    h[function_count - 2] = std::max(h[function_count - 2], share);
  });
  h[function_count - 1] = std::min(1.0, static_cast<double>(sample.splats.size()) / 16);
  return h;
}
template <class Space>
FunctionValues values_of(const Space& space,
                         const MultiplexedPath<typename Space::Universe>& sample) {
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

// Fresh numbers with the weights v.  B is some times the average of those that carry light; of
// those below that average a roulette keeps some, with the average for a weight.
template <class Sampler>
class PrimaryStarts {
 public:
  using Sample = typename Sampler::Sample;

  explicit PrimaryStarts(Sampler& sampler)
      : sampler_(sampler), numbers_(sampler.coordinates()), sample_(sampler.make_sample()) {
    constexpr std::uint64_t pilot = 4000;
    std::uint64_t lit = 0;
    double sum = 0;
    for (std::uint64_t i = 0; i < pilot; ++i) {
      draw_sample(~i);
      sum += sample_.total;
      lit += sample_.total > 0 ? 1 : 0;
    }
    if (lit > 0) average_ = sum / static_cast<double>(lit);
  }
  bool found_light() const { return average_ > 0; }

  double draw(std::uint64_t i) {
    draw_sample(i);
    const double weight = sample_.total * clip(sample_);
    if (weight >= average_) return weight;
    return random_.uniform() * average_ < weight ? average_ : 0;
  }
  const PrimaryNumbers& numbers() const { return numbers_; }
  const Sample& sample() const { return sample_; }
  // c(u)
  double clip(const Sample& sample) const {
    return std::min(1.0, clipped_above * average_ / sample.total);
  }

 private:
  static constexpr double clipped_above = 4;

  void draw_sample(std::uint64_t i) {
    random_.start(i);
    numbers_.clear();
    PrimarySource source(sampler_.layout(), [&](std::size_t k) {
      numbers_.set(k, random_.uniform());
      return numbers_[k];
    });
    sampler_.draw(source, sample_);
  }

  Sampler& sampler_;
  Rng random_{1, Purpose::test, 70};
  PrimaryNumbers numbers_;
  Sample sample_;
  double average_ = 0;
};

struct Report {
  Decision one_step, many_steps;
};
struct Options {
  std::uint64_t samples = 30'000;
  double large_step = 0.3;
  int steps = 15;
};

// Nothing, if no start carries light.
template <template <class, class> class Chain, class Space, class Sampler>
std::optional<Report> invariance(const Space& space, Sampler sampler, const Options& options) {
  PrimaryStarts<Sampler> starts(sampler);
  if (!starts.found_light()) return {};
  Chain<Sampler, Kelemen> chain(sampler, {Kelemen{}, options.large_step});
  Rng random(1, Purpose::test, 71);
  double heaviest = 0;
  Deviations one_step, many_steps;
  for (std::uint64_t i = 0; i < options.samples; ++i) {
    const double weight = starts.draw(i);
    if (!(weight > 0)) continue;
    const FunctionValues before = values_of(space, starts.sample());
    heaviest = std::max(heaviest, weight);
    for (Deviations* deviations : {&one_step, &many_steps})
      deviations->add_level(before, weight * starts.clip(starts.sample()));
    EXPECT_TRUE(chain.start(sampler, starts.numbers()));
    EXPECT_EQ(chain.current().total, starts.sample().total);
    random.start(i);
    for (int n = 0; n < options.steps; ++n)
      chain.step(sampler, random, [&](const auto& step) {
        if (n == 0 && step.acceptance > 0)
          one_step.add(before, values_of(space, step.proposed),
                       weight * step.acceptance * starts.clip(step.proposed));
      });
    many_steps.add(before, values_of(space, chain.current()),
                   weight * starts.clip(chain.current()));
  }
  return Report{one_step.decide(heaviest, usual_false_alarm),
                many_steps.decide(heaviest, usual_false_alarm)};
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

template <class Space>
void expect_invariance_of_whole_samples(const Space& space) {
  for (const double large : {0.0, 0.3}) {
    const auto report = invariance<PrimaryChain>(space, SplatSampler<Space>(space),
                                                 {.samples = 12'000, .large_step = large});
    ASSERT_TRUE(report);
    EXPECT_TRUE(passes(report->one_step));
    EXPECT_TRUE(passes(report->many_steps));
    EXPECT_GE(report->many_steps.comparisons, std::size_t{15});
  }
}
template <class Space>
void expect_invariance_of_paths_of_each_length(const Space& space) {
  int lengths = 0;
  for (int n = 2; n <= space.max_vertices(); ++n) {
    const auto report =
        invariance<PrimaryChain>(space, MultiplexedSampler<Space>(space, n), {.samples = 30'000});
    if (!report) continue;  // the camera does not see a light
    ++lengths;
    EXPECT_TRUE(passes(report->one_step)) << n;
    EXPECT_TRUE(passes(report->many_steps)) << n;
    EXPECT_GE(report->many_steps.comparisons, std::size_t{15}) << n;
  }
  EXPECT_GE(lengths, 3);
}

TEST_P(PrimaryInvariance, OfWholeSamples) { expect_invariance_of_whole_samples(space_); }
TEST_P(PrimaryInvariance, OfPathsOfEachLength) {
  expect_invariance_of_paths_of_each_length(space_);
}

// The box is seen by its floor.
class PrimaryInvarianceInSpace : public ::testing::Test {
 protected:
  Scene<Spaceland> scene_{space_box()};
  Transport<Spaceland> space_{scene_, Roulette::off};
};
TEST_F(PrimaryInvarianceInSpace, OfWholeSamples) { expect_invariance_of_whole_samples(space_); }
TEST_F(PrimaryInvarianceInSpace, OfPathsOfEachLength) {
  expect_invariance_of_paths_of_each_length(space_);
}

TEST(PrimaryTwin, AChainThatDoesNotRestoreARejectedStateIsCaught) {
  const FlatScene scene = build(short_paths(diffuse_room()));
  const Flat space(*scene, Roulette::off);
  const Options options{.samples = 10'000, .large_step = 0.1};
  const auto report = invariance<ForgetfulChain>(space, SplatSampler<Flat>(space), options);
  EXPECT_TRUE(rejects(report.value().many_steps));
  EXPECT_GT(report->many_steps.comparisons, 0u);
}

// Where C* varies most the flaw shows best: it is that of a chain whose state is one path, too.
TEST(PrimaryTwin, AChainOfPathsThatDoesNotRestoreARejectedStateIsCaught) {
  const FlatScene scene = build(short_paths(rough_room()));
  const Flat space(*scene, Roulette::off);
  const Options options{.samples = 100'000};
  const MultiplexedSampler<Flat> sampler(space, 4);
  EXPECT_TRUE(passes(invariance<PrimaryChain>(space, sampler, options).value().many_steps));
  const auto report = invariance<ForgetfulChain>(space, sampler, options);
  EXPECT_TRUE(rejects(report.value().many_steps));
  EXPECT_GT(report->many_steps.comparisons, 0u);
}

}  // namespace
}  // namespace wander::test

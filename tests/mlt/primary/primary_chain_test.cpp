// Chains in primary sample space: their numbers stay uniform where the target is constant, and
// every number has its place.
//
// False alarms: 1e-9 per decision.
#include "mlt/primary/primary_chain.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "mlt/primary/multiplexed_path.h"
#include "mlt/primary/sample_splats.h"
#include "tests/support/expect.h"
#include "tests/support/path_equality.h"
#include "tests/support/primary_twins.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// ---- a constant target

// A sampler that finds the same light everywhere.  The first number decides whether one more is
// needed at its place, and in that place alone.
class EvenLight {
 public:
  using W = Flatland;
  struct Sample {
    double total = 0;
    Reason flaw = Reason::none;
  };
  static constexpr RandomPlace first{Subpath::light, 0}, last{Subpath::sensor, 1};
  static constexpr double often = 0.3;  // probability of one more

  const PrimaryLayout<W>& layout() const { return layout_; }
  std::size_t coordinates() const { return layout_.of_walks(); }
  Sample make_sample() const { return {}; }

  template <class Random>
  void draw(Random& random, Sample& sample) const {
    seek(random, first);
    if (random.uniform() < often) random.uniform();
    seek(random, last);
    random.uniform();
    sample.total = 1;
  }

 private:
  PrimaryLayout<W> layout_{3};
};

// Coordinates after small steps from independent uniform numbers.
struct Walked {
  std::vector<double> first, second, last;
  std::uint64_t chains = 40'000;
};
Walked walk(AtTheEnds rule) {
  EvenLight sampler;
  const std::size_t first = sampler.layout().first(EvenLight::first);
  const std::size_t last = sampler.layout().first(EvenLight::last);
  Rng random(1, Purpose::test, 60);
  Walked walked;
  for (std::uint64_t i = 0; i < walked.chains; ++i) {
    random.start(i);
    PrimaryChain<EvenLight, FarStep> chain(sampler, {FarStep{rule}, 0});
    for (int step = 0; step < 10; ++step)  // the first, from the dark, draws fresh numbers
      chain.step(sampler, random, [](const PrimaryStep<EvenLight::Sample>& s) {
        ASSERT_TRUE(s.accepted());
        ASSERT_EQ(s.acceptance, 1);
      });
    walked.first.push_back(chain.numbers()[first]);
    walked.last.push_back(chain.numbers()[last]);
    if (chain.numbers().holds(first + 1)) walked.second.push_back(chain.numbers()[first + 1]);
  }
  return walked;
}

// However little a splat carries, its share is its own.
TEST(SampleSplats, ShareAllThatTheSampleCarries) {
  SampleSplats<Flatland> sample(4);
  const std::vector<double> weights{1, 1e-9, 3, 0.01};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    Splat<Flatland> splat;
    splat.vertices = 2 + static_cast<int>(k);
    splat.bin = static_cast<int>(10 * k);
    splat.weight = weights[k];
    sample.add(splat, [&] { return Features{.vertices = splat.vertices}; });
  }
  std::size_t next = 0;
  sample.for_each_share([&](int vertices, int bin, double share, const auto&) {
    ASSERT_LT(next, weights.size());
    EXPECT_EQ(vertices, 2 + static_cast<int>(next));
    EXPECT_EQ(bin, 10 * static_cast<int>(next));
    EXPECT_DOUBLE_EQ(share, weights[next++] / sample.total);
  });
  EXPECT_EQ(next, weights.size());
  EXPECT_EQ(sample.brightest().vertices, 4);
  EXPECT_EQ(sample.total, 1 + 1e-9 + 3 + 0.01);
  EXPECT_EQ(sample.flaw, Reason::none);
  sample.clear();
  EXPECT_TRUE(sample.brightest().is_dark());
  EXPECT_EQ(sample.flaw, Reason::zero_contribution);
  EXPECT_TRUE(SampleSplats<Flatland>(4).brightest().is_dark());
}

TEST(PrimaryChain, KeepsTheNumbersOfAConstantTargetUniform) {
  const Walked walked = walk(AtTheEnds::wrap);
  for (const auto* values : {&walked.first, &walked.second, &walked.last})
    EXPECT_TRUE(passes(uniformity_test(*values, usual_false_alarm, 64)));
  EXPECT_TRUE(passes(
      binomial_test(walked.second.size(), walked.chains, EvenLight::often, usual_false_alarm)));
}

TEST(PrimaryChain, TwinsThatDoNotWrapAreCaught) {
  for (const AtTheEnds rule : {AtTheEnds::clamp, AtTheEnds::resample, AtTheEnds::redraw}) {
    const Walked walked = walk(rule);
    EXPECT_TRUE(rejects(uniformity_test(walked.first, usual_false_alarm, 64)));
    EXPECT_TRUE(rejects(uniformity_test(walked.last, usual_false_alarm, 64)));
  }
}

TEST(PrimaryChain, ALargeStepOwesNothingToTheStateAndASmallOneStaysNear) {
  EvenLight sampler;
  const std::size_t last = sampler.layout().first(EvenLight::last);
  Rng random(2, Purpose::test, 61);
  for (const double large : {0.0, 1.0}) {
    PrimaryChain<EvenLight, Kelemen> chain(sampler, {Kelemen{}, large});
    chain.step(sampler, random, [](const PrimaryStep<EvenLight::Sample>&) {});
    int near = 0;
    for (int i = 0; i < 1000; ++i) {
      const double before = chain.numbers()[last];
      chain.step(sampler, random, [&](const PrimaryStep<EvenLight::Sample>& step) {
        EXPECT_EQ(step.move, large > 0 ? PrimaryMove::large : PrimaryMove::small);
      });
      const double across = std::abs(chain.numbers()[last] - before);
      near += std::min(across, 1 - across) <= Kelemen{}.largest ? 1 : 0;
    }
    if (large > 0)
      EXPECT_LT(near, 100);  // 1/32 of a thousand
    else
      EXPECT_EQ(near, 1000);
  }
}

// ---- places

// Draws from a generator, and notes where.
struct Noted {
  Rng& random;
  std::map<std::pair<int, int>, int> count{};  // of numbers, by place
  std::pair<int, int> here{-1, 0};

  void seek(RandomPlace place) {
    here = {static_cast<int>(place.subpath), place.vertex};
    EXPECT_TRUE(count.emplace(here, 0).second) << "the same place twice";
  }
  double uniform() {
    ++count.at(here);
    return random.uniform();
  }
};

class Places : public ::testing::TestWithParam<int> {
 protected:
  FlatScene scene_ = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
  Flat space_{*scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Rooms, Places, ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST_P(Places, AreVisitedOnceAndNeverNeedMoreThanTheirStride) {
  for (const Roulette roulette : {Roulette::off, Roulette::by_albedo}) {
    const Flat space(*scene_, roulette);
    PathSampler<Flat> sampler(space, all_techniques, Heuristic::balance);
    const PrimaryLayout<W> layout(space.max_vertices());
    Rng random(3, Purpose::test, 62);
    for (std::uint64_t i = 0; i < 500; ++i) {
      random.start(i);
      Noted noted{random};
      sampler.sample(noted, [](const Path<W>&, int, double) {});
      std::set<std::size_t> coordinates;
      for (const auto& [place, count] : noted.count) {
        ASSERT_LE(count, static_cast<int>(PrimaryLayout<W>::stride));
        const auto first = layout.first({static_cast<Subpath>(place.first), place.second});
        ASSERT_GT(first, 0u);
        ASSERT_LE(first + PrimaryLayout<W>::stride, layout.of_samples());
        for (std::size_t k = 0; k < PrimaryLayout<W>::stride; ++k)
          ASSERT_TRUE(coordinates.insert(first + k).second);
      }
    }
  }
}

// A generator that knows no place gives the paths that it always gave.
TEST_P(Places, ChangeNoBitOfASample) {
  PathSampler<Flat> sampler(space_, all_techniques, Heuristic::balance);
  Rng plain(4, Purpose::test, 63), same(4, Purpose::test, 63);
  for (std::uint64_t i = 0; i < 200; ++i) {
    plain.start(i);
    same.start(i);
    std::vector<std::pair<Path<W>, double>> paths;
    sampler.sample(plain,
                   [&](const Path<W>& x, int, double weight) { paths.emplace_back(x, weight); });
    Noted noted{same};
    std::size_t next = 0;
    sampler.sample(noted, [&](const Path<W>& x, int, double weight) {
      ASSERT_LT(next, paths.size());
      EXPECT_EQ(paths[next].second, weight);
      EXPECT_TRUE(identical(paths[next++].first, x));
    });
    EXPECT_EQ(next, paths.size());
    EXPECT_EQ(plain.uniform(), same.uniform());
  }
}

// ---- the samplers

struct OneNumber {
  double u;
  double uniform() const { return u; }
  int choose(int count) const { return static_cast<int>(u * count); }
};

TEST_P(Places, TheFirstNumberChoosesATechniqueThatExists) {
  for (int n = 2; n <= space_.max_vertices(); ++n) {
    const MultiplexedSampler<Flat> sampler(space_, n);
    EXPECT_EQ(sampler.techniques(), space_.sensor_can_be_hit() ? n + 1 : n);
    MultiplexedPath<W> y = sampler.make_sample();
    for (const double u : {0.0, 0x1p-53, std::nextafter(1.0, 0.0)}) {
      OneNumber number{u};
      sampler.draw(number, y);
      EXPECT_EQ(y.technique, u < 0.5 ? 0 : sampler.techniques() - 1);
    }
  }
}

// C* has the mean b_n of its length: Σ over the techniques of a bidirectional sample.
TEST_P(Places, APathOfOneTechniqueIsWorthTheLightOfItsLengthOnAverage) {
  constexpr std::uint64_t samples = 20'000;
  const auto lengths = static_cast<std::size_t>(space_.max_vertices()) - 1;
  std::vector<Moments> whole(lengths), single(lengths);
  PathSampler<Flat> bidirectional(space_, all_techniques, Heuristic::balance);
  Rng random(5, Purpose::test, 64);
  for (std::uint64_t i = 0; i < samples; ++i) {
    random.start(i);
    std::vector<double> sums(lengths);
    bidirectional.sample(random, [&](const Path<W>& x, int, double weight) {
      sums[static_cast<std::size_t>(x.size()) - 2] += weight;
    });
    for (std::size_t k = 0; k < lengths; ++k) whole[k].add(sums[k]);
  }
  std::vector<Moments> forgotten(lengths);  // control: without n_k
  for (std::size_t k = 0; k < lengths; ++k) {
    const MultiplexedSampler<Flat> sampler(space_, static_cast<int>(k) + 2);
    MultiplexedPath<W> y = sampler.make_sample();
    for (std::uint64_t i = 0; i < samples; ++i) {
      random.start(samples + i * lengths + k);
      sampler.draw(random, y);
      single[k].add(y.total);
      forgotten[k].add(y.total / sampler.techniques());
    }
  }
  EXPECT_TRUE(passes(bins_welch_test(whole, single, usual_false_alarm)));
  EXPECT_TRUE(rejects(bins_welch_test(whole, forgotten, usual_false_alarm)));
}

// The step of such a chain is one in path space, with densities that give its acceptance.
TEST_P(Places, AStepOfOnePathIsAStepInPathSpace) {
  MultiplexedSampler<Flat> sampler(space_, 4);
  PrimaryChain<MultiplexedSampler<Flat>, Kelemen> chain(sampler, {Kelemen{}, 0.3});
  Rng random(6, Purpose::test, 65);
  int weighed = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    random.start(i);
    chain.step(sampler, random, [&](const PrimaryStep<MultiplexedPath<W>>& primary) {
      if (!(primary.current.total > 0)) return;
      const Step<W> step = path_step(primary);
      EXPECT_EQ(step.accepted(), primary.accepted());
      const Proposal* p = std::get_if<Proposal>(&step.outcome);
      ASSERT_EQ(p != nullptr, step.reason == Reason::none || step.reason == Reason::metropolis);
      if (!p) return;
      ++weighed;
      EXPECT_EQ(step.proposed.contribution, contribution(step.proposed));
      EXPECT_NEAR(
          step.acceptance,
          acceptance(step.current.contribution, p->forward, step.proposed.contribution, p->reverse),
          1e-12);
    });
  }
  EXPECT_GT(weighed, 500);
}

}  // namespace
}  // namespace wander::test

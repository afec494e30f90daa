// The light beyond a ratio, from what few samples and states say of it.
#include "mlt/run/light_by_ratio.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/rng.h"

namespace wander::test {
namespace {

double light_beyond(const LightByRatio& light, double ratio) {
  return light.mean([&](double l) { return l >= ratio ? 1.0 : 0.0; });
}

TEST(LightByRatio, OfStatesIsACountAndOfSamplesWhatTheyFound) {
  RatioHistogram states, found, none;
  for (int i = 0; i < 600; ++i) states.add(i % 3 == 0 ? 4 : 1);
  for (int i = 0; i < 900; ++i) found.add(i % 9 == 0 ? 4 : 1);  // 4 of 12
  found.add(4);
  for (const LightByRatio& light :
       {LightByRatio(none, {&states, 1}), LightByRatio(found.without_largest(), {})}) {
    EXPECT_NEAR(light.mean([](double) { return 1; }), 1, 1e-12);
    EXPECT_NEAR(light_beyond(light, 3.99), 1.0 / 3, 1e-12);
  }
}

TEST(LightByRatio, IsTheMoreOfBoth) {
  RatioHistogram states, found;
  for (int i = 0; i < 1000; ++i) {
    states.add(i < 600 ? 1 : 8);  // 0.4 beyond 8, nothing beyond 100
    found.add(i < 990 ? 1 : 99);  // half beyond 99
    if (i == 0) found.add(1e9);
  }
  const LightByRatio light(found.without_largest(), {&states, 1});
  EXPECT_NEAR(light_beyond(light, 98), 0.5, 1e-12);
  EXPECT_NEAR(light_beyond(light, 7.9), 0.5, 1e-12) << "what is beyond 98 is beyond 8 as well";
}

// 2000 draws of a power law are known at t₁, where a hundred of them lie beyond, to a tenth, and α so to
// 0.06: the tail a thousand times as far out to a half.  Six such errors are a factor of 8.
TEST(LightByRatio, GoesOnAsAPowerWhereItFellAsOne) {
  for (const double power : {0.6, 1.0}) {
    RatioHistogram states;
    Rng random(1, Purpose::test, 3);
    random.start(0);
    for (int i = 0; i < 2000; ++i) states.add(std::pow(1 - random.uniform(), -1 / power));
    const LightByRatio light({}, {&states, 1});
    const double far = std::pow(2e-4, -1 / power);  // where so much lies beyond
    EXPECT_NEAR(std::log2(light_beyond(light, far) / 2e-4), 0, 3) << power;
  }
}

TEST(LightByRatio, EndsWhereRatiosAreBounded) {
  RatioHistogram states;
  Rng random(1, Purpose::test, 4);
  random.start(0);
  for (int i = 0; i < 2000; ++i) states.add(2 + random.uniform());
  EXPECT_EQ(light_beyond(LightByRatio({}, {&states, 1}), 6), 0);
}

// Two chains of eight each have a tenth of their states far out; a ninth chain has never left a place
// yet farther out.
TEST(LightByRatio, IsNotWhatOneChainAloneSays) {
  std::vector<RatioHistogram> chains(9);
  for (std::size_t g = 0; g < 8; ++g)
    for (int i = 0; i < 100; ++i) chains[g].add(g < 2 && i < 10 ? 100 : 1);
  const std::span all(chains);
  EXPECT_NEAR(light_beyond(LightByRatio({}, all.first(8)), 99), 0.1 / 7, 1e-12) << "of one of two";
  for (int i = 0; i < 100; ++i) chains[8].add(1e6);
  EXPECT_EQ(light_beyond(LightByRatio({}, all), 0.9e6), 0);
  EXPECT_NEAR(light_beyond(LightByRatio({}, all), 99), 0.2 / 8, 1e-12) << "the other two";
  EXPECT_NEAR(light_beyond(LightByRatio({}, all), 0.9), 1, 1e-12);
}

// A tenth of the light has one large l: what S does on the way there is no tail.
TEST(LightByRatio, OfTwoPartsEndsWithTheSecond) {
  RatioHistogram states;
  for (int i = 0; i < 1000; ++i) states.add(i % 10 == 0 ? 1e5 : 1);
  const LightByRatio light({}, {&states, 1});
  EXPECT_EQ(light_beyond(light, 1.1e5), 0);
  EXPECT_NEAR(light_beyond(light, 0.9e5), 0.1, 1e-12);
}

// A power of two moves all ratios and nothing else.
TEST(LightByRatio, KnowsNoUnitOfLight) {
  RatioHistogram one, other;
  Rng random(1, Purpose::test, 5);
  random.start(0);
  for (int i = 0; i < 500; ++i) {
    const double l = 1 / (1 - random.uniform());
    one.add(l);
    other.add(0x1p-60 * l);
  }
  const auto g = [](double l) { return l / (1 + l); };
  EXPECT_EQ(LightByRatio(one, {}).mean(g),
            LightByRatio(other, {}).mean([&](double l) { return g(0x1p60 * l); }));
}

}  // namespace
}  // namespace wander::test

// Bridge sampling of b: on both sides draws whose law is known, so that b is known, too.
#include "mlt/run/bridge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mlt/run/bridge_sides.h"
#include "tests/support/expect.h"
#include "tests/support/statistics.h"

namespace wander::test {
namespace {

using namespace bridge_sides;

TEST(Bridge, SolvesTheEquationOfMengAndWong) {
  for (const double sigma : {0.1, 1.0, 2.5}) {
    const Sides sides = simulate({.sigma = sigma, .samples = 3200, .states = 3200}, 1);
    const BridgeFit fit = bridge(sides.data());
    ASSERT_TRUE(fit.failure.empty()) << fit.failure;
    EXPECT_NEAR(fit.b, fixed_point(sides, fit.balance), 5e-5 * fit.b) << "sigma " << sigma;
  }
}

// What a factor of two does to every l it does to b, bit for bit.
TEST(Bridge, OfAMultipleByAPowerOfTwoIsThatMultiple) {
  const BridgeFit fit = bridge(simulate({}, 2).data());
  for (const int exponent : {-100, -1, 3, 100}) {
    const BridgeFit scaled = bridge(simulate({.b = std::ldexp(1.0, exponent)}, 2).data());
    EXPECT_EQ(scaled.b, std::ldexp(fit.b, exponent));
    for (std::size_t g = 0; g < groups; ++g)
      EXPECT_EQ(scaled.without[g], std::ldexp(fit.without[g], exponent));
  }
}

// How far b moves without each group: as it would if the group had not been, but for another balance
// and other means of cells, which are of the second order.
TEST(Bridge, LeavesOutEachGroupAsIfItHadNotBeen) {
  const Sides sides = simulate({.samples = 3200, .states = 3200}, 4);
  const std::vector<BridgeGroup> all = sides.data();
  const BridgeFit fit = bridge(all);
  double together = 0, squares = 0, farthest = 0;
  for (std::size_t left_out = 0; left_out < groups; ++left_out) {
    std::vector<BridgeGroup> rest = all;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
    const double move = bridge(rest).b - fit.b, claimed = fit.without[left_out] - fit.b;
    together += move * claimed;
    squares += move * move;
    farthest = std::max(farthest, std::abs(claimed - move));
  }
  EXPECT_NEAR(together / squares, 1, 0.02);
  EXPECT_LT(farthest, 0.3 * std::sqrt(squares / groups));
}

// Four groups of which the first alone found paths, or the first alone has states.
TEST(Bridge, WithoutTheOnlyGroupOfASideIsNothingOrWhatSamplesSay) {
  RatioHistogram none, few, more;
  for (const double l : {1.0, 2.0, 4.0}) few.add(l);
  for (const double l : {2.0, 3.0, 5.0, 8.0}) more.add(l);
  const std::vector<BridgeGroup> found_by_one{{&few, 100, &more, 1},
                                              {&none, 100, &more, 1},
                                              {&none, 100, &none, 1},
                                              {&none, 100, &none, 1}};
  const BridgeFit one = bridge(found_by_one);
  ASSERT_TRUE(one.failure.empty()) << one.failure;
  EXPECT_EQ(one.without[0], 0);
  for (const std::size_t g : {1, 2, 3}) EXPECT_GT(one.without[g], 0.9 * one.b) << g;
  const std::vector<BridgeGroup> states_of_one{
      {&few, 100, &more, 1}, {&more, 100, &none, 1}, {&none, 100, &none, 1}, {&few, 100, &none, 1}};
  const BridgeFit other = bridge(states_of_one);
  ASSERT_TRUE(other.failure.empty()) << other.failure;
  EXPECT_DOUBLE_EQ(other.without[0], (18 + 7) / 300.);
  for (const std::size_t g : {1, 2, 3}) EXPECT_TRUE(std::isfinite(other.without[g])) << g;
  const std::vector<BridgeGroup> alone{{&few, 100, &more, 1}};
  EXPECT_FALSE(std::isfinite(bridge(alone).without[0]));
}

// Of a mean over all samples of one side, how many draws of its paths would know it as well as its groups do, and
// its square over the variance that they show.
struct KnownBy {
  double as_draws, as_events;
};
template <class Value>
KnownBy known(const std::vector<Side>& sides, double each, Value&& value) {
  const double all = each * groups;
  double mean = 0, square = 0, spread = 0;
  for (const Side& side : sides)
    for (const double l : side.values) {
      mean += value(l) / all;
      square += value(l) * value(l) / all;
    }
  for (const Side& side : sides) {
    double sum = 0;
    for (const double l : side.values) sum += value(l);
    spread += std::pow((sum - each * mean) / all, 2);
  }
  return {square / spread, mean * mean / spread};
}

// Two rounds: r of the sides at the b of the r before, all over the values one by one.  Paths of the seed pass
// have the spread of points of a process, states that of draws.
TEST(Bridge, WeighsItsSidesByWhatTheirGroupsShow) {
  const Model model{.sigma = 1.5, .samples = 6400, .states = 3200};
  const Sides sides = simulate(model, 7);
  double balance = 1, events = 0;
  for (int round = 0; round <= 2; ++round) {
    const double b = fixed_point(sides, balance);
    const auto h = [&](double l) { return l / (balance * l + b); };
    const auto m = [&](double l) { return 1 / (balance * l + b); };
    const double each = static_cast<double>(model.states) / groups;
    const KnownBy found = known(sides.found, sides.samples_of_group, h);
    const KnownBy states = known(sides.states, each, m);
    const double size = states.as_draws - states.as_events;  // of a variance about the mean
    events = found.as_events;
    if (round < 2) balance = size / found.as_draws;
  }
  const BridgeFit fit = bridge(sides.data());
  EXPECT_NEAR(fit.balance / balance, 1, 4e-3);  // cells have a width
  EXPECT_NEAR(fit.effective_samples / events, 1, 1e-3);
  EXPECT_LT(fit.effective_samples, model.samples);
}

// Where all paths that are found are alike, b is a share of the samples: of N, so many found, N p / (1 - p)
// events would tell as much, known from 32 groups to a quarter; false alarms 1e-9 within six of those.
TEST(Bridge, KnowsHowManyEventsWouldTellAsMuch) {
  const Model model{.found = 0.05, .sigma = 0.01};
  const BridgeFit fit = bridge(simulate(model, 6).data());
  const double expected = model.samples * model.found / (1 - model.found);
  EXPECT_GT(fit.effective_samples, expected / 2.5);
  EXPECT_LT(fit.effective_samples, expected * 2.5);
}

TEST(Bridge, SaysWhyThereIsNoConstant) {
  Sides dark = simulate({}, 5);
  for (auto& side : dark.found) side = {};
  const BridgeFit fit = bridge(dark.data());
  EXPECT_FALSE(fit.failure.empty());
  EXPECT_EQ(fit.b, 0);
}

// As a length of mmlt that no chain was left for.
TEST(Bridge, WithoutStatesIsWhatSamplesSay) {
  Sides still = simulate({}, 5);
  for (auto& side : still.states) side = {};
  const BridgeFit fit = bridge(still.data());
  ASSERT_TRUE(fit.failure.empty()) << fit.failure;
  EXPECT_DOUBLE_EQ(fit.b, still.direct);
  double total = 0, squares = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    double of_group = 0;
    for (const double l : still.found[g].values) of_group += l;
    EXPECT_NEAR(fit.without[g],
                (still.direct * groups - of_group / still.samples_of_group) / (groups - 1),
                1e-12 * fit.b);
    total += of_group;
    squares += std::pow(of_group - still.direct * still.samples_of_group, 2);
  }
  EXPECT_NEAR(fit.effective_samples, total * total / squares, 1e-6 * fit.effective_samples);
}

// One group tells no spread, and one state is enough for an estimate.
TEST(Bridge, OfOneGroupHasNoJackknife) {
  Side found, state;
  found.add(1);
  found.add(3);
  state.add(2);
  const std::vector<BridgeGroup> alone{{&found.ratios, 4, &state.ratios, 1}};
  const BridgeFit fit = bridge(alone);
  EXPECT_GT(fit.b, 0);
  ASSERT_EQ(fit.without.size(), 1u);
  EXPECT_TRUE(std::isnan(fit.without[0]));
}

// States that tell no spread, for there is one, or all are alike, are no more than so many draws.
TEST(Bridge, OfFewStatesLeansOnTheSamples) {
  const Sides sides = simulate({}, 3);
  for (const std::size_t states : {1, 2}) {
    std::vector<Side> few(groups);
    for (std::size_t g = 0; g < states; ++g) few[g].add(100);
    std::vector<BridgeGroup> data = sides.data();
    for (std::size_t g = 0; g < groups; ++g) data[g].states = &few[g].ratios;
    EXPECT_NEAR(bridge(data).b, sides.direct, 0.01 * sides.direct);
    Side found, state;
    for (int i = 0; i < 1000; ++i) found.add(1 + i % 3);
    for (std::size_t i = 0; i < states; ++i) state.add(100);
    const std::vector<BridgeGroup> alone{{&found.ratios, 2000, &state.ratios, 1}};
    EXPECT_NEAR(bridge(alone).b, 1, 0.1);
  }
}

// 200 seed passes of each kind: intervals cover, no bias, and no firefly dominates.
// False alarms: of the coverage 1e-9 by the binomial law of 0.95 ± 0.02, of the bias |z| < 6.1.
class BridgeStudy : public ::testing::TestWithParam<Model> {};
INSTANTIATE_TEST_SUITE_P(Tails, BridgeStudy,
                         ::testing::Values(Model{.found = 0.05, .sigma = 0.5},
                                           Model{.found = 0.3, .sigma = 1},
                                           Model{.found = 0.02, .sigma = 2}));

TEST_P(BridgeStudy, CoversTheTruth) {
  constexpr int runs = 200;
  const Study s = study(GetParam(), runs, bridged);
  EXPECT_GT(s.coverage, 0.82);
  EXPECT_LT(std::abs(s.bias), 6.1 * s.rmse / std::sqrt(runs));
  if (GetParam().sigma > 1.5) {
    EXPECT_LT(s.rmse, s.direct_rmse / 2) << "fireflies";
  }
}

// Twins: samples that find nothing are forgotten; a quarter of the error is claimed.  States of another law are none: the
// bridge does not lean on them (bridge_mixing_test.cpp).
TEST_P(BridgeStudy, TwinsAreCaught) {
  constexpr int runs = 40;
  const Study forgetful = study(GetParam(), runs, [](const Sides& sides) {
    std::vector<BridgeGroup> data = sides.data();
    for (BridgeGroup& group : data) group.samples = group.found->count();
    const BridgeFit fit = bridge(data);
    return std::pair(fit.b, jackknife_error(fit.without));
  });
  EXPECT_LT(forgetful.coverage, 0.5);
  const Study boastful = study(GetParam(), runs, [](const Sides& sides) {
    const auto [b, error] = bridged(sides);
    return std::pair(b, error / 4);
  });
  EXPECT_LT(boastful.coverage, 0.7);
}

}  // namespace
}  // namespace wander::test

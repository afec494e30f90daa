// The bridge where chains do not mix, so that their groups may be alike by chance; and where they do.
#include <gtest/gtest.h>

#include "tests/mlt/run/bridge_sides.h"

namespace wander::test {
namespace {

using namespace bridge_sides;

// Light of two kinds: little of it, `dim`, in many paths of small l, and the rest in few, 800 times as bright.  Chains
// stay in what they began in: every other run has none in the dim light, and all its states are alike.
struct Unmixed {
  double dim = 0.02, b = 1;
  int samples = 32'000, states = 16'000;  // of all groups
  bool one_comes_by = false;              // a chain has one dim state, and goes back

  static constexpr double dim_ratio = 0.05, bright_ratio = 40;
};

Sides simulate(const Unmixed& model, std::uint64_t seed) {
  Sides sides;
  Rng random(seed, Purpose::test, 71);
  sides.samples_of_group = model.samples / groups;
  const double of_dim = model.dim * model.b / Unmixed::dim_ratio,
               of_bright = (1 - model.dim) * model.b / Unmixed::bright_ratio;
  double total = 0;
  for (auto& side : sides.found)
    for (int i = 0; i < model.samples / groups; ++i) {
      const double u = random.uniform();
      if (u >= of_dim + of_bright) continue;
      side.add(u < of_dim ? Unmixed::dim_ratio : Unmixed::bright_ratio);
      total += side.values.back();
    }
  for (auto& side : sides.states) {
    const bool is_dim = random.uniform() < model.dim;
    for (int i = 0; i < model.states / groups; ++i)
      side.add(is_dim ? Unmixed::dim_ratio : Unmixed::bright_ratio);
  }
  if (model.one_comes_by) sides.states[0].add(Unmixed::dim_ratio);
  sides.direct = total / (sides.samples_of_group * groups);
  return sides;
}

// False alarms: of the coverage 1e-9 by the binomial law of 0.95 ± 0.02, of the bias |z| < 6.1.  The twin takes states for
// half as many draws of f / b as there are samples, whatever they tell: it is off by a third where all are alike.
TEST(BridgeMixing, OfChainsThatDoNotMixIsNoWorseThanTheSamples) {
  constexpr int runs = 200;
  for (const bool one_comes_by : {false, true}) {
    const Study s = study(Unmixed{.one_comes_by = one_comes_by}, runs, bridged);
    EXPECT_GT(s.coverage, 0.82) << one_comes_by;
    EXPECT_LT(std::abs(s.bias), 6.1 * s.rmse / std::sqrt(runs)) << one_comes_by;
    EXPECT_LT(s.rmse, 1.05 * s.direct_rmse) << one_comes_by;
  }
  const Study twin = study(
      Unmixed{}, runs, [](const Sides& sides) { return std::pair(fixed_point(sides, 0.5), 0.02); });
  EXPECT_LT(twin.coverage, 0.82);
  EXPECT_GT(twin.rmse, 1.5 * twin.direct_rmse);
}

// Light that all samples find, a 330th of all, and bright light that one of 400 finds.  A chain starts from the paths of its
// slice, in the bright light where there is any, and stays; it stands for as much as its slice has found.  So those in the dim
// light stand for little, and it is seldom that one of the others begins there.
struct Weighed {
  double dim = 0.003, rate = 1.2 / 500, b = 1;
  static constexpr int groups = 64, samples = 500, states = 300;  // of a group
};
struct WeighedSides {
  std::vector<RatioHistogram> found = std::vector<RatioHistogram>(Weighed::groups), states = found;
  std::vector<double> weights{};
  double direct = 0;

  std::vector<BridgeGroup> data() const {
    std::vector<BridgeGroup> data;
    for (std::size_t g = 0; g < Weighed::groups; ++g)
      data.push_back({&found[g], Weighed::samples, &states[g], weights[g]});
    return data;
  }
};
WeighedSides simulate(const Weighed& model, std::uint64_t seed) {
  WeighedSides sides;
  Rng random(seed, Purpose::test, 72);
  const double dim = model.dim * model.b, bright = (1 - model.dim) * model.b / model.rate;
  for (std::size_t g = 0; g < Weighed::groups; ++g) {
    double light = 0;
    for (int i = 0; i < Weighed::samples; ++i) {
      sides.found[g].add(dim);
      const bool is_bright = random.uniform() < model.rate;
      if (is_bright) sides.found[g].add(bright);
      light += dim + (is_bright ? bright : 0);
    }
    const double share_of_dim = Weighed::samples * dim / light;
    const bool starts_dim = random.uniform() < share_of_dim;
    sides.states[g].add(starts_dim ? dim : bright, Weighed::states);
    sides.weights.push_back(light / Weighed::samples / Weighed::states);
    sides.direct += light / Weighed::samples / Weighed::groups;
  }
  return sides;
}

// False alarms: 1e-9 as above; the errors are those of some forty events in groups of equal size, so intervals are those of
// many degrees of freedom.  Where no lack is seen b is a fifth too large.
TEST(BridgeMixing, OfGroupsThatWeighLittleDoesNotRestOnThem) {
  constexpr int runs = 200;
  const Study s = study(Weighed{}, runs, [](const WeighedSides& sides) {
    const BridgeFit fit = bridge(sides.data());
    return std::pair(fit.b, jackknife_error(fit.without));
  });
  EXPECT_GT(s.coverage, 0.82);
  EXPECT_LT(std::abs(s.bias), 6.1 * s.rmse / std::sqrt(runs));
  EXPECT_LT(s.rmse, 1.1 * s.direct_rmse);
}

// States that are of the law of samples: of what they lack of the light most is known.  Of 40 runs the root mean square is
// known to an eighth; the twin, which leans on both alike, has ten times that of the samples.
TEST(BridgeMixing, OfStatesOfAnotherLawLeansOnTheSamples) {
  constexpr int runs = 40;
  const Study s = study(Model{.found = 0.3, .sigma = 1}, runs, [](const Sides& sides) {
    std::vector<BridgeGroup> data = sides.data();
    for (BridgeGroup& group : data) group.states = group.found;
    return std::pair(bridge(data).b, 0.0);
  });
  EXPECT_LT(s.rmse, 1.5 * s.direct_rmse);
  const Study twin = study(Model{.found = 0.3, .sigma = 1}, runs, [](const Sides& sides) {
    Sides other = sides;
    other.states = sides.found;
    return std::pair(fixed_point(other, 1), 0.0);
  });
  EXPECT_GT(twin.rmse, 5 * twin.direct_rmse);
}

// What is unseen costs nothing where chains mix: r is what their groups show, but for one run of thousands for each
// octave.  False alarms below 1e-9 at a tenth of all runs.
TEST(BridgeMixing, OfChainsThatMixLeansOnThemAsBefore) {
  int leaning = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Sides sides = simulate(Model{}, seed);
    if (bridge(sides.data()).balance > 0.5) ++leaning;
  }
  EXPECT_GT(leaning, 30);
}

}  // namespace
}  // namespace wander::test

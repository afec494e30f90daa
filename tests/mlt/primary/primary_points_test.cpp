// Chains in primary sample space where all numbers are points of a grid, so that every step can be
// enumerated: a state is the numbers that the sampler asked for, and what it asks for depends on
// them.  The target C*(u_A) du_A stays, for whatever shares of large steps.  Nothing here is
// statistical.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>

#include "mlt/primary/primary_chain.h"
#include "mutations/kelemen.h"
#include "tests/support/enumeration.h"

namespace wander::test {
namespace {

constexpr int grid = 4;  // numbers are (k + 1/2) / grid

double point(int k) { return (k + 0.5) / grid; }

// Light that depends on one, two or three numbers: the first decides how many.  Of some there is
// none.
class GridLight {
 public:
  using W = Flatland;
  struct Sample {
    double total = 0;
    Reason flaw = Reason::none;
    std::array<int, 3> asked{-1, -1, -1};  // the state: u_A
  };
  static constexpr RandomPlace first{Subpath::light, 0}, last{Subpath::sensor, 1};

  const PrimaryLayout<W>& layout() const { return layout_; }
  std::size_t coordinates() const { return layout_.of_walks(); }
  Sample make_sample() const { return {}; }

  template <class Random>
  void draw(Random& random, Sample& sample) const {
    const auto ask = [&](std::size_t i) {
      sample.asked[i] = static_cast<int>(random.uniform() * grid);
    };
    sample.asked = {-1, -1, -1};
    seek(random, first);
    ask(0);
    if (sample.asked[0] == 1) ask(1);
    if (sample.asked[0] != 3) {
      seek(random, last);
      ask(2);
    }
    sample.total = light(sample.asked);
    sample.flaw = sample.total > 0 ? Reason::none : Reason::zero_contribution;
  }
  static double light(const std::array<int, 3>& asked) {
    if (asked[0] == 2 && asked[2] == 1) return 0;
    return 1.0 + 2 * asked[0] + 0.7 * asked[1] + 0.31 * (asked[2] + 1) * (asked[2] + 1);
  }

 private:
  PrimaryLayout<W> layout_{3};
};
using State = std::array<int, 3>;

// To a neighbour on the circle, or nowhere: symmetric.
struct NeighbourStep {
  static constexpr std::array<double, 3> pmf{0.25, 0.5, 0.25};
  template <class Random>
  Kelemen::Move move(double u, Random& random) const {
    const int by = random.neighbour(pmf) - 1;
    const int k = (static_cast<int>(u * grid) + by + grid) % grid;
    return {point(k), pmf[static_cast<std::size_t>(by + 1)]};
  }
};

// The source of one step's numbers: which move, then points of the grid, and, when all are drawn,
// u < a, which comes out negative (enumeration.h).
class GridRandom {
 public:
  GridRandom(Enumeration& choices, double large_step) : choices_(choices), large_(large_step) {}

  double uniform() {
    if (!began_) {
      began_ = true;
      const std::array<double, 2> pmf{large_, 1 - large_};
      return choices_.choose(pmf) == 0 ? 0 : 1;
    }
    return point(choices_.choose(grid));
  }
  int neighbour(std::span<const double> pmf) { return choices_.choose(pmf); }

 private:
  Enumeration& choices_;
  double large_;
  bool began_ = false;
};

std::vector<State> states() {
  std::vector<State> all;
  for (int a = 0; a < grid; ++a)
    for (int b = -1; b < grid; ++b)
      for (int c = -1; c < grid; ++c)
        if ((b >= 0) == (a == 1) && (c >= 0) == (a != 3) && GridLight::light({a, b, c}) > 0)
          all.push_back({a, b, c});
  return all;
}

PrimaryNumbers numbers_of(const GridLight& sampler, const State& state) {
  PrimaryNumbers numbers(sampler.coordinates());
  const std::size_t first = sampler.layout().first(GridLight::first);
  numbers.set(first, point(state[0]));
  if (state[1] >= 0) numbers.set(first + 1, point(state[1]));
  if (state[2] >= 0) numbers.set(sampler.layout().first(GridLight::last), point(state[2]));
  return numbers;
}

// π(u_A) ∝ C*(u_A) du_A: a number more is a factor 1/grid.
Eigen::VectorXd target(const std::vector<State>& all) {
  Eigen::VectorXd pi(static_cast<Eigen::Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto asked = std::ranges::count_if(all[i], [](int k) { return k >= 0; });
    pi[static_cast<Eigen::Index>(i)] =
        GridLight::light(all[i]) * std::pow(grid, -static_cast<double>(asked));
  }
  return pi / pi.sum();
}

template <class Accept>
Eigen::MatrixXd matrix(const std::vector<State>& all, double large_step, Accept&& accept) {
  GridLight sampler;
  const auto n = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index x = 0; x < n; ++x) {
    PrimaryChain<GridLight, NeighbourStep> chain(sampler, {NeighbourStep{}, large_step});
    Enumeration choices;
    do {
      EXPECT_TRUE(chain.start(sampler, numbers_of(sampler, all[static_cast<std::size_t>(x)])));
      GridRandom random(choices, large_step);
      double probability = 0, a = 0;
      State y{};
      chain.step(sampler, random, [&](const PrimaryStep<GridLight::Sample>& step) {
        a = accept(step);
        y = step.proposed.asked;
        probability = choices.probability();
      });
      if (a > 0) p(x, std::ranges::find(all, y) - all.begin()) += probability * a;
      p(x, x) += probability * (1 - a);
    } while (choices.advance());
  }
  return p;
}

TEST(PrimaryPoints, TheTargetStaysForWhateverShareOfLargeSteps) {
  const std::vector<State> all = states();
  for (const double large_step : {0.0, 0.3, 1.0}) {
    const Eigen::MatrixXd p =
        matrix(all, large_step, [](const auto& step) { return step.acceptance; });
    const Defects d = defects(target(all), p);
    std::printf("  large %.1f: |πP - π| %.1e, balance %.1e, rows %.1e, second eigenvalue %.3f\n",
                large_step, d.invariance, d.balance, d.rows, second_eigenvalue(target(all), p));
    EXPECT_LT(d.invariance, rounding);
    EXPECT_LT(d.balance, rounding);
    EXPECT_LT(d.rows, rounding);
    EXPECT_LT(second_eigenvalue(target(all), p), 1 - 1e-6);
  }
}

// Positive control: one that counts numbers which only one end has.
TEST(PrimaryPoints, ATwinThatPaysForNumbersThatComeAndGoIsCaught) {
  const std::vector<State> all = states();
  const Eigen::MatrixXd p = matrix(all, 0.3, [](const auto& step) {
    const auto count = [](const State& s) {
      return static_cast<double>(std::ranges::count_if(s, [](int k) { return k >= 0; }));
    };
    const double ratio = std::pow(grid, count(step.proposed.asked) - count(step.current.asked));
    return std::min(1.0, step.proposed.total / step.current.total * ratio);
  });
  const Defects d = defects(target(all), p);
  EXPECT_GT(d.invariance, 1e-4);
  EXPECT_GT(d.balance, 1e-4);
}

// The density that a step tells its observers is that of the numbers which were drawn for it.
TEST(PrimaryPoints, AStepTellsTheDensityOfItsMove) {
  GridLight sampler;
  const State from{1, 2, 0};
  PrimaryChain<GridLight, NeighbourStep> chain(sampler, {NeighbourStep{}, 0.3});
  Enumeration choices;
  do {
    ASSERT_TRUE(chain.start(sampler, numbers_of(sampler, from)));
    GridRandom random(choices, 0.3);
    chain.step(sampler, random, [&](const PrimaryStep<GridLight::Sample>& step) {
      double density = step.move == PrimaryMove::large ? 0.3 : 0.7;
      if (step.move == PrimaryMove::small)
        for (std::size_t i = 0; i < 3; ++i) {
          if (from[i] < 0 || step.proposed.asked[i] < 0) continue;
          const int by = (step.proposed.asked[i] - from[i] + grid + 1) % grid;
          density *= NeighbourStep::pmf[static_cast<std::size_t>(by)];
        }
      EXPECT_NEAR(step.density.value(), density, rounding);
    });
  } while (choices.advance());
}

}  // namespace
}  // namespace wander::test

// The acceptance probability a(r) = min(1, r) of Metropolis and Hastings, r = f(y) T(y→x) / (f(x)
// T(x→y)), and what a chain makes of numbers that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>

#include "core/rng.h"
#include "mlt/chain.h"
#include "mlt/mixture.h"
#include "tests/support/pointland.h"

namespace wander::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Moves to a given path and claims given densities.
struct Claiming {
  static constexpr std::string_view name = "claiming";
  PointPath target;
  Proposal claim;

  double applicability(const Graph&, const PointPath&) const { return 1; }
  template <class Random>
  Proposed propose(const Graph&, const PointPath&, PointPath& y, Random&) const {
    y = target;
    return claim;
  }
};

class Acceptance : public ::testing::Test {
 protected:
  Graph graph{proof_plans().front()};
  PointPath here = graph.path({0, 1}), there = graph.path({0, 2, 1});

  // Steps of a chain whose proposal has f(y) scaled by `factor`, and these densities.
  void expect_refused(double factor, Proposal claim, Reason reason) const {
    PointPath y = there;
    y[1].value *= factor;
    const Mixture<Claiming> kernel({1}, Claiming{y, claim});
    Chain<Graph, Mixture<Claiming>> chain(graph, kernel, here);
    Rng random(1, Purpose::test, 0);
    for (std::uint64_t step = 0; step < 20; ++step) {
      random.start(step);
      chain.step(random, [&](const Step<Pointland>& s) {
        EXPECT_EQ(name_of(s.reason), name_of(reason));
        EXPECT_EQ(s.acceptance, 0);
        EXPECT_FALSE(s.accepted());
        EXPECT_TRUE(std::holds_alternative<Failure>(s.outcome));
      });
      EXPECT_EQ(chain.current().size(), 2);
    }
  }
};

// The only random number of a chain whose mutation needs none.
struct OneNumber {
  double number;
  double uniform() const { return number; }
  int choose(std::span<const double>) const { return 0; }
};

// Counts what it is asked for: the numbers 0, 1/8, 2/8 …
struct CountedNumbers {
  int drawn = 0;
  double uniform() { return drawn++ / 8.0; }
  int choose(std::span<const double>) { return drawn++, 0; }
};

// Fails once; draws two numbers for each proposal.
struct FailingOnce {
  static constexpr std::string_view name = "failing once";
  PointPath proposed;
  mutable int proposals = 0;

  double applicability(const Graph&, const PointPath&) const { return 1; }
  template <class Random>
  Proposed propose(const Graph&, const PointPath&, PointPath& y, Random& random) const {
    for (int k = 0; k < 2; ++k) random.uniform();
    y = proposed;
    return proposals++ == 0 ? Proposed(Failure{Reason::occluded}) : Proposal{1, 1e9};
  }
};

// Draws two numbers of no use.
struct Drawing : Claiming {
  template <class Random>
  Proposed propose(const Graph& g, const PointPath& x, PointPath& y, Random& random) const {
    for (int k = 0; k < 2; ++k) random.uniform();
    return Claiming::propose(g, x, y, random);
  }
};

double accept(double r) { return acceptance(1, 1, r, 1); }

}  // namespace

TEST_F(Acceptance, OfARatioAndOfItsInverseHaveTheQuotientOfDetailedBalance) {
  for (double exponent = -300; exponent <= 300; exponent += 0.25) {
    const double r = std::pow(10, exponent);
    for (const double a : {accept(r), acceptance(1, 1, 1, r), acceptance(1 / r, 1, 1, 1)}) {
      EXPECT_GE(a, 0);
      EXPECT_LE(a, 1);
      EXPECT_NEAR(a / std::min(1.0, r), 1, 1e-15);
    }
    const double there = acceptance(3, 7, r, 0.5), back = acceptance(r, 0.5, 3, 7);
    EXPECT_NEAR(there / back / (r * 0.5 / 21), 1, 1e-15) << r;
  }
  EXPECT_EQ(accept(1), 1);
}

TEST_F(Acceptance, DependsOnNothingButTheRatioFarBeyondTheRangeOfDoubles) {
  for (const std::int64_t far : {-1'000'000, -5000, -1100, 1100, 5000, 1'000'000})
    for (const double r : {1e-300, 1e-3, 0.3, 0.999, 1.0, 7.0}) {
      const Scaled unit = Scaled::of(1, far);
      EXPECT_EQ(acceptance(unit, 1, Scaled(r) * unit, 1), accept(r));
      EXPECT_EQ(acceptance(1, unit, 1, Scaled(r) * unit), accept(r));
      EXPECT_EQ(acceptance(unit, 1, r, unit), accept(r));
      EXPECT_EQ(acceptance(1, unit, unit, r), accept(r));
    }
}

TEST_F(Acceptance, OfARatioBeyondTheRangeOfDoublesIsZeroOrOne) {
  for (const std::int64_t far : {1100, 4100, 1'000'000}) {
    EXPECT_EQ(acceptance(1, 1, Scaled::of(1, far), 1), 1);
    EXPECT_EQ(acceptance(1, 1, Scaled::of(1, -far), 1), 0);
    EXPECT_EQ(acceptance(1, Scaled::of(1, -far), 1, 1), 1);
    EXPECT_EQ(acceptance(1, Scaled::of(1, far), 1, 1), 0);
  }
  // Denormal ratios are still numbers.
  EXPECT_EQ(acceptance(1, 1, Scaled::of(1, -1070), 1), std::ldexp(1.0, -1070));
}

TEST_F(Acceptance, OfZeroOfNegativeNumbersAndOfNaNIsZero) {
  EXPECT_EQ(accept(0), 0);
  EXPECT_EQ(acceptance(1, 1, 1, 0), 0);
  EXPECT_EQ(accept(-1), 0);
  EXPECT_EQ(acceptance(1, 1, 1, -1), 0);
  EXPECT_EQ(acceptance(0, 1, 0, 1), 0) << "0/0";
  EXPECT_EQ(acceptance(infinity, 1, infinity, 1), 0) << "∞/∞";
  EXPECT_EQ(acceptance(infinity, 1, 1, 1), 0);
  EXPECT_EQ(acceptance(nan, 1, 1, 1), 0);
  EXPECT_EQ(acceptance(1, nan, 1, 1), 0);
  EXPECT_EQ(acceptance(1, 1, nan, 1), 0);
  EXPECT_EQ(acceptance(1, 1, 1, nan), 0);
}

TEST_F(Acceptance, AChainRefusesAProposalWhoseContributionOrDensityIsNoPositiveNumber) {
  expect_refused(0, {1, 1}, Reason::zero_contribution);
  for (const double bad : {nan, infinity, -infinity, -1.0}) {
    expect_refused(bad, {1, 1}, Reason::not_finite);
    expect_refused(1, {bad, 1}, Reason::not_finite);
    expect_refused(1, {1, bad}, Reason::not_finite);
    expect_refused(bad, {bad, bad}, Reason::not_finite);
  }
  expect_refused(1, {1, 0}, Reason::not_reversible);
  expect_refused(1, {0, 1}, Reason::not_finite);
}

// Positive control of the refusals: the same proposal with honest numbers is accepted.
TEST_F(Acceptance, AChainAcceptsAProposalWhoseRatioIsAboveOne) {
  const Mixture<Claiming> kernel({1}, Claiming{there, {1, 1e9}});
  Chain<Graph, Mixture<Claiming>> chain(graph, kernel, here);
  Rng random(1, Purpose::test, 0);
  chain.step(random, [](const Step<Pointland>& s) {
    EXPECT_TRUE(s.accepted());
    EXPECT_EQ(s.acceptance, 1);
  });
  EXPECT_EQ(chain.current().size(), 3);
}

TEST_F(Acceptance, AChainMovesExactlyWhenItsRandomNumberIsBelowTheAcceptance) {
  const double ratio = (contribution(there) / here.contribution).value(), a = 0.3;
  const Mixture<Claiming> kernel({1}, Claiming{there, {ratio, a}});
  for (const double u : {0.0, 0.1, 0.2999999, 0.3000001, 0.9, std::nextafter(1.0, 0.0)}) {
    Chain<Graph, Mixture<Claiming>> chain(graph, kernel, here);
    OneNumber random{u};
    chain.step(random, [&](const Step<Pointland>& s) {
      EXPECT_NEAR(s.acceptance, a, 1e-15);
      EXPECT_EQ(s.accepted(), u < a);
      EXPECT_EQ(s.current.size(), 2) << "observers see the step before the state moves";
      EXPECT_EQ(s.proposed.size(), 3);
    });
    EXPECT_EQ(chain.current().size(), u < a ? 3 : 2);
    EXPECT_EQ(chain.current().contribution, u < a ? contribution(there) : here.contribution);
  }
}

TEST_F(Acceptance, AFailedProposalIsAStepAndIsNotRepeated) {
  const Mixture<FailingOnce> kernel({1}, FailingOnce{there});
  Chain<Graph, Mixture<FailingOnce>> chain(graph, kernel, here);
  for (const Reason expected : {Reason::occluded, Reason::none}) {
    CountedNumbers random;
    chain.step(random, [&](const Step<Pointland>& s) { EXPECT_EQ(s.reason, expected); });
  }
}

// One choice of the mixture and two numbers of the mutation come before; the fourth is ⅜.
TEST_F(Acceptance, IsDecidedByANumberThatNothingElseHasUsed) {
  const double ratio = (contribution(there) / here.contribution).value();
  for (const double a : {0.37, 0.38}) {
    const Mixture<Drawing> kernel({1}, Drawing{{there, {ratio, a}}});
    Chain<Graph, Mixture<Drawing>> chain(graph, kernel, here);
    CountedNumbers random;
    chain.step(random, [&](const Step<Pointland>& s) { EXPECT_EQ(s.accepted(), a > 0.375); });
    EXPECT_EQ(random.drawn, 4);
  }
}

}  // namespace wander::test

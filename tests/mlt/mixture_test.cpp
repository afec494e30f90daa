// Mixtures in Pointland, where their transition matrix is known to rounding: they leave π ∝ f
// invariant when the selection depends on the state, and do not when its probabilities are missing
// from the ratio.
#include "mlt/mixture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "core/rng.h"
#include "mutations/bidirectional.h"
#include "mutations/primary_large.h"
#include "tests/support/enumeration.h"

namespace wander::test {

namespace {

// Draws the last vertex anew.  It cannot act on a path of two vertices, and is the more eager the
// longer the path and the higher its last node: its selection changes with every move.
struct OtherSensor {
  static constexpr std::string_view name = "other sensor";

  double applicability(const Graph&, const PointPath& x) const {
    const int n = x.size();
    return n == 2 ? 0 : n - 2 + 0.5 * x[n - 1].place.node;
  }
  template <class Random>
  Proposed propose(const Graph& graph, const PointPath& x, PointPath& y, Random& random) const {
    const int n = x.size();
    y.resize(n);
    y.copy(x, 0, n - 1, 0);
    graph.begin_sensor(y, n - 1, random);
    Reason flaw = join(graph, y, n - 1);
    if (flaw == Reason::none) flaw = evaluate(graph, y, n - 2, n - 1);
    if (flaw != Reason::none) return Failure{flaw};
    return Proposal{y[n - 1].from_sensor, x[n - 1].from_sensor};
  }
};

// Never applicable.
struct Idle {
  static constexpr std::string_view name = "idle";
  double applicability(const Graph&, const PointPath&) const { return 0; }
  template <class Random>
  Proposed propose(const Graph&, const PointPath& x, PointPath& y, Random&) const {
    y = x;
    return Proposal{1, 1};
  }
};

struct World {
  Graph graph;
  StateSpace states;

  explicit World(const std::string& name) : graph(proof_plan(name, 4)), states(graph) {}
};

template <class Kernel>
Defects measured(const World& world, const Kernel& kernel) {
  const Defects d =
      defects(world.states.pi(), transition_matrix(world.graph, world.states, kernel));
  std::printf("  |πP - π| %.1e, balance %.1e, rows %.1e\n", d.invariance, d.balance, d.rows);
  return d;
}

void expect_exact(const Defects& d) {
  EXPECT_LT(d.invariance, rounding);
  EXPECT_LT(d.balance, rounding);
  EXPECT_LT(d.rows, rounding);
}

}  // namespace

TEST(Mixture, SelectionProbabilitiesSumToOneOrAreAllZero) {
  const World world("two lights, two sensors");
  const Mixture<Bidirectional, OtherSensor, Idle> kernel({0.3, 2, 7}, {}, {}, {});
  const Mixture<OtherSensor, Idle> lame({1, 1}, {}, {});
  for (int x = 0; x < world.states.size(); ++x) {
    const auto s = kernel.probabilities(world.graph, world.states[x]);
    EXPECT_NEAR(s[0] + s[1] + s[2], 1, rounding);
    EXPECT_EQ(s[2], 0);
    const double other = 2 * OtherSensor{}.applicability(world.graph, world.states[x]);
    EXPECT_NEAR(s[1], other / (0.3 + other), rounding);
    const auto t = lame.probabilities(world.graph, world.states[x]);
    EXPECT_EQ(t[0], world.states[x].size() == 2 ? 0 : 1);
  }
}

TEST(Mixture, StaysInvariantWhenItsSelectionDependsOnTheState) {
  for (const char* name : {"two lights, two sensors", "mirror", "one-way"}) {
    const World world(name);
    const Mixture<Bidirectional, OtherSensor> two({1, 0.7}, {}, {});
    expect_exact(measured(world, two));
  }
}

TEST(Mixture, StaysInvariantWithThreeMutationsAndOneThatIsNeverApplicable) {
  const World world("two lights, two sensors");
  const PrimaryLarge large(world.graph.max_vertices());
  const Mixture<Idle, Bidirectional, OtherSensor, PrimaryLarge> kernel({5, 1, 0.4, 0.2}, {}, {}, {},
                                                                       large);
  expect_exact(measured(world, kernel));
}

TEST(Mixture, AWeightOfZeroIsAsGoodAsAbsence) {
  const World world("mirror");
  const Mixture<Bidirectional> alone({1}, {});
  const Mixture<OtherSensor, Bidirectional> kernel({0, 3}, {}, {});
  const auto p = transition_matrix(world.graph, world.states, alone);
  const auto q = transition_matrix(world.graph, world.states, kernel);
  EXPECT_LT((p - q).cwiseAbs().maxCoeff(), rounding);
}

// Positive control: the same mixture whose ratio lacks s_i(y) / s_i(x).
TEST(Mixture, BreaksTheInvarianceWhenItsSelectionIsMissingFromTheRatio) {
  const World world("two lights, two sensors");
  const Mixture<Bidirectional, OtherSensor> kernel({1, 0.7}, {}, {});
  const auto forgetful = [&](const Step<Pointland>& step) {
    const auto i = static_cast<std::size_t>(step.mutation);
    Proposal p = std::get<Proposal>(step.outcome);
    p.forward /= kernel.probabilities(world.graph, step.current)[i];
    p.reverse /= kernel.probabilities(world.graph, step.proposed)[i];
    return acceptance(step.current.contribution, p.forward, step.proposed.contribution, p.reverse);
  };
  const Defects d =
      defects(world.states.pi(), transition_matrix(world.graph, world.states, kernel, forgetful));
  std::printf("  selection missing: |πP - π| %.1e, balance %.1e\n", d.invariance, d.balance);
  EXPECT_GT(d.invariance, 1e-6);
  EXPECT_GT(d.balance, 1e-6);
}

// Three times as often of the one of thrice the weight, and never of one that was not asked for.  The draws of
// 3000 steps are 0.75 to within 6 standard errors but for 1e-9 of all seeds.
TEST(Mixture, RefusesWhereNothingIsApplicable) {
  using Kernel = Mixture<OtherSensor, Idle, Idle>;
  const World world("two lights, two sensors");
  ASSERT_EQ(world.states[0].size(), 2);
  const Kernel kernel({0, 3, 1}, {}, {}, {});
  Chain<Graph, Kernel> chain(world.graph, kernel, world.states[0]);
  Rng random(1, Purpose::test, 0);
  constexpr int steps = 3000;
  std::array<int, Kernel::count> told{};
  for (int i = 0; i < steps; ++i)
    chain.step(random, [&](const Step<Pointland>& step) {
      EXPECT_EQ(step.reason, Reason::not_applicable);
      EXPECT_EQ(step.acceptance, 0);
      ++told[static_cast<std::size_t>(step.mutation)];
    });
  EXPECT_EQ(told[0], 0);
  EXPECT_NEAR(told[1], 0.75 * steps, 6.1 * std::sqrt(0.75 * 0.25 * steps));
}

}  // namespace wander::test

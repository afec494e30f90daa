// Positive controls of the enumeration in Pointland: kernels with one fault each must break the
// invariance of π, and different but correct acceptance rules must not.
#include <cstdio>

#include "gtest/gtest.h"
#include "mlt/mixture.h"
#include "tests/support/enumeration.h"
#include "tests/support/pointland_moves.h"

namespace wander::test::pointland_twins_test {

namespace {

constexpr double least_defect = 1e-6, rounding = 1e-13;

// f(y) T(y→x) / (f(x) T(x→y)), the ratio that acceptance rules act on.
double ratio(const Step<Pointland>& step) {
  const Proposal& p = std::get<Proposal>(step.outcome);
  return ((step.proposed.contribution * p.reverse) / (step.current.contribution * p.forward))
      .value();
}

// A graph, its light paths and the bidirectional mutation, with one acceptance rule or another.
struct Rules {
  Graph graph{proof_plan("diffuse")};
  StateSpace states{graph};
  Mixture<Bidirectional> kernel{{1.0}, Bidirectional{}};

  template <class Accept>
  Defects operator()(Accept&& accept) const {
    return defects(states.pi(), transition_matrix(graph, states, kernel, accept));
  }
};

void print(const char* name, const Defects& d) {
  std::printf("  %-45s |πP - π| %8.1e   balance %8.1e\n", name, d.invariance, d.balance);
}

}  // namespace

TEST(PointlandTwins, EachForgottenFactorOfTheTransitionDensityBreaksTheInvariance) {
  for (const NamedTwin& twin : bidirectional_twins()) {
    const Graph graph(proof_plan(twin.graph));
    const StateSpace states(graph);
    const Mixture<BidirectionalTwin> kernel({1.0}, BidirectionalTwin{twin.spoil});
    const Defects d = defects(states.pi(), transition_matrix(graph, states, kernel));
    print((twin.name + " (" + twin.graph + ")").c_str(), d);
    EXPECT_GT(d.invariance, least_defect) << twin.name;
    EXPECT_GT(d.balance, least_defect) << twin.name;
    EXPECT_LT(d.rows, rounding) << twin.name;
  }
}

TEST(PointlandTwins, ATwinThatChangesNothingKeepsTheInvariance) {
  const Graph graph(proof_plan("mirror"));
  const StateSpace states(graph);
  const auto spoil_nothing = [](const Transition& t, Proposal& p) {
    const auto splits = [&](const PointPath& z) {
      return double(Bidirectional::split_count(t.graph, z, t.move.kept, t.move.added));
    };
    p.forward *= splits(t.y) / splits(t.x);
  };
  const Mixture<BidirectionalTwin> kernel({1.0}, BidirectionalTwin{spoil_nothing});
  EXPECT_LT(defects(states.pi(), transition_matrix(graph, states, kernel)).invariance, rounding);
}

TEST(PointlandTwins, WrongAcceptanceRulesBreakTheInvariance) {
  const Rules rules;
  const Defects threshold =
      rules([](const auto& step) { return step.acceptance < 0.5 ? 0 : step.acceptance; });
  const Defects root = rules([](const auto& step) { return std::sqrt(step.acceptance); });
  const Defects always = rules([](const auto&) { return 1.0; });
  print("threshold acceptance", threshold);
  print("square root of the ratio", root);
  print("everything accepted", always);
  for (const Defects& d : {threshold, root, always}) {
    EXPECT_GT(d.invariance, least_defect);
    EXPECT_GT(d.balance, least_defect);
  }
}

// Correct rules that are not Metropolis's, so the engine does not just compare with one answer.
TEST(PointlandTwins, OtherCorrectAcceptanceRulesKeepTheInvariance) {
  const Rules rules;
  const Defects barker = rules([](const auto& step) { return ratio(step) / (1 + ratio(step)); });
  const Defects split = rules([](const auto& step) {
    const Proposal& p = std::get<Proposal>(step.outcome);
    const Scaled f = step.proposed.contribution / step.current.contribution;
    return std::min(1.0, f.value()) * std::min(1.0, (p.reverse / p.forward).value());
  });
  print("Barker", barker);
  print("min(1, f'/f) min(1, T'/T)", split);
  for (const Defects& d : {barker, split}) {
    EXPECT_LT(d.invariance, rounding);
    EXPECT_LT(d.balance, rounding);
  }
}

TEST(PointlandTwins, RetryingFailedProposalsBreaksTheInvariance) {
  const Rules rules;
  Eigen::MatrixXd p = transition_matrix(rules.graph, rules.states, rules.kernel);
  Eigen::VectorXd succeeds = Eigen::VectorXd::Zero(rules.states.size());
  for_each_step(rules.graph, rules.states, rules.kernel,
                [&](int x, const Step<Pointland>& step, const Enumeration& choices) {
                  if (std::holds_alternative<Proposal>(step.outcome))
                    succeeds[x] += choices.probability();
                });
  for (int x = 0; x < rules.states.size(); ++x) {
    p(x, x) -= 1 - succeeds[x];
    p.row(x) /= succeeds[x];
  }
  const Defects d = defects(rules.states.pi(), p);
  print("failed proposals retried", d);
  EXPECT_LT(d.rows, rounding);
  EXPECT_GT(d.invariance, least_defect);
}

}  // namespace wander::test::pointland_twins_test

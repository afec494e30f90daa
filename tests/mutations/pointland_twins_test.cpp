// Positive controls of the enumeration in Pointland: kernels with one fault each must break the
// invariance of π, and different but correct acceptance rules must not.
#include <cstdio>

#include "gtest/gtest.h"
#include "mlt/mixture.h"
#include "tests/mutations/pointland_moves.h"
#include "tests/support/enumeration.h"

namespace wander::test {

namespace {

using B = Bidirectional;
constexpr double least_defect = 1e-6, rounding = 1e-13;

double split_count(const Transition& t, const PointPath& z, int added) {
  return B::split_count(t.graph, z, t.move.kept, added);
}

// The part of added_density that belongs to one split of z, the nearest possible to that of the
// move.
Scaled one_split_density(const Transition& t, const PointPath& z, int added) {
  const B::SplitRange splits = B::split_range(t.graph, z, t.move.kept, added);
  const int light = t.move.kept.light,
            s = light + std::min(splits.first + t.move.split, splits.last);
  if (!can_sample(t.graph, z, s, all_techniques)) return 0;
  Scaled p = 1.0 / splits.count();
  for (int i = light; i < light + added; ++i) p *= i < s ? z[i].from_light : z[i].from_sensor;
  return p;
}

// Of a path whose light was chosen uniformly among two.
Scaled with_uniform_light(const Transition& t, PointPath z, int added) {
  z[0].from_light = 0.5;
  return B::added_density(t.graph, z, t.move.kept, added);
}

void forget_deletion(const Transition& t, Proposal& p) {
  p.forward /= B::deletion_pmf(t.x.size())[t.move.deleted];
  p.reverse /= B::deletion_pmf(t.y.size())[t.move.added];
}
void forget_placement(const Transition& t, Proposal& p) {
  p.forward /= B::placement_probability(t.x.size(), t.move.deleted, t.move.kept);
  p.reverse /= B::placement_probability(t.y.size(), t.move.added, t.move.kept);
}
void forget_addition(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  p.forward /= B::add_probability(kept, deleted, added, t.graph.max_vertices());
  p.reverse /= B::add_probability(kept, added, deleted, t.graph.max_vertices());
}
void delete_the_same_on_the_way_back(const Transition& t, Proposal& p) {
  const auto pmf = B::deletion_pmf(t.y.size());
  p.reverse *= pmf[std::min(t.move.deleted, t.y.size())] / pmf[t.move.added];
}
void add_around_the_same_number_on_the_way_back(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  const int longest = t.graph.max_vertices();
  p.reverse *= B::add_probability(kept, deleted, deleted, longest) /
               B::add_probability(kept, added, deleted, longest);
}
void take_one_split(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  p.forward *= one_split_density(t, t.y, added) / B::added_density(t.graph, t.y, kept, added);
  p.reverse *= one_split_density(t, t.x, deleted) / B::added_density(t.graph, t.x, kept, deleted);
}
void forget_split_probability(const Transition& t, Proposal& p) {
  p.forward *= split_count(t, t.y, t.move.added);
  p.reverse *= split_count(t, t.x, t.move.deleted);
}
void count_specular_splits(const Transition& t, Proposal& p) {
  p.forward *= split_count(t, t.y, t.move.added) / (t.move.added + 1);
  p.reverse *= split_count(t, t.x, t.move.deleted) / (t.move.deleted + 1);
}
void take_lights_for_equal(const Transition& t, Proposal& p) {
  const auto& [kept, deleted, added, split] = t.move;
  if (kept.light > 0) return;
  p.forward *= with_uniform_light(t, t.y, added) / B::added_density(t.graph, t.y, kept, added);
  p.reverse *= with_uniform_light(t, t.x, deleted) / B::added_density(t.graph, t.x, kept, deleted);
}
void swap_densities(const Transition&, Proposal& p) { std::swap(p.forward, p.reverse); }
void forget_densities(const Transition&, Proposal& p) { p = {1, 1}; }

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

std::vector<NamedTwin> bidirectional_twins() {
  return {{"deletion pmf ignored", "diffuse", forget_deletion},
          {"placement pmf ignored", "diffuse", forget_placement},
          {"addition pmf ignored", "diffuse", forget_addition},
          {"way back deletes as many", "diffuse", delete_the_same_on_the_way_back},
          {"way back adds around the same number", "diffuse",
           add_around_the_same_number_on_the_way_back},
          {"used split instead of the sum", "diffuse", take_one_split},
          {"split probability missing", "diffuse", forget_split_probability},
          {"splits at a mirror counted", "glass", count_specular_splits},
          {"splits at a pinhole counted", "pinhole", count_specular_splits},
          {"lights taken for equal", "glass", take_lights_for_equal},
          {"ratio inverted", "diffuse", swap_densities},
          {"symmetric Metropolis", "diffuse", forget_densities}};
}

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
    p.forward *= split_count(t, t.y, t.move.added) / split_count(t, t.x, t.move.added);
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

}  // namespace wander::test

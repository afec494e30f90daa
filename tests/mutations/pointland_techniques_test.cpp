// In Pointland the estimators and the large step are sums over finitely many outcomes as well: what
// a bidirectional sample is worth on average is known for each path, and so is the density of a
// large step.
#include <gtest/gtest.h>

#include <cstdio>

#include "core/path_sampler.h"
#include "mlt/mixture.h"
#include "mutations/primary_large.h"
#include "tests/support/enumeration.h"

namespace wander::test {

namespace {

// The graphs where no density is zero unless f is: there every technique that can sample a path
// does.
std::vector<GraphPlan> plans_of(int max_vertices) {
  std::vector<GraphPlan> plans;
  for (const GraphPlan& plan : proof_plans())
    if (plan.never_walked.empty()) plans.push_back(proof_plan(plan.name, max_vertices));
  return plans;
}

// max |E[Σ w f/p over the samples of x] / f(x) - 1|, over the light paths.
double sampler_defect(const GraphPlan& plan, TechniqueSet set, Heuristic heuristic) {
  const Graph graph(plan);
  const StateSpace states(graph);
  PathSampler<Graph> sampler(graph, set, heuristic);
  std::vector<double> mean(static_cast<std::size_t>(states.size()));
  Enumeration choices;
  do {
    std::vector<std::pair<int, double>> found;
    sampler.sample(choices, [&](const PointPath& x, int, double weight) {
      found.emplace_back(states.index_of(x), weight);
    });
    for (const auto& [x, weight] : found)
      mean[static_cast<std::size_t>(x)] += choices.probability() * weight;
  } while (choices.advance());
  double worst = 0;
  for (int x = 0; x < states.size(); ++x)
    worst = std::max(worst, std::abs(mean[static_cast<std::size_t>(x)] / states.target(x) - 1));
  return worst;
}

// max |Σ_choices Pr(x→y) / T(x→y) - 1| over all transitions of the large step.
double large_step_defect(const Graph& graph, const StateSpace& states,
                         const Mixture<PrimaryLarge>& kernel) {
  Eigen::MatrixXd sampled = Eigen::MatrixXd::Zero(states.size(), states.size());
  Eigen::MatrixXd claimed = sampled;
  for_each_step(graph, states, kernel,
                [&](int x, const Step<Pointland>& step, const Enumeration& choices) {
                  const Proposal* p = std::get_if<Proposal>(&step.outcome);
                  if (!p) return;
                  const int y = states.index_of(step.proposed);
                  sampled(x, y) += choices.probability();
                  claimed(x, y) = p->forward.value();
                });
  EXPECT_GT(sampled.minCoeff(), 0) << "a large step reaches every path";
  return (sampled.array() / claimed.array() - 1).abs().maxCoeff();
}

}  // namespace

TEST(PointlandTechniques, ABidirectionalSampleIsWorthTheContributionOfEachPathOnAverage) {
  for (const GraphPlan& plan : plans_of(3))
    for (const Heuristic heuristic : {Heuristic::balance, Heuristic::power}) {
      const double defect = sampler_defect(plan, all_techniques, heuristic);
      std::printf("  %-25s %.1e\n", plan.name.c_str(), defect);
      EXPECT_LT(defect, rounding) << plan.name;
    }
}

TEST(PointlandTechniques, ABidirectionalSampleOfLongerPathsIsWorthTheirContributionOnAverage) {
  for (const char* name : {"diffuse", "mirror", "glass", "pinhole"})
    EXPECT_LT(sampler_defect(proof_plan(name, 4), all_techniques, Heuristic::balance), rounding);
}

// Positive control: without the technique that hits the light, no path by a mirror is found.
TEST(PointlandTechniques, LeavingOutATechniqueThatASpecularPathNeedsIsNoticed) {
  const TechniqueSet never_by_chance{.fewest_light = 1};
  EXPECT_GT(sampler_defect(proof_plan("pinhole", 3), never_by_chance, Heuristic::balance), 0.5);
}

TEST(PointlandTechniques, TheLargeStepKeepsTheTargetAndHasTheDensityThatItClaims) {
  for (const GraphPlan& plan : plans_of(4)) {
    const Graph graph(plan);
    const StateSpace states(graph);
    const Mixture<PrimaryLarge> kernel({1.0}, PrimaryLarge(graph.max_vertices()));
    const double density = large_step_defect(graph, states, kernel);
    const Defects d = defects(states.pi(), transition_matrix(graph, states, kernel));
    std::printf("  %-25s density %.1e   |πP - π| %.1e\n", plan.name.c_str(), density, d.invariance);
    EXPECT_LT(density, rounding) << plan.name;
    EXPECT_LT(d.invariance, rounding) << plan.name;
    EXPECT_LT(d.balance, rounding) << plan.name;
  }
}

// What a seed pass found that saw two lengths, and of them the techniques that hit the light and
// one more.  Where nothing was found the large step must go all the same.
SeedTally seeds_found(int max_vertices) {
  SeedTally seeds(max_vertices);
  seeds.samples = 10;
  seeds.total += 4;
  seeds.sum[0] += 1, seeds.sum[1] += 3;
  seeds.techniques.row(2)[0] = 1;
  seeds.techniques.row(3)[0] = 1, seeds.techniques.row(3)[1] = 2;
  return seeds;
}

TEST(PointlandTechniques, ALargeStepThatHasLearntKeepsTheTargetAndReachesEveryPath) {
  for (const GraphPlan& plan : plans_of(4)) {
    const Graph graph(plan);
    const StateSpace states(graph);
    Mixture<PrimaryLarge> kernel({1.0}, PrimaryLarge(graph.max_vertices()));
    kernel.learn(seeds_found(graph.max_vertices()));
    EXPECT_LT(large_step_defect(graph, states, kernel), rounding) << plan.name;
    const Defects d = defects(states.pi(), transition_matrix(graph, states, kernel));
    EXPECT_LT(d.invariance, rounding) << plan.name;
    EXPECT_LT(d.balance, rounding) << plan.name;
  }
}

}  // namespace wander::test

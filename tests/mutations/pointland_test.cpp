// The bidirectional mutation in Pointland, where its whole transition matrix is known to rounding:
// it leaves π ∝ f invariant, proposes with the densities that it claims, and measures what it
// proposes as if nothing had been kept.  Nothing here is statistical.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <unordered_map>

#include "mlt/mixture.h"
#include "tests/support/enumeration.h"
#include "tests/support/pointland_moves.h"

namespace wander::test {

namespace {

using BidirectionalKernel = Mixture<Bidirectional>;

class Pointlands : public ::testing::TestWithParam<GraphPlan> {
 protected:
  Graph graph{GetParam()};
  StateSpace states{graph};

  void SetUp() override { ASSERT_GE(states.size(), 10) << "too few light paths to prove anything"; }
};

std::string name_of(const ::testing::TestParamInfo<GraphPlan>& info) {
  std::string name;
  for (const char c : info.param.name)
    if (std::isalpha(static_cast<unsigned char>(c))) name += c;
  return name;
}

double relative_difference(Scaled a, Scaled b) {
  if (a == b) return 0;
  return std::abs((a / b).value() - 1);
}

// The larger defect; one that is no number is the largest.
double worse(double a, double b) { return std::isnan(a) || b <= a ? a : b; }

// ---- T-QSAMP: sampled against claimed densities

struct Key {
  int x, light, sensor, added, y;
  bool operator==(const Key&) const = default;
};
struct KeyHash {
  std::size_t operator()(const Key& k) const {
    std::size_t h = 0;
    for (const int part : {k.x, k.light, k.sensor, k.added, k.y})
      h = h * 1021 + static_cast<std::size_t>(part);
    return h;
  }
};
// What is known of one transition with its label: how often it is sampled, and what is claimed.
struct Claim {
  double sampled = 0;
  Scaled forward, reverse;
  int deleted = 0;
};
using Claims = std::unordered_map<Key, Claim, KeyHash>;

struct ClaimDefects {
  double forward = 0;  // of Σ_choices Pr against Proposal::forward, relative
  double reverse = 0;  // of Proposal::reverse against the way back's forward, relative
  int one_way = 0;     // transitions with a reverse density that have no way back, or the contrary
  std::size_t transitions = 0;
};

template <class Kernel>
Claims claims_of(const Graph& graph, const StateSpace& states, const Kernel& kernel) {
  Claims claims;
  for_each_step(
      graph, states, kernel, [&](int x, const Step<Pointland>& step, const Enumeration& choices) {
        const Proposal* p = std::get_if<Proposal>(&step.outcome);
        if (!p) return;
        // The first choice is the mixture's.
        const Move move = move_of(choices.choices().subspan(1), step.current, step.proposed);
        const int y = states.index_of(step.proposed);
        Claim& claim = claims[{x, move.kept.light, move.kept.sensor, move.added, y}];
        // Two densities for one transition are infinitely wrong.
        if (claim.sampled > 0 && claim.forward != p->forward)
          claim.sampled = std::numeric_limits<double>::infinity();
        claim.sampled += choices.probability();
        claim.forward = p->forward;
        claim.reverse = p->reverse;
        claim.deleted = move.deleted;
      });
  return claims;
}

ClaimDefects defects_of(const Claims& claims) {
  ClaimDefects worst{.transitions = claims.size()};
  for (const auto& [key, claim] : claims) {
    worst.forward = worse(worst.forward, relative_difference(claim.sampled, claim.forward));
    const auto back = claims.find({key.y, key.light, key.sensor, claim.deleted, key.x});
    if (back == claims.end() || claim.reverse.is_zero()) {
      ++worst.one_way;
      continue;
    }
    worst.reverse = worse(worst.reverse, relative_difference(claim.reverse, back->second.forward));
  }
  return worst;
}

// ---- T-VERIFY: a proposal against the same path measured anew

bool same_vertices(const PointPath& x, const PointPath& y) {
  if (x.size() != y.size()) return false;
  for (int i = 0; i < x.size(); ++i) {
    const Vertex<Pointland>&a = x[i], &b = y[i];
    if (a.place.node != b.place.node || a.event != b.event || a.value != b.value) return false;
    if (a.from_light != b.from_light || a.from_sensor != b.from_sensor) return false;
    if (i + 1 < x.size() && a.geometry != b.geometry) return false;
  }
  return true;
}

// A path that spoils whatever is taken from it.
PointPath poisoned(int max_vertices) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  PointPath y(max_vertices);
  y.resize(max_vertices);
  for (int i = 0; i < max_vertices; ++i) {
    y[i].geometry = y[i].value = y[i].from_light = y[i].from_sensor = nan;
    y[i].event = Event::transmission;
  }
  return y;
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Graphs, Pointlands, ::testing::ValuesIn(proof_plans()), name_of);

// Checks the engine: f and the densities of the vocabulary against the tables of the graph.
TEST_P(Pointlands, LightPathsAreMeasuredAsTheTablesSay) {
  for (int x = 0; x < states.size(); ++x) {
    EXPECT_NEAR(contribution(states[x]).value() / states.target(x), 1, rounding);
    Scaled intensity;
    for (int s = 0; s <= states[x].size(); ++s)
      if (can_sample(graph, states[x], s, all_techniques))
        intensity += technique_density(states[x], s);
    EXPECT_TRUE(intensity.is_positive()) << "no technique samples path " << x;
    EXPECT_LE(intensity.value(), states[x].size() + 1);
  }
}

TEST_P(Pointlands, TheBidirectionalMutationKeepsTheTargetAndReachesEveryPath) {
  const BidirectionalKernel kernel({1.0}, Bidirectional{});
  const Eigen::MatrixXd p = transition_matrix(graph, states, kernel);
  const Defects d = defects(states.pi(), p);
  const double second = second_eigenvalue(states.pi(), p);
  std::printf("  %d paths: |πP - π| %.1e, balance %.1e, rows %.1e, second eigenvalue %.4f\n",
              states.size(), d.invariance, d.balance, d.rows, second);
  EXPECT_LT(d.invariance, rounding);
  EXPECT_LT(d.balance, rounding);
  EXPECT_LT(d.rows, rounding);
  EXPECT_GE(p.minCoeff(), 0);
  EXPECT_LT(second, 1 - 1e-6);

  // From the first path to every path; as P is reversible, from every path to every path.
  std::vector<int> reached{0};
  std::vector<bool> known(static_cast<std::size_t>(states.size()));
  known[0] = true;
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (int y = 0; y < states.size(); ++y)
      if (p(reached[k], y) > 0 && !known[static_cast<std::size_t>(y)]) {
        known[static_cast<std::size_t>(y)] = true;
        reached.push_back(y);
      }
  EXPECT_EQ(reached.size(), known.size());
}

TEST_P(Pointlands, TheBidirectionalMutationProposesWithTheDensitiesThatItClaims) {
  const BidirectionalKernel kernel({1.0}, Bidirectional{});
  const ClaimDefects d = defects_of(claims_of(graph, states, kernel));
  std::printf("  %zu transitions: forward %.1e, reverse %.1e\n", d.transitions, d.forward,
              d.reverse);
  EXPECT_LT(d.forward, rounding);
  EXPECT_LT(d.reverse, rounding);
  EXPECT_EQ(d.one_way, 0);
}

TEST_P(Pointlands, AProposalHoldsWhatAFreshMeasurementOfItHolds) {
  for (int x = 0; x < states.size(); ++x) {
    PointPath current = states[x];
    double total = 0;
    Enumeration choices;
    do {
      PointPath y = poisoned(graph.max_vertices());
      const Proposed proposed = Bidirectional{}.propose(graph, current, y, choices);
      total += choices.probability();
      if (std::holds_alternative<Failure>(proposed)) continue;
      ASSERT_TRUE(same_vertices(y, states[states.index_of(y)])) << path_class(y);
    } while (choices.advance());
    EXPECT_NEAR(total, 1, rounding);
    EXPECT_TRUE(same_vertices(current, states[x]));
  }
}

TEST(PointlandClaims, EveryTwinClaimsADensityThatItDoesNotHave) {
  for (const NamedTwin& twin : bidirectional_twins()) {
    const Graph graph(proof_plan(twin.graph, 4));
    const StateSpace states(graph);
    const Mixture<BidirectionalTwin> kernel({1.0}, BidirectionalTwin{twin.spoil});
    const ClaimDefects d = defects_of(claims_of(graph, states, kernel));
    std::printf("  %-40s forward %8.1e   reverse %8.1e\n", twin.name.c_str(), d.forward, d.reverse);
    EXPECT_GT(std::max(d.forward, d.reverse), 1e-3) << twin.name;
  }
}

// ---- T-ALG: the discrete choices

TEST(PointlandChoices, APlaceToDeleteIsChosenWithTheProbabilityThatIsClaimed) {
  for (int n = 2; n <= 24; ++n)
    for (int d = 0; d <= std::min(n, most_replaced); ++d) {
      std::vector<double> sampled(static_cast<std::size_t>(n) + 1);
      Enumeration choices;
      do {
        const Bidirectional::Kept kept = Bidirectional::choose_kept(n, d, choices);
        ASSERT_EQ(kept.light + kept.sensor, n - d);
        ASSERT_TRUE(kept.light >= 0 && kept.sensor >= 0);
        sampled[static_cast<std::size_t>(kept.light)] += choices.probability();
      } while (choices.advance());
      // Where none is deleted, a vertex stays on either side.
      for (int light = d == 0 ? 1 : 0; light <= (d == 0 ? n - 1 : n - d); ++light)
        EXPECT_NEAR(sampled[static_cast<std::size_t>(light)],
                    Bidirectional::placement_probability(n, d, {light, n - d - light}), rounding);
    }
}

TEST(PointlandChoices, TheNumbersDeletedAndAddedHavePmfsThatSumToOne) {
  const auto expect_one = [](const LengthPmf& pmf) {
    double total = 0;
    for (const double p : pmf.span()) {
      EXPECT_GE(p, 0);
      total += p;
    }
    EXPECT_NEAR(total, 1, rounding);
  };
  for (int longest = 2; longest <= 40; ++longest)
    for (int n = 2; n <= longest; ++n) {
      expect_one(length_pmfs.deletion(n));
      for (int d = 0; d <= std::min(n, most_replaced); ++d)
        for (int light = 0; light <= n - d; ++light) {
          const Bidirectional::Kept kept{light, n - d - light};
          if (d == 0 && (kept.light == 0 || kept.sensor == 0)) continue;
          const auto& pmf = Bidirectional::addition_pmf(kept, d, longest);
          expect_one(pmf);
          EXPECT_GT(pmf[d], 0) << "the way back must be possible";
        }
    }
}

}  // namespace wander::test

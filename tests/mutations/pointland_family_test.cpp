// Families in Pointland, where their transition matrix is known to rounding: as many members as the
// program's own, with applicabilities that change at every move, each member at every place of the
// mixture; and large steps that have learned, whatever they learned.  Nothing here is statistical.
#include <gtest/gtest.h>

#include <cstdio>

#include "mutations/catalogue.h"
#include "tests/support/enumeration.h"

namespace wander::test {
namespace {

// Draws one end anew; cannot act on paths of two vertices.  Each is eager elsewhere, so the
// selection differs at both ends of nearly every move.
enum class End { light, sensor };
template <End end, int taste>
struct OtherEnd {
  static constexpr std::string_view name = "other end";

  double applicability(const Graph&, const PointPath& x) const {
    const int n = x.size();
    if (n == 2) return 0;
    double eagerness = n - 1.5;
    for (int i = 0; i < n; ++i) eagerness += taste * 0.37 * (i + 1) * x[i].place.node;
    return eagerness;
  }
  template <class Random>
  Proposed propose(const Graph& graph, const PointPath& x, PointPath& y, Random& random) const {
    const int n = x.size();
    y.resize(n);
    const bool is_light = end == End::light;
    y.copy(x, is_light ? 1 : 0, n - 1, is_light ? 1 : 0);
    if (is_light)
      graph.begin_light(y, 0, random);
    else
      graph.begin_sensor(y, n - 1, random);
    Reason flaw = join(graph, y, is_light ? 1 : n - 1);
    if (flaw == Reason::none)
      flaw = is_light ? evaluate(graph, y, 0, 1) : evaluate(graph, y, n - 2, n - 1);
    if (flaw != Reason::none) return Failure{flaw};
    return is_light ? Proposal{y[0].from_light, x[0].from_light}
                    : Proposal{y[n - 1].from_sensor, x[n - 1].from_sensor};
  }
};

using Others = OtherEnd<End::sensor, 1>;
using More = OtherEnd<End::sensor, 3>;
using Lights = OtherEnd<End::light, 2>;
using Plain = OtherEnd<End::light, 0>;

// What a seed pass could have found; nothing of some techniques.
SeedTally findings(int max_vertices, std::uint64_t seed) {
  Generator random(seed);
  SeedTally seeds(max_vertices);
  seeds.samples = 100;
  for (int n = 2; n <= max_vertices; ++n) {
    const double light = random.uniform();
    seeds.sum[static_cast<std::size_t>(n) - 2] += light;
    seeds.total += light;
    for (double& share : seeds.techniques.row(n)) {
      const double drawn = random.uniform();
      share = drawn < 0.3 ? 0 : light * drawn;
    }
  }
  return seeds;
}

PrimaryLarge learned(const Graph& graph, std::uint64_t seed) {
  PrimaryLarge large(graph.max_vertices());
  large.learn(findings(graph.max_vertices(), seed));
  return large;
}

template <class Kernel>
Defects measured(const Graph& graph, const StateSpace& states, const Kernel& kernel) {
  return defects(states.pi(), transition_matrix(graph, states, kernel));
}

void expect_exact(const Defects& d) {
  EXPECT_LT(d.invariance, rounding);
  EXPECT_LT(d.balance, rounding);
  EXPECT_LT(d.rows, rounding);
}

class PointlandFamily : public ::testing::TestWithParam<GraphPlan> {
 protected:
  Graph graph_{GetParam()};
  StateSpace states_{graph_};
};
INSTANTIATE_TEST_SUITE_P(Graphs, PointlandFamily, ::testing::ValuesIn(proof_plans()),
                         [](const auto& test) {
                           std::string name;
                           for (const char c : test.param.name)
                             if (std::isalpha(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

// The mutations in this order and in those that turn it by one place.
template <class First, class... Rest>
void expect_exact_in_every_place(const Graph& graph, const StateSpace& states, int turns,
                                 First first, Rest... rest) {
  static_assert(Mixture<First, Rest...>::count == UsualFamily::count);
  const Mixture<First, Rest...> kernel({0.3, 1, 0.2, 0.6, 0.15, 0.8}, first, rest...);
  expect_exact(measured(graph, states, kernel));
  if (turns > 1) {
    SCOPED_TRACE("turned");
    expect_exact_in_every_place(graph, states, turns - 1, rest..., first);
  }
}

TEST_P(PointlandFamily, OfSixKeepsTheTargetWithEachMemberInEveryPlace) {
  const Graph graph(proof_plan(GetParam().name, 4));
  const StateSpace states(graph);
  expect_exact_in_every_place(graph, states, 6, Bidirectional{}, Others{}, learned(graph, 1),
                              Lights{}, More{}, Plain{});
}

// The selection of one member alone left out of the ratio, whichever it is.
TEST(PointlandFamilyTwin, ThatForgetsTheSelectionOfOneMemberIsCaught) {
  const Graph graph(proof_plan("two lights, two sensors", 4));
  const StateSpace states(graph);
  using Six = Mixture<Bidirectional, Others, PrimaryLarge, Lights, More, Plain>;
  const Six kernel({0.3, 1, 0.2, 0.6, 0.15, 0.8}, {}, {}, learned(graph, 1), {}, {}, {});
  for (int forgotten = 0; forgotten < static_cast<int>(Six::count); ++forgotten) {
    const auto forgetful = [&](const Step<Pointland>& step) {
      Proposal p = std::get<Proposal>(step.outcome);
      if (step.mutation == forgotten) {
        const auto i = static_cast<std::size_t>(forgotten);
        p.forward /= kernel.probabilities(graph, step.current)[i];
        p.reverse /= kernel.probabilities(graph, step.proposed)[i];
      }
      return acceptance(step.current.contribution, p.forward, step.proposed.contribution,
                        p.reverse);
    };
    const Defects d = defects(states.pi(), transition_matrix(graph, states, kernel, forgetful));
    std::printf("  without the selection of member %d: balance %.1e\n", forgotten, d.balance);
    EXPECT_GT(d.balance, 1e-6);
  }
}

// The same of a family with members of one's own.
TEST(PointlandFamilyOf, AnyLengthKeepsTheTarget) {
  const Graph graph(proof_plan("glass", 4));
  const StateSpace states(graph);
  using Seven = Joined<Mixture<Plain, Bidirectional, PrimaryLarge, Lights>,
                       MutationList<More, OtherEnd<End::light, 5>, Others>>;
  static_assert(Seven::count == 7);
  const Seven kernel({0.8, 0.3, 0.2, 0.6, 0.15, 0.4, 1}, {}, {}, learned(graph, 1), {}, {}, {}, {});
  expect_exact(measured(graph, states, kernel));
}

TEST_P(PointlandFamily, LargeStepsKeepTheTargetWhateverTheyLearned) {
  for (const std::uint64_t seed : {1u, 2u, 3u})
    expect_exact(measured(graph_, states_, Mixture<PrimaryLarge>({1}, learned(graph_, seed))));
}

// What a large step claims of a path: of the way back to it, wherever it goes.
Scaled claimed_density(const Graph& graph, const PrimaryLarge& large, PointPath z) {
  weigh(graph, z);
  PointPath y(graph.max_vertices());
  Enumeration choices;
  do {
    const Proposed proposed = large.propose(graph, z, y, choices);
    if (const Proposal* p = std::get_if<Proposal>(&proposed)) return p->reverse;
  } while (choices.advance());
  throw std::logic_error("a large step never arrives");
}

TEST_P(PointlandFamily, LargeStepsThatLearnedProposeWithTheDensitiesThatTheyClaim) {
  const PrimaryLarge large = learned(graph_, 1);
  std::vector<double> sampled(static_cast<std::size_t>(states_.size()));
  Enumeration choices;
  do {
    PointPath y(graph_.max_vertices());
    const Proposed proposed = large.propose(graph_, states_[0], y, choices);
    const Proposal* p = std::get_if<Proposal>(&proposed);
    if (!p) continue;
    const int i = states_.index_of(y);
    sampled[static_cast<std::size_t>(i)] += choices.probability();
    EXPECT_EQ(p->forward, claimed_density(graph_, large, states_[i]));
  } while (choices.advance());
  for (int i = 0; i < states_.size(); ++i)
    EXPECT_NEAR(sampled[static_cast<std::size_t>(i)],
                claimed_density(graph_, large, states_[i]).value(), rounding);
}

// A quarter of q is even, the rest as the light was found: of lengths, and of techniques where any was.
TEST_P(PointlandFamily, LargeStepsTakeLengthsAndTechniquesAsTheirLightWasFound) {
  const SeedTally seeds = findings(graph_.max_vertices(), 1);
  PrimaryLarge large(graph_.max_vertices());
  large.learn(seeds);
  for (int i = 0; i < states_.size(); ++i) {
    PointPath z = states_[i];
    weigh(graph_, z);
    const int n = z.size();
    const double lengths = graph_.max_vertices() - 1;
    const double of_length =
        0.25 / lengths +
        0.75 * seeds.sum[static_cast<std::size_t>(n) - 2].value() / seeds.total.value();
    double all = 0, q = 0;
    for (const double share : seeds.techniques.row(n)) all += share;
    ASSERT_GT(all, 0);
    for (std::size_t s = 0; s < z.weights().size(); ++s)
      q += (0.25 / (n + 1) + 0.75 * seeds.techniques.row(n)[s] / all) * z.weights()[s];
    const double expected = of_length * q * z.intensity.value();
    EXPECT_NEAR(claimed_density(graph_, large, z).value(), expected, rounding * expected);
  }
}

// Positive control: samples by what it learned, and claims for paths of one length that all
// techniques were as likely.
struct ForgetfulOfOneLength {
  static constexpr std::string_view name = "forgetful of one length";
  PrimaryLarge learned, of_lengths;
  int length;

  double applicability(const Graph&, const PointPath&) const { return 1; }
  template <class Random>
  Proposed propose(const Graph& graph, const PointPath& x, PointPath& y, Random& random) const {
    Proposed proposed = learned.propose(graph, x, y, random);
    if (Proposal* p = std::get_if<Proposal>(&proposed)) {
      if (y.size() == length) p->forward = claimed_density(graph, of_lengths, y);
      if (x.size() == length) p->reverse = claimed_density(graph, of_lengths, x);
    }
    return proposed;
  }
};

TEST(PointlandFamilyTwin, OfALargeStepThatForgetsWhatItLearnedOfOneLengthIsCaught) {
  const Graph graph(proof_plan("diffuse", 4));
  const StateSpace states(graph);
  SeedTally lengths_alone = findings(graph.max_vertices(), 1);
  std::ranges::fill(lengths_alone.techniques.values(), 0);
  PrimaryLarge of_lengths(graph.max_vertices());
  of_lengths.learn(lengths_alone);
  for (int length = 2; length <= graph.max_vertices(); ++length) {
    const ForgetfulOfOneLength twin{learned(graph, 1), of_lengths, length};
    const Defects d = measured(graph, states, Mixture<ForgetfulOfOneLength>({1}, twin));
    std::printf("  paths of %d vertices: balance %.1e\n", length, d.balance);
    EXPECT_GT(d.balance, 1e-6);
  }
}

}  // namespace
}  // namespace wander::test

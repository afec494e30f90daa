// What is recorded of the chains of MMLT is what render() runs, every number of it fits the others,
// and the lengths share the chains in proportion to their light.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "lab/trace.h"
#include "tests/support/primary_runs.h"
#include "tests/support/test_scenes.h"

namespace wander::test::primary_trace_test {
namespace {

using Flat = Transport<Flatland>;
using Chains = MmltChains<Flat, Kelemen, ExpectedValues>;
using Shown = ShownChains<Flat, Chains>;

constexpr ChainSettings settings{.seed_share = 0, .fewest_seeds = 4096};
constexpr PrimaryKernel<Kelemen> kernel{Kelemen{}, default_large_step};

struct Room {
  explicit Room(const description::Scene& description) : scene(build(description)) {}
  FlatScene scene;
  Flat space{*scene, Roulette::off};

  Trace trace(int chains, std::uint64_t steps, const Session& session = budget_of(1)) const {
    return Tracer<Flat, Chains>(space, kernel, session, {chains, {.end = steps}}, settings).run();
  }
};

class TracedLengths : public ::testing::TestWithParam<int> {
 protected:
  Room room_{lit_scenes()[static_cast<std::size_t>(GetParam())].scene};
};
INSTANTIATE_TEST_SUITE_P(Rooms, TracedLengths,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST_P(TracedLengths, HoldEveryTermOfTheAcceptance) {
  const Trajectory t = room_.trace(4, 1000).trajectory;
  ASSERT_EQ(t.size(), 4000u);
  int proposals = 0, accepted = 0, wrong = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double f_ratio = t.log_f_proposed[i] - t.log_f_current[i];
    const double log_ratio = f_ratio + t.log_reverse[i] - t.log_forward[i];
    if (t.proposed.vertices[i] == 0) {
      EXPECT_TRUE(std::isnan(log_ratio));
      EXPECT_EQ(t.acceptance[i], 0);
      EXPECT_FALSE(t.accepted[i]);
      continue;
    }
    ++proposals;
    accepted += t.accepted[i];
    EXPECT_NEAR(std::min(1.0, std::exp(log_ratio)), t.acceptance[i], 1e-9);
    wrong += std::abs(std::min(1.0, std::exp(f_ratio)) - t.acceptance[i]) > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(proposals, 300);
  EXPECT_GT(accepted, 100);
  EXPECT_GT(wrong, 30);  // the control: without the densities
}

// A step leads from the state before it to its proposal, or stays; all paths have one length.
TEST_P(TracedLengths, HoldStatesThatFollowFromOneAnother) {
  const Trajectory t = room_.trace(3, 1000).trajectory;
  const auto draws = static_cast<std::size_t>(t.draws);
  for (std::size_t i = 0; i < t.size(); ++i) {
    const std::int32_t vertices = t.state.vertices[i / draws * draws];
    ASSERT_EQ(t.state.vertices[i], vertices);
    if (t.proposed.vertices[i] > 0) {
      ASSERT_EQ(t.proposed.vertices[i], vertices);
    }
    if (t.accepted[i]) {
      ASSERT_EQ(t.log_f[i], t.log_f_proposed[i]);
      ASSERT_EQ(t.state.film[i], t.proposed.film[i]);
    } else {
      ASSERT_EQ(t.log_f[i], t.log_f_current[i]);
    }
    if (i % draws > 0) {
      ASSERT_EQ(t.log_f_current[i], t.log_f[i - 1]);
    }
  }
}

TEST_P(TracedLengths, AreTheSameForAnyNumberOfThreads) {
  const auto bits = [](const std::vector<double>& values) {
    std::vector<std::uint64_t> bits;
    for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
    return bits;
  };
  Session session = budget_of(1);
  session.threads = 1;
  const Trajectory one = room_.trace(5, 200, session).trajectory;
  session.threads = 7;
  const Trajectory seven = room_.trace(5, 200, session).trajectory;
  EXPECT_EQ(bits(one.log_f_proposed), bits(seven.log_f_proposed));
  EXPECT_EQ(bits(one.log_forward), bits(seven.log_forward));
  EXPECT_EQ(bits(one.state.position), bits(seven.state.position));
  session.seed = 2;
  EXPECT_NE(bits(one.log_f), bits(room_.trace(5, 200, session).trajectory.log_f));
}

// Among paths of two vertices each group has one chain, which takes all its steps.
TEST(TracedMmlt, HasTheChainsOfRender) {
  description::Scene description = diffuse_room();
  description.max_vertices = 2;
  const Room room(description);
  constexpr std::uint64_t steps = 60, chains = settings.groups;
  const Rendering rendering =
      render_primary<MmltGroup, ExpectedValues>(*room.scene, budget_of(chains * steps), settings);
  const auto accepted = [&](const Session& session) {
    std::array<std::uint64_t, primary_move_names.size()> accepted{};
    const Trajectory t = room.trace(chains, steps, session).trajectory;
    for (std::size_t i = 0; i < t.size(); ++i)
      accepted[static_cast<std::size_t>(t.mutation[i])] += t.accepted[i];
    return accepted;
  };
  const auto traced = accepted(budget_of(1));
  ASSERT_EQ(rendering.mutations.size(), traced.size());
  for (std::size_t m = 0; m < traced.size(); ++m)
    EXPECT_EQ(rendering.mutations[m].accepted, traced[m]);
  EXPECT_NE(accepted(budget_of(1, 2)), traced);  // the control: chains with another seed
}

// ---- which chain has which length

std::vector<int> chains_by_length(const Room& room, int chains) {
  const Trajectory t = room.trace(chains, 1).trajectory;
  std::vector<int> counts(static_cast<std::size_t>(room.space.max_vertices()) - 1);
  for (const std::int32_t vertices : t.state.vertices)
    ++counts[static_cast<std::size_t>(vertices) - 2];
  return counts;
}

TEST(LengthsOfChains, AreInProportionToTheirLight) {
  const Room room(diffuse_room());
  const Session session = budget_of(1);
  wander::Run run(session);
  const Shown shown(room.space, kernel, run, settings);
  constexpr int chains = 24;
  const std::vector<int> counts = chains_by_length(room, chains);
  for (std::size_t n = 0; n < counts.size(); ++n) {
    const double share = shown.tally().sum[n].value() / shown.tally().total.value();
    EXPECT_NEAR(counts[n], chains * share, 1) << n + 2;
  }
  EXPECT_NE(std::ranges::max(counts), std::ranges::min(counts));
}

TEST(LengthsOfChains, LastAsLongAsGroupsHaveSeedsOfThem) {
  const Room room(diffuse_room());
  const Session session = budget_of(1);
  wander::Run run(session);
  const Shown shown(room.space, kernel, run, settings);
  const std::vector<int> counts = chains_by_length(room, shown.count());
  EXPECT_GT(shown.count(), 2 * settings.groups);
  EXPECT_LE(std::ranges::max(counts), settings.groups);
  EXPECT_GT(std::ranges::min(counts), 0);
  EXPECT_THROW(shown.chain(shown.count()), std::runtime_error);
  EXPECT_THROW(Room(dark_room()).trace(1, 1), NoLightFound);
}

}  // namespace
}  // namespace wander::test::primary_trace_test

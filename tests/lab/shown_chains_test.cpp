// Which chains of a run are shown, and that they are those of its groups.
#include "lab/shown_chains.h"

#include <gtest/gtest.h>

#include "mlt/run/path_group.h"
#include "mutations/catalogue.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

using Flat = Transport<Flatland>;
using Chains = PathChains<Flat, Family>;

using Places = std::vector<ChainPlace>;

TEST(OrderOfChains, OfOneStratumIsThatOfItsChains) {
  const Places chains{{0, 0}, {2, 0}, {0, 1}, {2, 1}};
  EXPECT_EQ(order_of_chains({chains}, {0.3}), chains);
}

// Of light 6 and 2: claims 6, 2 | 6/3, 2 (a draw goes to the first) | 6/5, 2 | 6/5, 2/3 | ...
TEST(OrderOfChains, SharesThemByTheLightOfTheirStratum) {
  const Places bright{{0, 0}, {1, 0}, {2, 0}}, dim{{0, 1}, {1, 1}};
  const Places expected{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}};
  EXPECT_EQ(order_of_chains({bright, dim}, {6, 2}), expected);
  EXPECT_NE(order_of_chains({bright, dim}, {2, 6}), expected);
}

TEST(OrderOfChains, OfNothingIsNothing) {
  EXPECT_TRUE(order_of_chains({}, {}).empty());
  EXPECT_TRUE(order_of_chains({{}, {}}, {0, 0}).empty());
}

// The first chain of every group comes before the second of any; each begins where that of its
// group does, with the same numbers.
TEST(ShownChains, AreThoseOfTheGroups) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  const Family family = make_family({}, space.max_vertices());
  constexpr ChainSettings settings{.groups = 4, .chains_per_group = 2, .fewest_seeds = 1024};
  Session session;
  session.seed = 7;
  session.threads = 2;
  wander::Run run(session);
  const ShownChains<Flat, Chains> shown(space, family, run, settings);
  ASSERT_EQ(shown.count(), 8);
  for (int k = 0; k < shown.count(); ++k) {
    Chains group(space, family, 7, k % 4, 2);
    group.add_seeds(256);
    auto chain = shown.chain(k);
    auto expected = group.chain(k / 4);
    ASSERT_EQ(chain.chain.current().contribution.log(),
              expected.chain.current().contribution.log());
    chain.random.start(3);
    expected.random.start(3);
    EXPECT_EQ(chain.random.uniform(), expected.random.uniform());
  }
  EXPECT_THROW(shown.chain(8), std::runtime_error);
}

// As render() does, whose seed pass ends where samples are costly.
TEST(ShownChains, HaveNoMoreSeedsThanAreWorthTheirCost) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  const Family family = make_family({}, space.max_vertices());
  constexpr ChainSettings settings{
      .groups = 4, .chains_per_group = 1, .fewest_seeds = 4 * ChainSettings::most_rays};
  Session session;
  session.threads = 2;
  wander::Run run(session);
  const ShownChains<Flat, Chains> shown(space, family, run, settings);
  EXPECT_GE(shown.tally().rays, ChainSettings::most_rays);
  EXPECT_LT(shown.tally().rays, 2 * ChainSettings::most_rays);
}

}  // namespace
}  // namespace wander::test

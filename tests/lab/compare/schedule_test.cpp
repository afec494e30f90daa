// Who runs when: everyone at every place alike, and no seed twice.
#include "lab/compare/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace wander::compare {
namespace {

using Place = std::tuple<std::size_t, std::size_t, std::size_t>;

TEST(Schedule, GivesEveryoneEachBudgetInEachReplicateOnce) {
  const auto turns = schedule({3, 2, 5}, 1);
  std::set<Place> seen;
  for (const Turn& turn : turns) seen.insert({turn.contender, turn.budget, turn.replicate});
  EXPECT_EQ(turns.size(), 30u);
  EXPECT_EQ(seen.size(), 30u);
}

// Spread of how often a contender takes each place among those of the same budget: 0 in a Latin
// square, 1 where replicates are no multiple of contenders.
std::size_t imbalance(const std::vector<Turn>& turns, std::size_t contenders) {
  std::map<Place, std::size_t> count;  // (budget, contender, place)
  for (std::size_t i = 0; i < turns.size(); ++i)
    for (std::size_t c = 0; c < contenders; ++c)
      count[{turns[i].budget, c, i % contenders}] += turns[i].contender == c ? 1 : 0;
  const auto by_count = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto [least, most] = std::minmax_element(count.begin(), count.end(), by_count);
  return most->second - least->second;
}

TEST(Schedule, PutsEachContenderEquallyOftenAtEachPlace) {
  EXPECT_EQ(imbalance(schedule({3, 2, 6}, 1), 3), 0u);
  EXPECT_EQ(imbalance(schedule({4, 3, 8}, 1), 4), 0u);
  EXPECT_LE(imbalance(schedule({3, 2, 7}, 1), 3), 1u);
  auto fixed_order = schedule({3, 2, 6}, 1);  // control
  std::ranges::sort(fixed_order, {}, [](const Turn& t) {
    return Place{t.replicate, t.budget, t.contender};
  });
  EXPECT_EQ(imbalance(fixed_order, 3), 6u);
}

TEST(Schedule, EndsEachReplicateBeforeTheNext) {
  const auto turns = schedule({3, 2, 6}, 1);
  EXPECT_TRUE(std::ranges::is_sorted(turns, {}, &Turn::replicate));
}

TEST(Seeds, AreDistinctAndKeptExactlyByJson) {
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
    for (const Turn& turn : schedule({5, 4, 30}, seed)) seeds.insert(turn.seed);
    for (std::uint64_t run = 0; run < 20; ++run) {
      seeds.insert(reference_seed(seed, run));
      seeds.insert(trial_seed(seed, run));
    }
  }
  EXPECT_EQ(seeds.size(), 3u * (600 + 40));
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << 53);
}

TEST(Seeds, OfAReplicateStayWhenMoreAreMade) {
  const auto few = schedule({3, 2, 2}, 7), more = schedule({3, 2, 4}, 7);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].seed, more[i].seed);
}

}  // namespace
}  // namespace wander::compare

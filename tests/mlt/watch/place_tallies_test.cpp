// Tallies by place, as a list and as a table, against a recount.
#include "mlt/watch/place_tallies.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <utility>

#include "core/rng.h"
#include "tests/support/allocation_counter.h"

namespace wander::test {
namespace place_tallies {
namespace {

constexpr std::size_t mutations = 3;
constexpr int width = 64, height = 48;
// Of more places and mutations than a list has room for.
Raster image() { return {std::array{height, width}, std::size_t{1} << 14}; }

struct Proposal {
  std::size_t mutation;
  int bin;
  double acceptance;
};
// Acceptances are eighths, so that sums are exact in any order.
Proposal proposal(std::uint64_t k, std::uint32_t stream) {
  Rng random(1, Purpose::test, stream);
  random.start(k);
  const auto below = [&](int n) { return static_cast<int>(n * random.uniform()); };
  const int mutation = below(mutations), bin = below(width * height);
  return {static_cast<std::size_t>(mutation), bin, below(9) / 8.0};
}

class Recount {
 public:
  void add(const Proposal& made) {
    auto& [proposed, acceptance] = of_[{made.mutation, made.bin}];
    proposed += 1;
    acceptance += made.acceptance;
  }
  void expect_same(const PlaceTallies& tallies) const {
    for (std::size_t m = 0; m < mutations; ++m) {
      const auto found = tallies.of_mutation(m);
      ASSERT_EQ(found.size(), static_cast<std::size_t>(width * height));
      for (int bin = 0; bin < width * height; ++bin) {
        const auto here = of_.find({m, bin});
        const auto& [proposed, acceptance] = found[static_cast<std::size_t>(bin)];
        EXPECT_EQ(proposed, here == of_.end() ? 0 : here->second.first) << m << " " << bin;
        EXPECT_EQ(acceptance, here == of_.end() ? 0 : here->second.second) << m << " " << bin;
      }
    }
  }

 private:
  std::map<std::pair<std::size_t, int>, std::pair<double, double>> of_;
};

void add(std::uint64_t count, std::uint32_t stream, PlaceTallies& tallies, Recount& recount) {
  for (std::uint64_t k = 0; k < count; ++k) {
    const Proposal made = proposal(k, stream);
    tallies.add(made.mutation, made.bin, made.acceptance);
    recount.add(made);
  }
}

TEST(PlaceTallies, AreARecountWhetherTheyAreAListOrATable) {
  for (const std::uint64_t count : {0, 1, 100, 4095, 4096, 4097, 20'000}) {
    PlaceTallies tallies(image(), mutations);
    Recount recount;
    add(count, 1, tallies, recount);
    recount.expect_same(tallies);
  }
}

TEST(PlaceTallies, OfSeveralGroupsAreThoseOfAll) {
  PlaceTallies all(image(), mutations);
  Recount recount;
  std::uint32_t stream = 1;
  for (const std::uint64_t count : {100, 5000, 0, 4000, 9000}) {
    PlaceTallies group(image(), mutations);
    add(count, stream++, group, recount);
    all.merge(group);
  }
  recount.expect_same(all);
}

TEST(PlaceTallies, AllocateNothingWhereTheyExpectIt) {
  PlaceTallies tallies(image(), mutations);
  for (const std::uint64_t count : {1000, 2000, 2000, 5000}) {
    tallies.expect(count);
    const AllocationCounter allocations;
    for (std::uint64_t k = 0; k < count; ++k) tallies.add(1, static_cast<int>(k % 100), 0.5);
    EXPECT_EQ(allocations.count(), 0) << count;
  }
}

TEST(PlaceTallies, OfNoPlacesAreNone) {
  PlaceTallies tallies(Raster(0), mutations), others = tallies;
  tallies.expect(1'000'000);
  tallies.merge(others);
  EXPECT_FALSE(tallies.has_places());
  EXPECT_TRUE(tallies.of_mutation(0).empty());
}

}  // namespace
}  // namespace place_tallies
}  // namespace wander::test

// The draws that are kept of a chain, in memory that does not grow.
#include "mlt/watch/functionals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wander::test {
namespace {

// The chain whose state after step i is i (+ chain / 4 in other functionals).
ThinnedDraws counted(std::uint64_t steps, double offset,
                     std::size_t most = ThinnedDraws::capacity) {
  ThinnedDraws draws(most);
  for (std::uint64_t i = 0; i < steps; ++i)
    draws.offer([&] {
      const auto x = static_cast<double>(i);
      return Functionals{x, x + offset, 1, offset};
    });
  return draws;
}

TEST(ThinnedDraws, AreStatesAtEqualDistances) {
  for (const std::uint64_t steps : {0u, 1u, 255u, 256u, 257u, 1024u, 5000u, 100'000u}) {
    for (const std::size_t most : {ThinnedDraws::capacity, std::size_t{64}}) {
      const ThinnedDraws draws = counted(steps, 0, most);
      EXPECT_LT(draws.size(), most);
      EXPECT_TRUE(draws.stride() == 1 || draws.size() >= most / 2);
      EXPECT_EQ(draws.size(), (steps + draws.stride() - 1) / draws.stride());
      for (std::size_t i = 0; i < draws.size(); ++i)
        EXPECT_EQ(draws[i][0], static_cast<double>(i * draws.stride()));
    }
  }
}

TEST(ThinnedDraws, AreFewerOfEachOfManyChains) {
  EXPECT_EQ(ThinnedDraws::capacity_of(1), ThinnedDraws::capacity);
  EXPECT_EQ(ThinnedDraws::capacity_of(8), ThinnedDraws::capacity);
  EXPECT_EQ(ThinnedDraws::capacity_of(40), 32u) << "a power of two";
  EXPECT_EQ(ThinnedDraws::capacity_of(1 << 10), 16u);
}

TEST(ChainDraws, OfChainsThatDifferInLengthHaveOneStrideAndOneLength) {
  const ThinnedDraws fine = counted(255, 0.25), coarse = counted(256, 0.5);
  ASSERT_NE(fine.stride(), coarse.stride());
  ChainDraws draws;
  draws.add(fine);
  draws.add(coarse);
  EXPECT_EQ(draws.chains(), 2u);
  EXPECT_EQ(draws.stride(), 2u);
  const Draws shifted = draws.of(1);
  ASSERT_EQ(shifted.chains, 2u);
  ASSERT_EQ(shifted.length, 128u);
  for (std::size_t i = 0; i < 128; ++i) {
    EXPECT_EQ(shifted.chain(0)[i], 2 * static_cast<double>(i) + 0.25);
    EXPECT_EQ(shifted.chain(1)[i], 2 * static_cast<double>(i) + 0.5);
  }
}

TEST(ChainDraws, OfNoChainsAreNone) {
  const ChainsRecord record = diagnostics(ChainDraws{});
  EXPECT_EQ(record.draws, 0u);
  for (const FunctionalRecord& f : record.functionals) EXPECT_TRUE(std::isnan(f.r_hat));
}

TEST(ChainsRecord, CountsAutocorrelationInSteps) {
  const ThinnedDraws a = counted(5000, 0), b = counted(5000, 1);
  ChainDraws draws;
  draws.add(a);
  draws.add(b);
  const ChainsRecord record = diagnostics(draws);
  EXPECT_EQ(record.stride, 32u);
  EXPECT_EQ(record.draws, 157u);
  ASSERT_EQ(record.functionals.size(), 4u);
  EXPECT_EQ(record.functionals[0].name, "film");
  EXPECT_EQ(record.functionals[0].autocorrelation_time, 32 * autocorrelation_time(draws.of(0)));
  EXPECT_TRUE(std::isnan(record.functionals[2].r_hat));  // one value
  EXPECT_EQ(record.functionals[3].r_hat,                 // one value in each chain
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace wander::test

// The draws that are kept of a chain, in memory that does not grow.
#include "mlt/watch/functionals.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(Functionals, HaveBothCoordinatesOfAFilm) {
  Features state;
  state.film = {0.25, 0.75};
  state.vertices = 4;
  const Functionals draw = functionals(state, -2);
  EXPECT_EQ(draw, (Functionals{0.25, -2, 4, draw[3], 0.75}));
  EXPECT_EQ(draw[second_coordinate], 0.75);
}

TEST(ChainDraws, OfNoChainsAreNone) {
  const ChainsRecord record = diagnostics(ChainDraws{});
  EXPECT_EQ(record.draws, 0u);
  for (const FunctionalRecord& f : record.functionals) EXPECT_TRUE(std::isnan(f.r_hat));
}

// Of an image the position has two coordinates, of which one may be known well: two chains, of which each is where the other is by the
// one, and by the other never.
TEST(ChainsRecord, TellsOfThePositionWhatItsWorseCoordinateSays) {
  for (const std::size_t stays : {std::size_t{0}, second_coordinate}) {
    ChainDraws draws;
    for (const double place : {0.2, 0.7}) {
      ThinnedDraws chain;
      for (int i = 0; i < 200; ++i)
        chain.offer([&] {
          Functionals draw{0.5, -1, 3, 0, 0.5};
          draw[stays] = place + 1e-3 * (i * 7 % 31);
          draw[second_coordinate - stays] = 1e-2 * (i * 37 % 97);
          return draw;
        });
      draws.add(chain);
    }
    const FunctionalRecord film = diagnostics(draws).functionals[0];
    EXPECT_GT(film.r_hat, 1.5);
    EXPECT_EQ(film.r_hat, rank_r_hat(draws.of(stays)));
    EXPECT_EQ(film.ess_bulk, ess_bulk(draws.of(stays)));
    EXPECT_EQ(film.ess_tail,
              std::min(ess_tail(draws.of(0)), ess_tail(draws.of(second_coordinate))));
    EXPECT_EQ(film.autocorrelation_time, autocorrelation_time(draws.of(stays)));
  }
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

// The sum of all deposits in whole numbers: exact enough, and the same in whatever order.
#include "mlt/run/total_film.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>
#include <vector>

#include "core/rng.h"
#include "mlt/run/large_pooled_film.h"

namespace wander::test {
namespace {

TEST(TotalFilm, KeepsManySmallDepositsBesideALargeOne) {
  TotalFilm film(4);
  film.add(2, 1e5, Tint<1>{});
  for (int i = 0; i < 1'000'000; ++i) film.add(2, 0.123456789, Tint<1>{});
  EXPECT_NEAR(film[2], 1e5 + 123456.789, 1'000'000 * 0x1p-25);
  EXPECT_EQ(film[1], 0);
}

TEST(TotalFilm, HasAllChannelsOfAPixelSideBySide) {
  TotalFilm film(6);
  film.add(1, 2, Tint<3>{{0.5, 1, 3}});
  EXPECT_EQ(film[2], 0);
  EXPECT_EQ(film[3], 1);
  EXPECT_EQ(film[4], 2);
  EXPECT_EQ(film[5], 6);
}

TEST(TotalFilm, DoesNotDependOnTheOrderOfItsDeposits) {
  const auto deposits = [](TotalFilm& film, std::uint32_t stream) {
    Rng random(1, Purpose::test, stream);
    for (int i = 0; i < 50'000; ++i) {
      random.start(static_cast<std::uint64_t>(i));
      const int pixel = static_cast<int>(8 * random.uniform());
      film.add(pixel, random.uniform(), Tint<1>{});
    }
  };
  TotalFilm forwards(8), backwards(8), at_once(8);
  for (const std::uint32_t k : {0u, 1u, 2u}) deposits(forwards, k);
  for (const std::uint32_t k : {2u, 1u, 0u}) deposits(backwards, k);
  {
    std::vector<std::jthread> threads;
    for (const std::uint32_t k : {0u, 1u, 2u})
      threads.emplace_back([&, k] { deposits(at_once, k); });
  }
  for (std::size_t j = 0; j < 8; ++j) {
    EXPECT_EQ(forwards[j], backwards[j]) << j;
    EXPECT_EQ(forwards[j], at_once[j]) << j;
  }
}

// Made before the first step of the chains, as by an interrupt between their seeds and that.
TEST(TotalFilm, OfChainsThatHaveMadeNoStepIsDark) {
  const std::array shape{2, 3};
  constexpr std::size_t bins = 6;
  const SharedFilms films(shape, 4, 4, {});
  const TotalFilm total(bins);
  SharedLight light{&films, 0};
  light.total = &total;
  const Constant constant{.b = {.value = 2}};
  const FilmEstimate film = total_film(std::array{light}, constant, {2, 3});
  EXPECT_EQ(film.value, std::vector<double>(bins, 0));
}

}  // namespace
}  // namespace wander::test

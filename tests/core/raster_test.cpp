// The raster of a film: blocks that cover it, each bin in one, and never too many.
#include "core/raster.h"

#include <gtest/gtest.h>

#include <array>

#include "core/film_layout.h"

namespace wander::test {
namespace {

TEST(Raster, OfASmallFilmIsTheFilm) {
  const Raster raster(std::array{4, 5}, 20);
  EXPECT_TRUE(raster.is_film());
  EXPECT_EQ(raster.shape(), (std::vector{4, 5}));
  for (int bin = 0; bin < 20; ++bin) EXPECT_EQ(raster.cell(bin), static_cast<std::size_t>(bin));
}

TEST(Raster, OfALargeFilmIsMadeOfBlocks) {
  const Raster row(std::array{11}, 4);  // 4 + 4 + 3 bins
  EXPECT_FALSE(row.is_film());
  EXPECT_EQ(row.shape(), std::vector{3});
  EXPECT_EQ(row.cell(3), 0u);
  EXPECT_EQ(row.cell(4), 1u);
  EXPECT_EQ(row.cell(10), 2u);
  const Raster image(std::array{5, 6}, 12);  // blocks of 2 × 2
  EXPECT_EQ(image.shape(), (std::vector{3, 3}));
  EXPECT_EQ(image.cell(0 * 6 + 5), 2u);
  EXPECT_EQ(image.cell(1 * 6 + 1), 0u);
  EXPECT_EQ(image.cell(2 * 6 + 0), 3u);
  EXPECT_EQ(image.cell(4 * 6 + 5), 8u);
}

TEST(Raster, HasAtMostAsManyCellsAsAskedAndHalfOfThemWherePossible) {
  for (const int bins : {16'384, 16'385, 1'000'000, 10'000'000}) {
    const Raster raster = FilmLayout{}.raster(std::array{bins});
    EXPECT_LE(raster.cells(), std::size_t{1} << 14);
    EXPECT_GE(raster.cells(), std::size_t{1} << 13);
    EXPECT_EQ(raster.cell(bins - 1), raster.cells() - 1);
  }
}

TEST(FilmLayout, KeepsByItselfWhatIsSmall) {
  const FilmLayout usual, asking{.by_length = Keep::always, .maps = Keep::always};
  const std::array small{16'384}, large{16'385};
  EXPECT_FALSE(usual.is_large(small));
  EXPECT_TRUE(usual.is_large(large));
  EXPECT_TRUE(usual.keeps_lengths(small, 8));
  EXPECT_FALSE(usual.keeps_lengths(small, 2000)) << "more than 2^24 numbers";
  EXPECT_FALSE(usual.keeps_lengths(large, 8));
  EXPECT_TRUE(asking.keeps_lengths(large, 8));
  EXPECT_EQ(usual.maps_of(small).cells(), 16'384u);
  EXPECT_EQ(usual.maps_of(large).cells(), 0u);
  EXPECT_EQ(asking.maps_of(large).cells(), 8193u);
}

}  // namespace
}  // namespace wander::test

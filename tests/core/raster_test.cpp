// The raster of a film: blocks that cover it, each bin in one, and never too many.
#include "core/raster.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

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
  constexpr std::size_t most = 1 << 14;
  for (const int bins : {16'384, 16'385, 1'000'000, 10'000'000}) {
    const Raster raster(std::array{bins}, most);
    EXPECT_LE(raster.cells(), most);
    EXPECT_GE(raster.cells(), most / 2);
    EXPECT_EQ(raster.cell(bins - 1), raster.cells() - 1);
  }
}

// The row of a bin comes from a product; at the ends and in the middle of rows it must be that of the quotient, in films
// of any width, up to the largest number that a bin can have: first, middle and last rows, 3000 of each.
TEST(Raster, FindsTheRowOfEveryBin) {
  const auto expect_cell = [](const Raster& raster, int width, int shift, std::int64_t bin) {
    const auto row = static_cast<std::size_t>(bin / width) >> shift,
               column = static_cast<std::size_t>(bin % width) >> shift;
    ASSERT_EQ(raster.cell(static_cast<int>(bin)),
              row * static_cast<std::size_t>(raster.shape().back()) + column)
        << bin << " of a width of " << width;
  };
  for (const int width : {1, 2, 3, 7, 127, 1023, 4097, 46'340, 46'341}) {
    const std::int64_t rows = 2'147'483'647 / width;
    const Raster raster(std::array{static_cast<int>(rows), width}, 1 << 12);
    int shift = 0;
    while ((width - 1) >> shift >= raster.shape().back()) ++shift;
    while ((rows - 1) >> shift >= raster.shape().front()) ++shift;
    for (const std::int64_t first : {std::int64_t{0}, rows / 2, rows - 3000})
      for (std::int64_t row = first; row < first + 3000; ++row)
        for (const std::int64_t column : {0, width / 2, width - 1})
          expect_cell(raster, width, shift, row * width + column);
  }
}

TEST(FilmLayout, OfALargeFilmOrOneInColourAsksForFewCells) {
  const FilmLayout usual;
  EXPECT_EQ(usual.raster(std::array{128, 128}).cells(), 128u * 128u);
  EXPECT_EQ(usual.raster(std::array{128, 129}).cells(), 16u * 17u);
  EXPECT_EQ(usual.raster(std::array{128, 128, 3}).cells(), 32u * 32u);
  EXPECT_FALSE(usual.has_few_pixels(std::array{128, 129}));
  EXPECT_TRUE(usual.has_few_pixels(std::array{128, 128, 3}));
  EXPECT_TRUE(usual.is_large(std::array{128, 128, 3}));
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

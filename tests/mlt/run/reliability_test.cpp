// Which bins of a film of chains are reliable: recounted bin by bin, for a curve and for images.
#include "mlt/run/reliability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/film.h"
#include "mlt/run/deposit.h"

namespace wander::test::reliability_test {
namespace {

constexpr auto enough = static_cast<std::size_t>(GroupsFilm::fewest_groups);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Whose bins are known as so many events would tell them; below zero, dark.
FilmEstimate known_as(const std::vector<double>& events, std::vector<int> shape) {
  FilmEstimate film{.shape = std::move(shape)};
  for (std::size_t j = 0; j < events.size(); ++j) {
    film.value.push_back(events[j] < 0 ? 0 : 1 + static_cast<double>(j));
    film.standard_error.push_back(events[j] < 0 ? 0 : film.value[j] / std::sqrt(events[j]));
  }
  return film;
}

std::vector<bool> told(FilmEstimate film, std::size_t groups = enough) {
  tell_reliable(film, groups);
  return film.reliable;
}

TEST(ReliableBins, NeedEnoughGroups) {
  const FilmEstimate film = known_as({1e6, 1e6, 1e6}, {3});
  EXPECT_EQ(told(film, enough - 1), std::vector<bool>(3, false));
  EXPECT_EQ(told(film), std::vector<bool>(3, true));
}

// The bins around are asked for a hundred events, the bin itself for fifty.
TEST(ReliableBins, AreJudgedByWhatTheBinsAroundThemClaim) {
  EXPECT_EQ(told(known_as(std::vector<double>(9, 101), {9})), std::vector<bool>(9, true));
  EXPECT_EQ(told(known_as(std::vector<double>(9, 99), {9})), std::vector<bool>(9, false));
  std::vector<double> one_less(9, 120), one_more(9, 80);
  one_less[4] = 51;
  one_more[4] = 390;
  EXPECT_TRUE(told(known_as(one_less, {9}))[4]);
  EXPECT_FALSE(told(known_as(one_more, {9}))[4]) << "claims less error than all around it";
  one_less[4] = 49;
  one_more[4] = 401;
  EXPECT_FALSE(told(known_as(one_less, {9}))[4]);
  EXPECT_TRUE(told(known_as(one_more, {9}))[4]) << "known well enough by itself";
}

TEST(ReliableBins, AskLitBinsOnly) {
  std::vector<double> alone(9, -1);
  alone[3] = 110;
  const std::vector<bool> reliable = told(known_as(alone, {9}));
  for (std::size_t j = 0; j < 9; ++j) EXPECT_EQ(reliable[j], j == 3) << j;
}

TEST(ReliableBins, NeedAnErrorThatCanBeTold) {
  FilmEstimate film = known_as(std::vector<double>(9, 1000), {9});
  film.standard_error[2] = nan;
  std::vector<bool> expected(9, true);
  expected[2] = false;
  EXPECT_EQ(told(film), expected);
}

// Straight from the words of the header, by sorting.
bool recounted(const std::vector<double>& events, const std::vector<int>& shape, int row,
               int column, int channel) {
  const bool curve = shape.size() == 1;
  const int rows = curve ? 1 : shape[0], columns = curve ? shape[0] : shape[1];
  const int channels = shape.size() > 2 ? shape[2] : 1;
  const auto at = [&](int r, int c) {
    return events[static_cast<std::size_t>((r * columns + c) * channels + channel)];
  };
  std::vector<double> around;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      if (std::abs(r - row) <= 1 && std::abs(c - column) <= (curve ? 4 : 1) && at(r, c) >= 0)
        around.push_back(at(r, c));
  std::ranges::sort(around);
  const double own = at(row, column);
  return own >= 400 || (own >= 50 && around[around.size() / 2] >= 100);
}

TEST(ReliableBins, AreThoseOfARecount) {
  std::uint64_t state = 12;
  const auto next = [&] {  // Knuth's MMIX generator
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11) * 0x1p-53;
  };
  int trusted = 0, all = 0;
  for (const std::vector<int>& shape : {std::vector{40}, {6, 7}, {7, 5, 3}, {1, 9}, {9, 1}}) {
    const int rows = shape.size() == 1 ? 1 : shape[0];
    const int columns = shape.size() == 1 ? shape[0] : shape[1];
    const int channels = shape.size() > 2 ? shape[2] : 1;
    std::vector<double> events;
    for (int j = 0; j < rows * columns * channels; ++j)
      events.push_back(next() < 0.2 ? -1 : 30 * std::exp(3 * next()));
    const std::vector<bool> reliable = told(known_as(events, shape));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        for (int k = 0; k < channels; ++k, ++all) {
          const auto j = static_cast<std::size_t>((r * columns + c) * channels + k);
          EXPECT_EQ(reliable[j], recounted(events, shape, r, c, k)) << r << ' ' << c << ' ' << k;
          trusted += reliable[j] ? 1 : 0;
        }
  }
  EXPECT_GT(trusted, all / 5);
  EXPECT_LT(trusted, 4 * all / 5);
}

}  // namespace
}  // namespace wander::test::reliability_test

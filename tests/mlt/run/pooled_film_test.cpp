// The film of samples and chains, and its error bars, from groups made by hand.
#include "mlt/run/pooled_film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <list>
#include <numeric>

#include "core/film_statistics.h"
#include "statistics/jackknife.h"

namespace wander::test::pooled_film_test {
namespace {

constexpr std::array two_bins{2};
constexpr double border = 2;

// Groups of ten samples, whose chains deposit 4 in all.
class Groups {
 public:
  // Light l w_B of samples on both bins; of the chains, all deposits on the first bin and those that
  // count w_M times on both.
  void add(double easy_first, double easy_second, double first, double hard_first,
           double hard_second, double weight = 1) {
    Held& held = held_.emplace_back();
    held.tally.samples = 10;
    held.parts.add_sample({{2, 0, 0, easy_first}, {3, 1, 1, easy_second}});
    held.film.add(2, 0, first);
    held.film.add(3, 1, 4 - first);
    held.parts.of_chains().add(2, 0, hard_first);
    held.parts.of_chains().add(3, 1, hard_second);
    findings_.push_back({.seeds = &held.tally,
                         .of_seeds = &held.tally,
                         .evidence = nullptr,
                         .film = &held.film,
                         .parts = {&held.parts, 1},
                         .scale = 0.25 * weight,
                         .weight = weight});
  }
  std::span<const GroupFindings> findings() const { return findings_; }

 private:
  struct Held {
    SeedTally tally{4};
    GroupFilm film{2, 4};
    PooledParts parts{{{border}}, two_bins, 4, {}};
  };
  std::list<Held> held_;
  std::vector<GroupFindings> findings_;
};

PooledFilm pooled(const Groups& groups, const Constant& b, std::vector<int> runs) {
  return pooled_film(groups.findings(), runs, b, {2});
}

TEST(PooledFilm, IsTheSumOfItsPartsAtTheLevelOfB) {
  Groups groups;
  groups.add(1, 2, 3, 1.5, 0.5);
  groups.add(3, 1, 2, 1, 1);
  const Constant b{.b = {0.5, 0}, .without = {0.5, 0.5}};
  const auto [film, of_samples, film_of_samples] = pooled(groups, b, {2});
  const double easy[]{2 * 4.0 / 20, 2 * 3.0 / 20};
  const double hard[]{2 * 0.5 * 2.5 / 8, 2 * 0.5 * 1.5 / 8};
  const double mean = (easy[0] + hard[0] + easy[1] + hard[1]) / 2;
  for (std::size_t j : {0u, 1u})
    EXPECT_DOUBLE_EQ(film.value[j], (easy[j] + hard[j]) * 0.5 / mean) << j;
  for (std::size_t j : {0u, 1u}) EXPECT_DOUBLE_EQ(film_of_samples[j], easy[j] * 0.5 / mean) << j;
  EXPECT_DOUBLE_EQ(mean_value(film), 0.5) << "b is the mean of the film";
  EXPECT_DOUBLE_EQ(of_samples, (easy[0] + easy[1]) / 2 / mean);
  EXPECT_DOUBLE_EQ(film.by_length.at(2)[0], film.value[0]);
  EXPECT_DOUBLE_EQ(film.by_length.at(3)[1], film.value[1]);
}

// With the constant of the border the film is the sum of its parts, whatever other constants say; and
// its error is that of the same from all groups but one.
TEST(PooledConstant, IsTheBridgeAtTheBorder) {
  const double made[][5]{{1, 2, 3, 1.5, 0.5}, {3, 1, 2, 1, 1}, {2, 2, 1, 0.5, 2}};
  Groups all;
  for (const auto& g : made) all.add(g[0], g[1], g[2], g[3], g[4]);
  const std::vector<int> one_run{3};
  const Constant b = pooled_constant(all.findings(), one_run);
  const double easy = 11. / 30, hard = 6.5 / 12;
  EXPECT_NEAR(b.b.value, easy / (1 - hard), 1e-14);
  std::vector<double> without;
  for (std::size_t out = 0; out < 3; ++out) {
    Groups rest;
    for (std::size_t g = 0; g < 3; ++g)
      if (g != out) rest.add(made[g][0], made[g][1], made[g][2], made[g][3], made[g][4]);
    without.push_back(pooled_constant(rest.findings(), std::vector{2}).b.value);
    EXPECT_NEAR(b.without[out], without.back(), 1e-14);
  }
  EXPECT_NEAR(b.b.standard_error, jackknife_error(without), 1e-14);
  const FilmEstimate film = pooled(all, b, one_run).film;
  EXPECT_NEAR(film.value[0], 2 * (6. / 30 + b.b.value * 3. / 12), 1e-14);
  EXPECT_NEAR(film.value[1], 2 * (5. / 30 + b.b.value * 3.5 / 12), 1e-14);
}

TEST(PooledConstant, IsNoneWhereSamplesCarryNoLight) {
  Groups dark;
  for (int g = 0; g < 3; ++g) dark.add(0, 0, 3, 3, 1);
  EXPECT_FALSE(pooled_constant(dark.findings(), std::vector{3}).failure.empty());
  Groups hard;  // what samples found is easy, and chains are nowhere but in what is not
  for (int g = 0; g < 3; ++g) hard.add(1, 2, 3, 3, 1);
  EXPECT_FALSE(pooled_constant(hard.findings(), std::vector{3}).failure.empty());
}

// Of one run the jackknife is to make the film again from all groups but one.
TEST(PooledFilm, HasTheErrorOfAGroupThatTakesItsSamplesAndItsChainsAlong) {
  const double made[][5]{{1, 2, 3, 1.5, 0.5}, {3, 1, 2, 1, 1}, {2, 2, 1, 0.5, 2}, {0, 3, 4, 3, 0}};
  const std::vector<double> without{0.45, 0.52, 0.5, 0.55};
  Groups all;
  for (const auto& g : made) all.add(g[0], g[1], g[2], g[3], g[4]);
  const FilmEstimate film = pooled(all, {.b = {0.5, 0}, .without = without}, {4}).film;
  for (std::size_t j : {0u, 1u}) {
    std::vector<double> values;
    for (std::size_t out = 0; out < 4; ++out) {
      Groups rest;
      for (std::size_t g = 0; g < 4; ++g)
        if (g != out) rest.add(made[g][0], made[g][1], made[g][2], made[g][3], made[g][4]);
      const Constant b{.b = {without[out], 0}, .without = {0.5, 0.5, 0.5}};
      values.push_back(pooled(rest, b, {3}).film.value[j]);
    }
    EXPECT_NEAR(film.standard_error[j], jackknife_error(values), 1e-14) << j;
  }
  EXPECT_LE(film.degrees_of_freedom, 3);
}

// Runs have borders of their own, so each is pooled by itself: the film is the mean of theirs.
TEST(PooledFilm, OfRunsIsTheMeanOfTheirFilmsByTheirWeights) {
  Groups one, other, both;
  const auto fill_one = [](Groups& to, double w) {
    to.add(1, 2, 3, 1.5, 0.5, w);
    to.add(3, 1, 2, 1, 1, w);
  };
  const auto fill_other = [](Groups& to, double w) {
    to.add(4, 0, 1, 0.2, 0.1, w);
    to.add(5, 1, 3, 0.4, 0.3, w);
  };
  fill_one(one, 1);
  fill_other(other, 1);
  fill_one(both, 1);
  fill_other(both, 3);
  const double b = 0.5;
  const Constant two{.b = {b, 0}, .without = {b, b}}, four{.b = {b, 0}, .without = {b, b, b, b}};
  const FilmEstimate x = pooled(one, two, {2}).film, y = pooled(other, two, {2}).film;
  const FilmEstimate film = pooled(both, four, {2, 2}).film;
  // Before their levels are set, the films have these means.
  const double level_x = 0.35 + b * 0.5, level_y = 0.5 + b * 0.125;
  const double mean = 0.25 * level_x + 0.75 * level_y;
  for (std::size_t j : {0u, 1u})
    EXPECT_NEAR(film.value[j], (0.25 * level_x * x.value[j] + 0.75 * level_y * y.value[j]) / mean,
                1e-14)
        << j;
}

TEST(PooledFilm, TrustsBinsOfEnoughGroupsAlone) {
  Groups few, enough;
  for (int g = 0; g < 15; ++g) few.add(1, 2, 3, 1.5, 0.5);
  for (int g = 0; g < 16; ++g) enough.add(1, 2, 3, 1.5, 0.5);
  const Constant b{.b = {0.5, 0}, .without = std::vector<double>(16, 0.5)};
  EXPECT_FALSE(pooled(few, b, {15}).film.reliable[0]);
  EXPECT_TRUE(pooled(enough, b, {16}).film.reliable[0]);
}

TEST(PooledFilm, CountsTheGroupsWhoseChainsFoundLight) {
  for (const int lit : {15, 16}) {
    Groups groups;
    for (int g = 0; g < 16; ++g) groups.add(1, 2, 3, 1.5, 0.5, g < lit ? 1 : 0);
    const Constant b{.b = {0.5, 0}, .without = std::vector<double>(16, 0.5)};
    EXPECT_EQ(pooled(groups, b, {16}).film.reliable[0], lit == 16) << lit;
  }
}

}  // namespace
}  // namespace wander::test::pooled_film_test

// Films that groups share: float and double together keep what float alone would lose.
#include "mlt/run/shared_films.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/rng.h"
#include "mlt/run/large_film.h"

namespace wander::test {
namespace {

constexpr FilmLayout layout{.most_small = 8};

SharedFilms films_of(int bins, int groups, const FilmLayout& how = layout) {
  return {std::array{bins}, 5, groups, how};
}

TEST(SharedFilms, AreAtMostSixteenAndTakeAllGroupsInTurn) {
  EXPECT_EQ(films_of(20, 64).count(), 16);
  EXPECT_EQ(films_of(20, 5).count(), 5);
  const SharedFilms films = films_of(20, 40);  // of three groups each, and of two
  EXPECT_EQ(films.film_of_group(7), films.film_of_group(39));
  double sum = 0;
  std::array<double, 16> of_film{};
  for (int g = 0; g < 40; ++g) {
    sum += films.share_of_group(g);
    of_film[static_cast<std::size_t>(films.film_of_group(g))] += films.share_of_group(g);
  }
  EXPECT_DOUBLE_EQ(sum, 40);
  for (const double share : of_film) EXPECT_DOUBLE_EQ(share, 2.5);
}

// 2^22 deposits on a bin of each film, more on one film than on the others; and a deposit so small
// that a float would not see it.  What is common to the films is kept in double: errors of 4e-9, and of 2e-6 of
// their difference; were nothing flushed, of 6e-8 and 17e-6.
TEST(SharedFilms, KeepWhatFloatAloneWouldLose) {
  SharedFilms films = films_of(20, 16);
  constexpr int turns = 1 << 13, each = 1 << 9;
  double expected_first = 0, expected_last = 0, expected_small = 0;
  for (int turn = 0; turn < turns; ++turn) {
    for (int i = 0; i < each; ++i) {
      for (int f = 0; f < 16; ++f) films[f].add(2, 3, 0.3 + (f == 0 ? 0.001 : 0));
      expected_first += 0.301;
      expected_last += 0.3;
    }
    films[1].add(2, 5, turn == 0 ? 1e4 : 1e-4);
    expected_small += turn == 0 ? 1e4 : 1e-4;
    films.flush();
  }
  EXPECT_NEAR(films.deposits(0, 3) / expected_first, 1, 2e-8);
  EXPECT_NEAR(films.deposits(15, 3) / expected_last, 1, 2e-8);
  EXPECT_NEAR(films.deposits(0, 3) - films.deposits(15, 3), expected_first - expected_last,
              6e-6 * (expected_first - expected_last));
  EXPECT_NEAR(films.deposits(1, 5), expected_small, 0.2);  // of 0.82 that are added to 10⁴
  EXPECT_EQ(films.deposits(0, 4), 0);
  constexpr int many = 1 << 25;  // the wrong twin: float stalls at 2^23
  float alone = 0;
  for (int i = 0; i < many; ++i) alone += 0.3F;
  EXPECT_LT(static_cast<double>(alone), 0.9 * 0.3 * many);
}

TEST(SharedFilms, KeepFilmsByLengthIfAskedFor) {
  SharedFilms films = films_of(20, 16, {.most_small = 8, .by_length = Keep::always});
  for (std::uint32_t i = 0; i < 3 * SharedFilm::most_additions; ++i) {
    films[0].add(3, 7, 1);
    films.flush();
  }
  films[1].add(3, 8, 16);
  ASSERT_EQ(films.lengths(), 4u);
  EXPECT_TRUE(films.mean_of_length(0).empty());
  EXPECT_EQ(films.mean_of_length(1)[7], 3.0 * SharedFilm::most_additions / 16);
  EXPECT_EQ(films.mean_of_length(1)[8], 1);
}

// Films of 16 groups whose deposits on two bins are these.
SharedFilms made(double first, double step) {
  SharedFilms films({std::array{2}, 5, 16, FilmLayout{.most_small = 1}});
  for (int f = 0; f < 16; ++f) {
    films[f].add(2, 0, first + step * f);
    films[f].add(2, 1, first);
  }
  return films;
}

TEST(LargeFilm, IsTheMeanOfItsFilmsWithTheErrorOfAMean) {
  const SharedFilms films = made(10, 1);  // 10, 11, … 25: variance 68/3
  const FilmEstimate film = mean_film({&films, 0.5}, {2});
  EXPECT_DOUBLE_EQ(film.value[0], 2 * 0.5 * 17.5);
  EXPECT_DOUBLE_EQ(film.value[1], 2 * 0.5 * 10);
  EXPECT_NEAR(film.standard_error[0], 2 * 0.5 * std::sqrt(340.0 / 15 / 16), 1e-12);
  EXPECT_EQ(film.standard_error[1], 0);
  EXPECT_EQ(film.degrees_of_freedom, 15);
  EXPECT_TRUE(film.reliable[0]);
}

// What groups share is one film of which the error knows.
TEST(LargeFilm, HasTheDegreesOfItsFilmsHoweverManyGroupsShareThem) {
  const SharedFilms films = films_of(20, 64);
  ASSERT_EQ(films.count(), 16);
  EXPECT_EQ(mean_film({&films, 1}, {20}).degrees_of_freedom, 15);
}

// Two runs of 16 films are as one of 32; one whose groups count twice is heard twice.
TEST(LargeFilm, OfTwoRunsIsThatOfAllTheirFilms) {
  const SharedFilms one = made(10, 1), other = made(10, 0);
  const Constant b{.b = {3, 0}, .without = std::vector<double>(32, 3.0)};
  const auto share = [&](double weight) {
    const std::array runs{SharedLight{&one, 1}, SharedLight{&other, 1, weight}};
    return normalized_film(runs, b, {2}).value[0] / 6;
  };
  EXPECT_NEAR(share(1), (17.5 + 10) / (17.5 + 10 + 10 + 10), 1e-12);
  EXPECT_NEAR(share(2), (17.5 + 20) / (17.5 + 10 + 20 + 20), 1e-12);
}

// Of a mean the jackknife of several groups follows from that of one: exactly.
TEST(LargeFilm, LeavesOutTheGroupsOfAFilmTogether) {
  const SharedFilms films = films_of(20, 64);
  Rng random(1, Purpose::test, 92);
  std::vector<double> x;
  double sum = 0;
  for (int g = 0; g < 64; ++g) sum += x.emplace_back(random.uniform());
  Constant b{.b = {sum / 64, 0}};
  for (const double of_group : x) b.without.push_back((sum - of_group) / 63);
  const std::vector<double> without = without_films(std::array{SharedLight{&films, 1}}, b);
  ASSERT_EQ(without.size(), 16u);
  EXPECT_NEAR(without[3], (sum - x[3] - x[19] - x[35] - x[51]) / 60, 1e-12);
}

// b · bins · the share of the deposits; without each film the constant changes, too.
TEST(LargeFilm, IsScaledToAConstantWithTheErrorOfBoth) {
  const SharedFilms films = made(10, 0);
  Constant b{.b = {3, 0.1}, .without = std::vector<double>(16, 3.0)};
  const std::array light{SharedLight{&films, 0.25}};
  FilmEstimate film = normalized_film(light, b, {2});
  EXPECT_DOUBLE_EQ(film.value[0], 3);
  EXPECT_NEAR(film.standard_error[0], 0, 1e-12);
  for (std::size_t g = 0; g < 16; ++g) b.without[g] = 3 + (g % 2 == 0 ? 0.1 : -0.1);
  film = normalized_film(light, b, {2});
  EXPECT_NEAR(film.standard_error[0], std::sqrt(15 * 0.01), 1e-12);
}

}  // namespace
}  // namespace wander::test

// From steps to a film: expected values sum to the number of steps, and groups give the error bars.
#include "mlt/run/deposit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/path_sampler.h"
#include "mutations/catalogue.h"
#include "scenes/format/build_scene.h"
#include "tests/support/coloured_box.h"
#include "tests/support/deposits.h"
#include "tests/support/invariance.h"
#include "tests/support/test_scenes.h"

namespace wander::test::deposit_test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

double total(const GroupFilm& film) {
  double sum = 0;
  for (const double weight : film.weights()) sum += weight;
  return sum;
}

class Deposit : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rooms, Deposit,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

TEST_P(Deposit, OfNStepsSumsToNAndNeverFallsOutside) {
  const FlatScene scene = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
  const Flat space(*scene, Roulette::off);
  const Family family = make_family({}, space.max_vertices());
  Starts<Flat> starts(space, 1);
  std::uint64_t first = 0;
  while (!(starts.draw(first) > 0)) ++first;
  Chain chain(space, family, starts.path());
  Rng random(1, Purpose::test, 40);
  GroupFilm film(scene->bins(), scene->max_vertices());
  constexpr std::uint64_t steps = 20'000;
  for (std::uint64_t i = 0; i < steps; ++i) {
    random.start(i);
    chain.step(random, [&](const Step<W>& step) {
      for (const double u : space.film_position(step.current)) ASSERT_TRUE(u >= 0 && u < 1) << u;
      if (step.acceptance > 0) {
        for (const double u : space.film_position(step.proposed)) ASSERT_TRUE(u >= 0 && u < 1) << u;
      }
      deposit(space, step, space.bin(step.current), film);
    });
  }
  EXPECT_NEAR(total(film), steps, 1e-9);
  double by_length = 0;
  for (const auto& [vertices, values] : film.lengths().scaled(1)) {
    EXPECT_GE(vertices, 2);
    EXPECT_LE(vertices, scene->max_vertices());
    by_length = std::accumulate(values.begin(), values.end(), by_length);
  }
  EXPECT_NEAR(by_length, steps, 1e-6);
}

// By bin and by length, whether films of each length are kept or not.
TEST(GroupFilm, SumsAreThoseOfItsDepositsWithFilmsOfLengthsAndWithout) {
  constexpr int bins = 1 << 14, vertices = 1100;
  FilmLayout keeps;
  keeps.by_length = Keep::always;
  ASSERT_FALSE(FilmLayout{}.keeps_lengths(std::array{bins}, vertices));
  for (const FilmLayout& layout : {FilmLayout{}, keeps}) {
    GroupFilm film(std::array{bins}, vertices, layout);
    film.add(2, 0, 1.0);
    film.add(2, bins - 1, 2.0);
    film.add(vertices, bins - 1, 4.0);
    film.add(7, 5, 8.0);
    film.add(7, 5, 0.5);
    EXPECT_EQ(film.bins(), std::size_t{bins});
    EXPECT_EQ(film.weights()[0], 1);
    EXPECT_EQ(film.weights()[5], 8.5);
    EXPECT_EQ(film.weights()[bins - 1], 6);
    EXPECT_EQ(total(film), 15.5);
    std::vector<double> expected(vertices - 1);
    expected.front() = 3;
    expected[5] = 8.5;
    expected.back() = 4;
    EXPECT_EQ(film.by_length(), expected);
  }
}

// One step deposits 1 - a at x and a at y, whatever was decided.
TEST(DepositOfOneStep, IsSharedByTheTwoPathsInProportionToTheAcceptance) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  Starts<Flat> starts(space, 2);
  const auto draw = [&](std::uint64_t from, int other_bin, int other_size) {
    for (std::uint64_t i = from;; ++i)
      if (starts.draw(i) > 0 && space.bin(starts.path()) != other_bin &&
          starts.path().size() != other_size)
        return starts.path();
  };
  const Path<W> x = draw(0, -1, 0), y = draw(100, space.bin(x), x.size());
  const int bin_x = space.bin(x), bin_y = space.bin(y);
  for (const Reason decision : {Reason::none, Reason::metropolis}) {
    for (const double a : {0.0, 0.25, 1.0}) {
      GroupFilm film(scene->bins(), scene->max_vertices());
      deposit(space, Step<W>{x, y, 0, Proposal{1, 1}, a, decision}, bin_x, film);
      EXPECT_EQ(film.weights()[static_cast<std::size_t>(bin_x)], 1 - a);
      EXPECT_EQ(film.weights()[static_cast<std::size_t>(bin_y)], a);
      EXPECT_EQ(total(film), 1);
      auto lengths = film.lengths().scaled(1);
      const auto in_film_of = [&](int vertices, int bin) {
        auto& of_length = lengths[vertices];
        of_length.resize(film.bins());
        return of_length[static_cast<std::size_t>(bin)];
      };
      EXPECT_EQ(in_film_of(x.size(), bin_x), 1 - a);
      EXPECT_EQ(in_film_of(y.size(), bin_y), a);
    }
  }
}

TEST(DepositOfOneStep, HasTheColoursOfItsPaths) {
  using Coloured = SpacelandColour;
  const auto scene = build_scene<Coloured>(coloured_box());
  const Transport<Coloured> space(*scene, Roulette::off);
  PathSampler<Transport<Coloured>> sampler(space, all_techniques, Heuristic::balance);
  std::vector<Path<Coloured>> paths;
  Rng random(1, Purpose::test, 41);
  for (std::uint64_t i = 0; i < 100; ++i) {
    random.start(i);
    sampler.sample(random, [&](const Path<Coloured>& x, int, double) { paths.push_back(x); });
  }
  ASSERT_FALSE(paths.empty());
  const Path<Coloured>& x = paths.front();
  const auto y = std::ranges::find_if(
      paths, [&](const auto& other) { return colour(other).colour != colour(x).colour; });
  ASSERT_NE(y, paths.end());
  const Step<Coloured> step{x, *y, 0, Proposal{1, 1}, 0.25, Reason::none};
  int deposits = 0;
  for_each_deposit(space, step, space.bin(x), [&](const auto& path, int, int, double, auto shown) {
    EXPECT_EQ(shown.colour, colour(path).colour);
    ++deposits;
  });
  EXPECT_EQ(deposits, 2);
}

// A group of two bins whose chains deposited so much.
GroupFilm group(double first, double second) {
  GroupFilm film(2, 4);
  film.add(2, 0, first);
  film.add(3, 1, second);
  return film;
}

// Two bins, b_g, steps: a bin is 2 b_g (deposits / steps).
TEST(GroupsFilm, IsTheMeanOfItsGroupsWithTheErrorOfAMean) {
  GroupsFilm film({2});
  film.add(group(3, 1), 2.0, 4);  // 3, 1
  film.add(group(1, 1), 1.0, 2);  // 1, 1
  film.add(group(2, 6), 4.0, 8);  // 2, 6
  film.add_dark_group();          // 0, 0
  const FilmEstimate estimate = film.estimate();
  EXPECT_EQ(estimate.degrees_of_freedom, 3);
  EXPECT_DOUBLE_EQ(estimate.value[0], 1.5);
  EXPECT_DOUBLE_EQ(estimate.value[1], 2);
  // √(Σ (v - mean)² / (G (G - 1)))
  EXPECT_DOUBLE_EQ(estimate.standard_error[0], std::sqrt((2.25 + 0.25 + 0.25 + 2.25) / 12));
  EXPECT_DOUBLE_EQ(estimate.standard_error[1], std::sqrt((1.0 + 1 + 16 + 4) / 12));
  ASSERT_EQ(estimate.by_length.size(), 2u);
  EXPECT_DOUBLE_EQ(estimate.by_length.at(2)[0], 1.5);
  EXPECT_DOUBLE_EQ(estimate.by_length.at(3)[1], 2);
  EXPECT_FALSE(estimate.reliable[0]);
}

TEST(GroupsFilm, CountsADarkGroupAsZeroWhereverItComes) {
  GroupsFilm first({2}), last({2});
  first.add_dark_group();
  first.add(group(3, 1), 2.0, 4);
  last.add(group(3, 1), 2.0, 4);
  last.add_dark_group();
  for (const std::size_t bin : {0u, 1u}) {
    EXPECT_DOUBLE_EQ(first.estimate().value[bin], last.estimate().value[bin]);
    EXPECT_DOUBLE_EQ(first.estimate().standard_error[bin], last.estimate().standard_error[bin]);
  }
  EXPECT_DOUBLE_EQ(first.estimate().value[0], 1.5);
}

TEST(GroupsFilm, HasNoErrorWithOneGroupAndTrustsNoBinWithFew) {
  GroupsFilm film({2});
  film.add(group(3, 1), 2.0, 4);
  EXPECT_TRUE(std::isnan(film.estimate().standard_error[0]));
  for (int g = 1; g < GroupsFilm::fewest_groups; ++g) {
    EXPECT_FALSE(film.estimate().reliable[0]);
    film.add(group(3, 1), 2.0, 4);
  }
  EXPECT_TRUE(film.estimate().reliable[0]);
}

TEST(GroupsFilm, TrustsABinOnlyWithEnoughEffectiveSamples) {
  GroupsFilm steady({2}), jumpy({2});
  for (int g = 0; g < 64; ++g) {
    steady.add(group(g % 2 == 0 ? 3 : 2, 1), 1.0, 4);
    jumpy.add(group(g == 0 ? 100 : 0, 0), 1.0, 4);
  }
  EXPECT_TRUE(steady.estimate().reliable[0]);
  EXPECT_FALSE(jumpy.estimate().reliable[0]);
  EXPECT_FALSE(jumpy.estimate().reliable[1]) << "what nothing reached may be dark or missed";
}

}  // namespace
}  // namespace wander::test::deposit_test

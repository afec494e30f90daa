// What decisions say that they would have seen (Decision::visible), they see with 99 %: an error of that
// size is planted again and again.  And a third of it is seldom seen, so it is not said too carefully.
//
// Each expects between 97.5 and 99.9 % of 2000 runs, where 99 % is expected: false alarms 1e-6.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "statistics/visible_error.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/generator.h"

namespace wander::test {
namespace {

constexpr int runs = 2000;
constexpr double alarm = 1e-6;

// The share of runs that reject where `plant(generator, error)` has an error of that size, relative.
using Planted = std::function<Decision(Generator&, double)>;
double rejected(const Planted& plant, std::uint64_t seed, double error) {
  Generator random(seed);
  int count = 0;
  for (int i = 0; i < runs; ++i) count += plant(random, error).passed ? 0 : 1;
  return static_cast<double>(count) / runs;
}

void expect_seen(const char* name, const Planted& plant, std::uint64_t seed) {
  Generator random(seed);
  double visible = 0;  // as a run says it, of the mean over a few
  for (int i = 0; i < 20; ++i) visible += plant(random, 0).visible / 20;
  const double power = rejected(plant, seed + 1, visible),
               third = rejected(plant, seed + 2, visible / 3);
  std::printf("  %-20s %8.3g %% would show: seen in %.1f %%, a third of it in %.1f %%\n", name,
              100 * visible, 100 * power, 100 * third);
  EXPECT_GT(power, 0.975) << name;
  EXPECT_LT(power, 0.999) << name;
  EXPECT_LT(third, 0.05) << name;
}

Moments sample(Generator& random, int count, double mean, double deviation) {
  Moments moments;
  for (int i = 0; i < count; ++i) moments.add(mean + deviation * random.normal());
  return moments;
}

TEST(Power, OfTestsOfAMean) {
  expect_seen(
      "z",
      [](Generator& g, double error) {
        return z_test(3 * (1 + error) + 0.1 * g.normal(), 0.1, 3, alarm);
      },
      1);
  expect_seen(
      "t",
      [](Generator& g, double error) {
        return t_test(sample(g, 400, 3 * (1 + error), 2), 3, alarm);
      },
      4);
  expect_seen(
      "paired t",
      [](Generator& g, double error) {
        std::vector<double> a, b;
        for (int i = 0; i < 400; ++i) {
          const double shared = 5 + 0.1 * g.normal();
          a.push_back(shared + 5 * error + 0.1 * g.normal());
          b.push_back(shared + 0.1 * g.normal());
        }
        return paired_t_test(a, b, alarm);
      },
      7);
  expect_seen(
      "Welch",
      [](Generator& g, double error) {
        return welch_test(sample(g, 300, 2 * (1 + error), 1), sample(g, 500, 2, 3), alarm);
      },
      10);
}

// One of ten bins is off.
TEST(Power, OfTestsOfManyBins) {
  const auto bins = [](Generator& g, double error) {
    std::vector<Moments> all;
    for (int j = 0; j < 10; ++j) all.push_back(sample(g, 300, j == 4 ? 2 * (1 + error) : 2, 1));
    return all;
  };
  expect_seen(
      "z of bins",
      [&](Generator& g, double error) {
        return bins_z_test(bins(g, error), std::vector<double>(10, 2.0), alarm);
      },
      13);
  expect_seen(
      "Welch of bins",
      [&](Generator& g, double error) {
        return bins_welch_test(bins(g, error), bins(g, 0), alarm);
      },
      16);
}

// One comparison of ten, whose errors are known and whose sizes differ; an eleventh has no size.
TEST(Power, OfFamiliesOfZ) {
  expect_seen(
      "z of a family",
      [](Generator& g, double error) {
        std::vector<Compared> family{{g.normal(), 1, 0}};
        for (int j = 0; j < 10; ++j) {
          const double size = 1 + j, spread = 0.1 * size, off = j == 4 ? error * size : 0;
          family.push_back({(off + spread * g.normal()) / spread, spread, size});
        }
        return largest_z_test(family, alarm);
      },
      25);
}

// Of two films of 64 groups one bin of ten is off; one that is not reliable counts for nothing.
TEST(Power, OfTheAgreementOfFilms) {
  constexpr int groups = 64;
  const auto film = [](Generator& g, double error) {
    FilmEstimate film;
    for (int j = 0; j < 11; ++j) {
      const Moments bin = sample(g, groups, j == 4 ? 3 * (1 + error) : 3, 1);
      film.value.push_back(bin.mean());
      film.standard_error.push_back(bin.standard_error());
      film.reliable.push_back(j < 10);
    }
    film.standard_error.back() *= 1e3;
    film.degrees_of_freedom = groups - 1;
    return film;
  };
  expect_seen(
      "films agree",
      [&](Generator& g, double error) { return films_agree(film(g, error), film(g, 0), alarm); },
      28);
}

// Where nothing has an error and a size, no error is known that would have been seen.
TEST(Power, OfAFamilyWithoutSizesIsNotKnown) {
  const std::vector<Compared> family{{1, 0.1, 0}, {0, 0, 2}};
  EXPECT_TRUE(std::isnan(largest_z_test(family, alarm).visible));
  EXPECT_TRUE(largest_z_test(family, alarm));
}

TEST(Power, OfTestsOfCounts) {
  expect_seen(
      "χ²",
      [](Generator& g, double error) {
        constexpr std::size_t cells = 20;
        std::vector<double> observed(cells), expected(cells, 1000);
        for (int i = 0; i < 20'000; ++i) {
          const auto pair = static_cast<std::size_t>(g.uniform() * cells / 2);
          ++observed[2 * pair + (g.uniform() < (1 + error) / 2 ? 0 : 1)];
        }
        return chi_square_test(observed, expected, alarm);
      },
      19);
  expect_seen(
      "binomial",
      [](Generator& g, double error) {
        std::uint64_t successes = 0;
        for (int i = 0; i < 2000; ++i) successes += g.uniform() < 0.4 * (1 + error) ? 1 : 0;
        return binomial_test(successes, 2000, 0.4, alarm);
      },
      22);
}

}  // namespace
}  // namespace wander::test

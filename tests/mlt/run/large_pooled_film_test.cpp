// The error bars of a large pooled film against their definition: each film of chains is left out once, and all is
// made anew.  Exact; nothing is drawn.
#include "mlt/run/large_pooled_film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <numeric>
#include <vector>

namespace wander::test {
namespace large_pooled_films {
namespace {

constexpr std::size_t bins = 300, films = 4;  // more than a tile
constexpr int vertices = 2;
constexpr FilmLayout layout{.most_small = bins};  // has few pixels: a film for each group
using Film = std::array<double, bins>;

// Eighths, from 1/8 to 8: exact in float, and without a rule.
double number(std::size_t k) {
  return static_cast<double>(k * 2654435761u % 4294967296u >> 26) / 8 + 0.125;
}

// What chains of each group deposited: in all, and their part.
std::array<Film, films> deposits(std::size_t kind) {
  std::array<Film, films> all{};
  for (std::size_t g = 0; g < films; ++g)
    for (std::size_t j = 0; j < bins; ++j)
      all[g][j] = number(j * films + g + 1) / (kind == 0 ? 1 : 1 << (j + g) % 3);
  return all;
}
const std::array<Film, films> all = deposits(0), hard = deposits(1);
// What samples brought of theirs, one path for every fifth bin.
std::array<Film, 5> paths() {
  std::array<Film, 5> found{};
  for (std::size_t j = 0; j < bins; ++j) found[j % 5][j] = number(j + 7777);
  return found;
}
const std::array<Film, 5> samples = paths();
// b, and what it is without each group.
constexpr double b = 2;
constexpr std::array<double, films> b_without{2.25, 1.75, 1.875, 2.125};

double sum(const Film& film) { return std::accumulate(film.begin(), film.end(), 0.0); }

struct Found {
  Found() {
    LargeSampleFilm::Part list(bins, vertices, layout);
    for (const Film& sample : samples) {
      Contributions found;
      for (std::size_t j = 0; j < bins; ++j)
        if (sample[j] > 0) found.push_back({vertices, 0, static_cast<int>(j), sample[j]});
      list.add(found);
    }
    of_samples.merge(list);
    for (std::size_t g = 0; g < films; ++g) {
      GroupFilm& film = of_groups.emplace_back(static_cast<int>(bins), vertices);
      for (std::size_t j = 0; j < bins; ++j) {
        film.add(vertices, static_cast<int>(j), all[g][j]);
        of_chains[static_cast<int>(g)].add(vertices, static_cast<int>(j), hard[g][j]);
      }
      groups.push_back({nullptr, nullptr, nullptr, &film, {}, 1});
    }
  }
  PooledFilm film() const {
    SharedLight light{&of_chains, 1};
    light.samples = &of_samples;
    const Constant constant{.b = {.value = b}, .without = {b_without.begin(), b_without.end()}};
    return pooled_film(std::array{light}, groups, constant, {static_cast<int>(bins)});
  }

  SharedFilms of_chains{std::array{static_cast<int>(bins)}, vertices, static_cast<int>(films),
                        layout};
  LargeSampleFilm of_samples{static_cast<int>(bins), vertices, layout};
  std::deque<GroupFilm> of_groups;
  std::vector<GroupFindings> groups;
};

// The film's two parts without one film of chains, or with all: E_j, and b S_j; over bins.
struct Parts {
  Film easy{}, hard{};
  double whole() const { return sum(easy) + sum(hard); }
};
Parts parts(std::size_t without, double constant) {
  Parts of;
  double mass = 0;
  for (std::size_t g = 0; g < films; ++g)
    if (g != without) mass += sum(all[g]);
  for (std::size_t j = 0; j < bins; ++j) {
    for (const Film& sample : samples) of.easy[j] += sample[j] / samples.size();
    for (std::size_t g = 0; g < films; ++g)
      if (g != without) of.hard[j] += constant * hard[g][j] / mass;
  }
  return of;
}
// s (E_j + b S_j), of which the mean is b.
Film recounted(std::size_t without, double constant) {
  const Parts of = parts(without, constant);
  Film film{};
  for (std::size_t j = 0; j < bins; ++j)
    film[j] = bins * constant / of.whole() * (of.easy[j] + of.hard[j]);
  return film;
}

double variance_of_samples(std::size_t j) {
  const double n = samples.size();
  double mean = 0, squares = 0;
  for (const Film& sample : samples) mean += sample[j] / n;
  for (const Film& sample : samples) squares += (sample[j] - mean) * (sample[j] - mean);
  return squares / n / (n - 1);
}

TEST(LargePooledFilms, HaveTheErrorOfFilmsLeftOut) {
  const Found found;
  const PooledFilm film = found.film();
  const Film whole = recounted(films, b);
  const Parts of_all = parts(films, b);
  const double s = b / of_all.whole();
  std::array<Film, films> without{};
  for (std::size_t f = 0; f < films; ++f) without[f] = recounted(f, b_without[f]);
  EXPECT_NEAR(film.light_of_samples, sum(of_all.easy) / of_all.whole(), 1e-12);
  for (std::size_t j = 0; j < bins; ++j) {
    double mean = 0, squares = 0;
    for (const Film& of : without) mean += of[j] / films;
    for (const Film& of : without) squares += (of[j] - mean) * (of[j] - mean);
    const double error =
        std::sqrt((films - 1.) / films * squares + bins * bins * s * s * variance_of_samples(j));
    EXPECT_NEAR(film.film.value[j], whole[j], 1e-10) << j;
    EXPECT_NEAR(film.film.standard_error[j], error, 1e-10) << j;
  }
}

}  // namespace
}  // namespace large_pooled_films
}  // namespace wander::test

// The seed pass: an unbiased b, and seeds drawn in proportion to w f/p, which are made again from
// their random numbers bit for bit.
#include "mlt/seeds/seed_pass.h"

#include <gtest/gtest.h>

#include <map>

#include "lab/render.h"
#include "mlt/run/normalization.h"
#include "mutations/catalogue.h"
#include "tests/support/expect.h"
#include "tests/support/path_equality.h"
#include "tests/support/test_scenes.h"
#include "work/session.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// A path of a slice: what a seed must be one of.
struct Found {
  std::uint64_t sample;
  int technique;
  Path<W> path;
  double weight;
};

// The paths of a slice, by the sampler itself, as the chains' space measures them.
std::vector<Found> paths_of_slice(const Flat& space, std::uint64_t seed, int group,
                                  std::uint64_t samples) {
  PathSampler<Flat> sampler(space.with(Roulette::by_albedo), all_techniques, Heuristic::balance);
  Rng random(seed, Purpose::seed_pass, static_cast<std::uint32_t>(group));
  std::vector<Found> found;
  for (std::uint64_t i = 0; i < samples; ++i) {
    random.start(i);
    sampler.sample(random, [&](const Path<W>& x, int s, double weight) {
      found.push_back({i, s, x, weight});
      for (int k = 0; k < x.size(); ++k) space.evaluate(found.back().path, k);
    });
  }
  return found;
}

class SeedPass : public ::testing::TestWithParam<int> {
 protected:
  FlatScene scene_ = build(lit_scenes()[static_cast<std::size_t>(GetParam())].scene);
  Flat space_{*scene_, Roulette::off};
};
INSTANTIATE_TEST_SUITE_P(Rooms, SeedPass,
                         ::testing::Range(0, static_cast<int>(lit_scenes().size())));

// Given the slice, each chain's seed is an independent draw among its paths, of probability w/Σw.
// False alarms: 1e-9 per scene.
TEST_P(SeedPass, SeedsAreDrawnInProportionToTheirWeights) {
  constexpr int chains = 20'000;
  constexpr std::uint64_t samples = 200;
  const std::vector<Found> found = paths_of_slice(space_, 7, 3, samples);
  double total = 0;
  for (const Found& f : found) total += f.weight;

  using Cell =
      std::tuple<std::uint64_t, int, int, int>;  // fifth of the slice, n, s, half of the film
  const auto cell = [&](std::uint64_t sample, const Path<W>& x, int s) {
    return Cell(sample / 40, x.size(), s, space_.bin(x) * 2 / scene_->bins());
  };
  std::map<Cell, std::pair<double, double>> cells;  // observed, expected
  std::map<std::tuple<std::uint64_t, int, int>, Cell> cell_of_seed;
  for (const Found& f : found) {
    const Cell c = cell(f.sample, f.path, f.technique);
    cells[c].second += chains * f.weight / total;
    cell_of_seed[{f.sample, f.path.size(), f.technique}] = c;
  }
  SeedSlice<Flat> slice(space_, 7, 3, chains);
  slice.run(samples);
  for (int k = 0; k < chains; ++k) {
    const Seed& seed = slice.seed(k);
    cells[cell_of_seed.at({seed.sample, seed.vertices, seed.technique})].first += 1;
  }
  std::vector<double> observed, expected;
  for (const auto& [key, counts] : cells) {
    observed.push_back(counts.first);
    expected.push_back(counts.second);
  }
  EXPECT_GT(cells.size(), std::size_t{40});
  EXPECT_TRUE(passes(chi_square_test(observed, expected, usual_false_alarm)));

  // A twin that draws all paths alike is caught.
  for (auto& [key, counts] : cells) counts.second = 0;
  for (const Found& f : found)
    cells[cell(f.sample, f.path, f.technique)].second += chains / static_cast<double>(found.size());
  expected.clear();
  for (const auto& [key, counts] : cells) expected.push_back(counts.second);
  EXPECT_TRUE(rejects(chi_square_test(observed, expected, usual_false_alarm)));
}

TEST_P(SeedPass, AReplayedSeedIsTheSamePathBitForBit) {
  constexpr int chains = 200;
  constexpr std::uint64_t samples = 500;
  SeedSlice<Flat> slice(space_, 8, 1, chains);
  slice.run(samples);
  const std::vector<Found> found = paths_of_slice(space_, 8, 1, samples);
  for (int k = 0; k < chains; ++k) {
    const Seed& seed = slice.seed(k);
    Path<W> replayed = slice.replay(seed, space_.max_vertices());
    const auto original = std::find_if(found.begin(), found.end(), [&](const Found& f) {
      return f.sample == seed.sample && f.technique == seed.technique &&
             f.path.size() == seed.vertices;
    });
    ASSERT_NE(original, found.end());
    EXPECT_EQ(original->weight, seed.weight);
    EXPECT_TRUE(identical(replayed, original->path));
    weigh(space_, replayed);
    EXPECT_TRUE(replayed.contribution.is_positive());
    const Scaled ratio = replayed.contribution / replayed.intensity_under_roulette;
    EXPECT_NEAR(ratio.value() / seed.weight, 1, 1e-12) << "w f/p is l";
  }
}

TEST_P(SeedPass, ItsTallyIsTheSumOverItsPaths) {
  constexpr std::uint64_t samples = 2000;
  SeedSlice<Flat> slice(space_, 9, 0, 1);
  slice.run(samples / 2);
  slice.run(samples / 2);
  std::map<std::uint64_t, double> by_sample;
  std::map<int, double> by_length;
  std::map<std::pair<std::uint64_t, int>, double> by_sample_and_length;
  double total = 0, squares = 0;
  for (const Found& f : paths_of_slice(space_, 9, 0, samples)) {
    by_sample[f.sample] += f.weight;
    by_length[f.path.size()] += f.weight;
    by_sample_and_length[{f.sample, f.path.size()}] += f.weight;
    total += f.weight;
  }
  std::map<int, double> squares_by_length;
  for (const auto& [key, value] : by_sample_and_length)
    squares_by_length[key.second] += value * value;
  for (const auto& [sample, value] : by_sample) squares += value * value;
  const SeedTally& tally = slice.tally();
  EXPECT_EQ(tally.samples, samples);
  EXPECT_NEAR(tally.mean(), total / samples, 1e-12 * total / samples);
  EXPECT_NEAR(tally.effective_samples(), total * total / squares, 1e-9 * samples);
  for (const auto& [vertices, value] : by_length)
    EXPECT_NEAR(tally.sum[static_cast<std::size_t>(vertices) - 2].value(), value, 1e-12 * total);

  // b and its standard error: the mean of independent samples.
  const Normalization b = normalization(tally);
  const double n = samples, mean = total / n;
  EXPECT_NEAR(b.value, mean, 1e-12 * mean);
  EXPECT_NEAR(b.standard_error, std::sqrt((squares / n - mean * mean) / (n - 1)), 1e-9 * mean);
  ASSERT_EQ(b.by_length.size(), by_length.size());
  for (const LengthShare& share : b.by_length) {
    const double m = by_length.at(share.vertices) / n;
    const double m2 = squares_by_length.at(share.vertices) / n;
    EXPECT_NEAR(share.value, m, 1e-12 * mean);
    EXPECT_NEAR(share.standard_error, std::sqrt((m2 - m * m) / (n - 1)), 1e-9 * mean);
  }
}

// The seeds of a group are reservoirs, filled with the numbers of its own stream [Chao 1982].
TEST_P(SeedPass, AGroupChoosesItsSeedsWithItsOwnNumbers) {
  constexpr int chains = 5;
  for (const int group : {0, 3}) {
    std::array<Seed, chains> expected;
    std::array<double, chains> ends{};
    Rng random(10, Purpose::resample, static_cast<std::uint32_t>(group));
    Sum total;
    std::uint64_t sample = ~std::uint64_t{0};
    for (const Found& f : paths_of_slice(space_, 10, group, 400)) {
      if (f.sample != sample) random.start(sample = f.sample);
      total += f.weight;
      for (std::size_t k = 0; k < chains; ++k) {
        if (total.value() <= ends[k]) continue;
        expected[k] = {f.sample, f.path.size(), f.technique, f.weight};
        ends[k] = total.value() / (1 - random.uniform());
      }
    }
    SeedSlice<Flat> slice(space_, 10, group, chains);
    slice.run(400);
    for (int k = 0; k < chains; ++k) {
      const Seed& seed = slice.seed(k);
      const Seed& by_hand = expected[static_cast<std::size_t>(k)];
      EXPECT_EQ(seed.sample, by_hand.sample) << "group " << group << ", chain " << k;
      EXPECT_EQ(seed.technique, by_hand.technique);
      EXPECT_EQ(seed.weight, by_hand.weight);
    }
  }
}

TEST(SeedTally, OfTwoSlicesIsTheTallyOfAllTheirSamples) {
  SeedTally tally(4), other(4);
  tally.samples = 3, other.samples = 5;
  tally.rays = 40, other.rays = 70;
  tally.total += 4, tally.total_squares += 10;
  other.total += 2, other.total_squares += 8;
  tally.sum[1] += 4, tally.squares[1] += 10;
  other.sum[1] += 2, other.squares[1] += 8;
  tally.merge(other);
  EXPECT_EQ(tally.samples, 8u);
  EXPECT_EQ(tally.rays, 110u);
  EXPECT_EQ(tally.mean(), 6.0 / 8);
  EXPECT_EQ(tally.effective_samples(), 36.0 / 18);
  EXPECT_EQ(tally.sum[1].value(), 6);
  EXPECT_EQ(tally.squares[1].value(), 18);
}

// 64 samples cannot carry a hundred effective ones.
TEST(StarvedSeedPass, LeavesNoErrorBarTrusted) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  const Family family = make_family({}, space.max_vertices());
  Session session;
  session.budget = SampleBudget{100'000};
  const auto run = [&](std::uint64_t seeds) {
    return ChainRenderer(space, family, session,
                         ChainSettings{.seed_share = 0, .fewest_seeds = seeds})
        .render("mlt");
  };
  const Rendering starved = run(64), fed = run(4096);
  EXPECT_EQ(std::ranges::count(starved.film.reliable, true), 0);
  EXPECT_FALSE(starved.warnings.empty());
  EXPECT_GT(std::ranges::count(fed.film.reliable, true), 0);
}

TEST(SeedReplay, ASeedThatIsNotInTheSliceIsRefused) {
  const FlatScene scene = build(diffuse_room());
  const Flat space(*scene, Roulette::off);
  SeedSlice<Flat> slice(space, 8, 1, 1);
  slice.run(100);
  Seed seed = slice.seed(0);
  seed.weight = std::nextafter(seed.weight, 0.0);
  EXPECT_THROW(slice.replay(seed, space.max_vertices()), SeedReplayError);
}

TEST(DarkRoom, NoSeedIsFoundAndTheRunSaysSo) {
  const FlatScene scene = build(dark_room());
  const Flat space(*scene, Roulette::off);
  SeedSlice<Flat> slice(space, 1, 0, 4);
  slice.run(1000);
  EXPECT_FALSE(slice.found_light());
  EXPECT_EQ(slice.tally().samples, 1000u);
  EXPECT_EQ(slice.tally().mean(), 0);
  EXPECT_EQ(slice.tally().effective_samples(), 0);

  Session session;
  session.budget = SampleBudget{1000};
  const Family family = make_family({}, space.max_vertices());
  ChainRenderer renderer(space, family, session, ChainSettings{});
  EXPECT_THROW(renderer.render("mlt"), NoLightFound);
}

}  // namespace
}  // namespace wander::test

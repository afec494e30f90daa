// A film whose bins are not reliable for light that its techniques seldom find says so, and of which.
#include "lab/sample_doubts.h"

#include <gtest/gtest.h>

#include <array>

#include "core/film_statistics.h"

namespace wander::test::sample_doubts_test {
namespace {

constexpr std::array shape{2};

// Two bins that are well seen by (2, 1), and light that (4, 2) brought four times to each, (5, 0) once to the second.
SampleFilm film_seen(double rare) {
  SampleFilm film(2, 5);
  for (int i = 0; i < 400; ++i) film.add({{2, 1, i % 2, i % 4 < 2 ? 1.0 : 3.0}});
  for (int i = 0; i < 8; ++i) film.add({{4, 2, i % 2, rare}});
  film.add({{5, 0, 1, rare / 2}});
  return film;
}

std::string said_of(const SampleFilm& film) {
  const FilmEstimate estimate = film.estimate(shape);
  return rare_techniques(film.techniques(), estimate, film.samples());
}

// Σ x of a bin has a standard error of √(603 + 4 rare²) or so; its part of the rare light, 4.25 rare, may be half of it.
TEST(RareTechniques, AreToldWhereTheyTakeTheTrustFromMostBins) {
  const SampleFilm dim = film_seen(2), bright = film_seen(4);
  EXPECT_EQ(said_of(dim), "");
  EXPECT_EQ(reliable_bins(dim.estimate(shape)), 2u);
  EXPECT_EQ(reliable_bins(bright.estimate(shape)), 0u);
  const std::string said = said_of(bright);
  EXPECT_TRUE(
      said.starts_with("2 of 2 bins that samples enough have found cannot be called reliable: "))
      << said;
  EXPECT_NE(said.find("most of it (4, 2), (5, 0), carry 4.08 % of the film"), std::string::npos)
      << said;
}

// Bins that are not reliable for want of samples alone say nothing of techniques.
TEST(RareTechniques, AreNotBlamedForBinsOfFewSamples) {
  SampleFilm film(8, 5);
  for (int i = 0; i < 640; ++i) film.add({{2, 1, i % 8, i % 16 < 8 ? 1.0 : 3.0}});
  film.add({{4, 2, 0, 40}});
  const FilmEstimate estimate = film.estimate(std::array{8});
  EXPECT_EQ(reliable_bins(estimate), 0u);
  const DoubtedBins bins = doubted_bins(estimate, film.techniques(), film.samples());
  EXPECT_EQ(bins.seen, 0u);
  EXPECT_EQ(rare_techniques(film.techniques(), estimate, film.samples()), "");
}

// Where the bins around a bin take its trust, that too is for light that was seldom found: of nine bins the last has met such light
// twice, so that by its events none is reliable, and the others, well seen each for itself, would say nothing.
TEST(RareTechniques, AreToldWhereTheBinsAroundTakeTheTrustFirst) {
  SampleFilm film(9, 5);
  for (int i = 0; i < 1800; ++i) film.add({{2, 1, i % 9, i % 18 < 9 ? 1.0 : 3.0}});
  for (int i = 0; i < 2; ++i) film.add({{4, 2, 8, 100}});
  const FilmEstimate estimate = film.estimate(std::array{9});
  EXPECT_EQ(reliable_bins(estimate), 0u);
  const DoubtedBins bins = doubted_bins(estimate, film.techniques(), film.samples());
  EXPECT_EQ(bins.seen, 8u);
  EXPECT_EQ(bins.doubtful, 8u);
  EXPECT_NE(rare_techniques(film.techniques(), estimate, film.samples()), "");
}

// What was met: so often a lamp by s = 0, and a sensor by t = 0, of so many vertices.
struct Met {
  int vertices, lamps, sensors;
};
bool doubted(Met met, MetByChance end, double lobe = 0) {
  SampleFilm film = film_seen(0);
  for (int i = 0; i < met.lamps; ++i) film.add({{met.vertices, 0, i % 2, 0.01}});
  for (int i = 0; i < met.sensors; ++i) film.add({{met.vertices, met.vertices, i % 2, 0.01}});
  Rendering rendering{.method = "pt", .samples = film.samples(), .film = film.estimate(shape)};
  add_doubts(rendering, film.techniques(), {end, lobe});
  EXPECT_EQ(reliable_bins(rendering.film), rendering.warnings.empty() ? 2u : 0u);
  return !rendering.warnings.empty();
}

// Five effective hits are as many as the rule for rare techniques can judge by.
TEST(SampleDoubts, NoBinIsReliableWhereNoLampWasMetThatHadToBe) {
  EXPECT_TRUE(doubted({3, 0, 0}, MetByChance::lights));
  EXPECT_TRUE(doubted({3, 4, 9}, MetByChance::lights));
  EXPECT_FALSE(doubted({3, 5, 0}, MetByChance::lights));
  EXPECT_TRUE(doubted({2, 9, 0}, MetByChance::lights)) << "no mirror is between two vertices";
  EXPECT_FALSE(doubted({3, 0, 0}, MetByChance::nowhere));
}

TEST(SampleDoubts, NoBinIsReliableWhereNoSensorWasMetThatHadToBe) {
  EXPECT_TRUE(doubted({3, 9, 4}, MetByChance::sensors));
  EXPECT_FALSE(doubted({3, 0, 5}, MetByChance::sensors));
  EXPECT_TRUE(doubted({2, 0, 9}, MetByChance::sensors));
}

TEST(SampleDoubts, NoBinIsReliableWhereNeitherEndWasMetAndOneHadToBe) {
  EXPECT_TRUE(doubted({3, 2, 2}, MetByChance::either));
  EXPECT_FALSE(doubted({3, 5, 0}, MetByChance::either));
  EXPECT_FALSE(doubted({4, 0, 5}, MetByChance::either));
}

TEST(RareTechniques, AreNoMatterOfAFilmWithoutLight) {
  SampleFilm dark(2, 5);
  dark.add(Contributions{});
  EXPECT_EQ(said_of(dark), "");
}

// A film of 409 samples: of those to a lobe of a fortieth of all directions ten find it.
TEST(SampleDoubts, AreNoneWhereConnectionsToNarrowLobesFindTheLight) {
  for (const MetByChance end :
       {MetByChance::lights, MetByChance::sensors, MetByChance::either, MetByChance::camera}) {
    EXPECT_TRUE(doubted({3, 0, 0}, end, 0.0244));
    EXPECT_FALSE(doubted({3, 0, 0}, end, 0.0245));
  }
  EXPECT_TRUE(doubted({3, 9, 9}, MetByChance::camera, 1e-6)) << "no light subpath meets it";
  EXPECT_FALSE(doubted({3, 9, 9}, MetByChance::lights, 1e-6));
}

}  // namespace
}  // namespace wander::test::sample_doubts_test

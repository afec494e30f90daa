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
  return rare_techniques(film.techniques(), film.estimate(shape), film.samples());
}

// Σ x of a bin has a standard error of √(603 + 4 rare²) or so; its part of the rare light, 4.25 rare, may be half of it.
TEST(RareTechniques, AreToldWhereTheyTakeTheTrustFromMostBins) {
  const SampleFilm dim = film_seen(2), bright = film_seen(4);
  EXPECT_EQ(said_of(dim), "");
  EXPECT_EQ(reliable_bins(dim.estimate(shape)), 2u);
  EXPECT_EQ(reliable_bins(bright.estimate(shape)), 0u);
  const std::string said = said_of(bright);
  EXPECT_TRUE(said.starts_with("2 of 2 lit bins cannot be called reliable: ")) << said;
  EXPECT_NE(said.find("most of it (4, 2), (5, 0), carry 4.08 % of the film"), std::string::npos)
      << said;
}

// Five effective hits are as many as the rule for rare techniques can judge by.
TEST(SampleDoubts, NoBinIsReliableWhereNoLampWasMetThatHadToBe) {
  const auto doubted = [](int hits, LightByMirrors mirrors) {
    SampleFilm film = film_seen(0);
    for (int i = 0; i < hits; ++i) film.add({{3, 0, i % 2, 0.01}});
    Rendering rendering{.method = "pt", .samples = film.samples(), .film = film.estimate(shape)};
    add_doubts(rendering, film.techniques(), mirrors);
    EXPECT_EQ(reliable_bins(rendering.film), rendering.warnings.empty() ? 2u : 0u);
    return !rendering.warnings.empty();
  };
  EXPECT_TRUE(doubted(0, LightByMirrors::by_chance));
  EXPECT_TRUE(doubted(4, LightByMirrors::by_chance));
  EXPECT_FALSE(doubted(5, LightByMirrors::by_chance));
  EXPECT_FALSE(doubted(0, LightByMirrors::connected));
}

TEST(RareTechniques, AreNoMatterOfAFilmWithoutLight) {
  SampleFilm dark(2, 5);
  dark.add(Contributions{});
  EXPECT_EQ(said_of(dark), "");
}

}  // namespace
}  // namespace wander::test::sample_doubts_test

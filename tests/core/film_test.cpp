// Films of independent samples: values, error bars and reliability, from numbers small enough to
// work out by hand.
#include "core/film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace wander::test {
namespace {

constexpr std::array two_bins{2};

// What four samples contribute, as (vertices, technique, bin, contribution): one meets a bin twice,
// one meets nothing.
struct Contribution {
  int vertices, technique, bin;
  double value;
};
const std::vector<std::vector<Contribution>> four_samples{
    {{2, 0, 0, 1}, {3, 1, 0, 2}}, {{2, 0, 1, 4}}, {}, {{3, 2, 0, 1}}};

void add(SampleFilm& film, const std::vector<Contribution>& sample) {
  for (const Contribution& c : sample) film.add(c.vertices, c.technique, c.bin, c.value);
  film.end_sample();
}

// Σ x and Σ x² over samples are 4, 10 in the first bin and 4, 16 in the second; a value is
// bins Σ/n, its variance bins² (Σ x² - (Σ x)²/n) / (n (n - 1)).
void expect_four_samples(const FilmEstimate& film) {
  EXPECT_EQ(film.shape, std::vector{2});
  EXPECT_EQ(film.value, (std::vector<double>{2, 2}));
  EXPECT_DOUBLE_EQ(film.standard_error[0], std::sqrt(4 * (10 - 4.0) / (4 * 3)));
  EXPECT_DOUBLE_EQ(film.standard_error[1], std::sqrt(4 * (16 - 4.0) / (4 * 3)));
  EXPECT_EQ(film.degrees_of_freedom, 3);
  ASSERT_EQ(film.by_length.size(), 2u);
  EXPECT_EQ(film.by_length.at(2), (std::vector{0.5, 2.0}));
  EXPECT_EQ(film.by_length.at(3), (std::vector{1.5, 0.0}));
}

TEST(SampleFilm, IsTheMeanOfItsSamplesWithTheErrorOfAMean) {
  SampleFilm film(2, 5);
  for (const auto& sample : four_samples) add(film, sample);
  EXPECT_EQ(film.samples(), 4u);
  expect_four_samples(film.estimate(two_bins));
}

TEST(SampleFilm, MergedOrUsedAgainIsTheFilmOfItsSamples) {
  SampleFilm whole(2, 5), part(2, 5);
  for (const auto& sample : four_samples) {
    part.clear();
    add(part, sample);
    whole.merge(part);
  }
  EXPECT_EQ(whole.samples(), 4u);
  expect_four_samples(whole.estimate(two_bins));
}

TEST(SampleFilm, HasNoErrorWithOneSampleAndNoLightWithNone) {
  SampleFilm film(2, 5);
  EXPECT_EQ(film.estimate(two_bins).value, (std::vector<double>{0, 0}));
  add(film, four_samples[0]);
  EXPECT_TRUE(std::isnan(film.estimate(two_bins).standard_error[0]));
}

// Of 200 samples all meet the first bin, with 1 and 3 in turn, and `seen` the second.
SampleFilm film_seen(int seen) {
  SampleFilm film(2, 5);
  for (int i = 0; i < 200; ++i) {
    film.add(2, 0, 0, i % 2 == 0 ? 1 : 3);
    if (i < seen) film.add(2, 1, 1, 1);
    film.end_sample();
  }
  return film;
}

// The rules by which bins are judged have tests of their own (reliability_test.cpp).  The second bin has samples of 1; those of
// the first weigh (1² + 3²)/(1 + 3), so that by both one weighs 1.75, and 60 of them, beside a brighter bin, are 105.
TEST(Reliability, NeedsEffectiveSamples) {
  EXPECT_EQ(film_seen(105).estimate(two_bins).reliable, (std::vector{true, true}));
  EXPECT_EQ(film_seen(104).estimate(two_bins).reliable, (std::vector{true, false}));
  EXPECT_EQ(film_seen(0).estimate(two_bins).reliable, (std::vector{true, false}));
}

// The variance of the first bin is 1, so Σ x has the standard error √200 = 14.1; light that a
// technique brought once may be half of that in each of the two bins.
TEST(Reliability, IsLostToLightOfTechniquesThatWereHardlySeen) {
  for (const double light : {13.0, 15.0}) {
    SampleFilm film = film_seen(199), rare(2, 5);
    rare.add(4, 2, 1, light);
    rare.end_sample();
    film.merge(rare);
    EXPECT_EQ(film.estimate(two_bins).reliable[0], light < std::sqrt(200)) << light;
  }
}

// In each nine bins of a film that has so many; where there are fewer, they are one neighbourhood.
TEST(Reliability, AsksHowOftenATechniqueIsSeenInANeighbourhood) {
  EXPECT_EQ(fewest_on_film(std::array{1}), 22.5);
  EXPECT_EQ(fewest_on_film(std::array{8}), 22.5);
  EXPECT_EQ(fewest_on_film(std::array{100}), 250);
  EXPECT_EQ(fewest_on_film(std::array{12, 16}), 480);
  EXPECT_EQ(fewest_on_film(std::array{12, 16, 3}), 480) << "of pixels";
}

TEST(TechniqueTally, TellsRareTechniquesByTheirEffectiveSamples) {
  TechniqueTally tally(5), other(5);
  for (int i = 0; i < 9; ++i) tally.add(3, 1, 2);
  tally.add(4, 1, 7);
  other.add(3, 1, 2);
  EXPECT_EQ(tally.rare_light(10), 25);
  tally.merge(other);
  EXPECT_EQ(tally.rare_light(10), 7);
  ASSERT_EQ(tally.rare(10).size(), 1u);
  EXPECT_EQ(tally.rare(10)[0].vertices, 4);
  EXPECT_EQ(tally.rare(10)[0].technique, 1);
  EXPECT_EQ(tally.rare(11).front().light, 20) << "the brightest first";
  tally.clear();
  EXPECT_EQ(tally.rare_light(10), 0);
}

// Six samples each: of the brightest alone there are fewer than ten, with the next 30²/78.
TEST(TechniqueTally, TellsRareTechniquesByHowManyTheyAreTogether) {
  TechniqueTally tally(5);
  for (int i = 0; i < 6; ++i)
    for (int s = 0; s < 3; ++s) tally.add(3, s, s + 1);
  EXPECT_EQ(tally.rare_light(10), 18);
  EXPECT_EQ(tally.rare(10).front().technique, 2);
  EXPECT_EQ(tally.rare_light(12), 18 + 12);
  EXPECT_EQ(tally.rare_light(6), 0);
}

}  // namespace
}  // namespace wander::test

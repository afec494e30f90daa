// Figures of films: intervals, marks of what is not to be trusted, layouts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "core/rng.h"
#include "draw/figure/film_figure.h"
#include "tests/draw/figure/figure_checks.h"

namespace wander::figure {
namespace {

LabelledFilm film(std::size_t bins, double value = 1) {
  LabelledFilm result{"bdpt", {}};
  Rendering& run = result.rendering;
  run.method = "bdpt";
  run.samples = 1000000;
  run.film.shape = {static_cast<int>(bins)};
  run.film.degrees_of_freedom = 31;
  for (std::size_t k = 0; k < bins; ++k) {
    run.film.value.push_back(value * (1 + 0.5 * std::sin(static_cast<double>(k))));
    run.film.standard_error.push_back(0.05 * value);
    run.film.reliable.push_back(true);
  }
  return result;
}

FilmFigureOptions options() {
  return {.title = "", .axes = film_axes(room()), .inset = {}, .reference = {}};
}

TEST(FilmFigure, IsWellFormedAndTheSameEveryTimeInEveryLayout) {
  FilmFigureOptions how = options();
  how.title = "<&>";
  how.inset = room();
  how.reference = film(20);
  for (const Layout layout : {Layout::automatic, Layout::overlay, Layout::panels}) {
    how.layout = layout;
    const std::string svg = film_figure({film(20), film(10), film(40)}, how);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(svg, film_figure({film(20), film(10), film(40)}, how));
  }
}

TEST(FilmFigure, AxesHaveUnits) {
  EXPECT_NE(film_figure({film(20)}, options()).find(">position on the sensor, m<"),
            std::string::npos);
  EXPECT_NE(film_figure({film(20)}, options()).find(">mean irradiance, W/m<"), std::string::npos);
  d::Scene scene = room();
  scene.shapes.pop_back();
  scene.camera = d::Camera{{0, 0}, {1, 0}, {}, 90, {10}, 0, {}};
  FilmFigureOptions how = options();
  how.axes = film_axes(scene);
  EXPECT_NE(film_figure({film(20)}, how).find(">mean radiance, W/(m·rad)<"), std::string::npos);
}

TEST(FilmFigure, MarksUnreliableBinsAndSaysSo) {
  EXPECT_EQ(count(film_figure({film(20)}, options()), "unreliable"), 0u);
  LabelledFilm partly = film(20);
  partly.rendering.film.reliable[7] = false;
  const std::string svg = film_figure({partly}, options());
  EXPECT_EQ(count(svg, "class=\"band unreliable\""), 1u);
  EXPECT_EQ(count(svg, "class=\"band\""), 2u);        // to its left and to its right
  EXPECT_GE(count(svg, "class=\"unreliable\""), 2u);  // the bin and its sample in the legend
  EXPECT_EQ(count(svg, ">unreliable bin<"), 1u);
}

TEST(FilmFigure, ABinWithoutAStandardErrorIsUnreliable) {
  LabelledFilm partly = film(20);
  partly.rendering.film.standard_error[3] = nan;
  EXPECT_EQ(count(film_figure({partly}, options()), ">unreliable bin<"), 1u);
}

TEST(FilmFigure, OneFireflyDoesNotFlattenTheFilm) {
  LabelledFilm noisy = film(20);
  noisy.rendering.film.value[4] = 1e6;
  noisy.rendering.film.standard_error[4] = 1e6;
  noisy.rendering.film.reliable[4] = false;
  const std::vector<std::vector<Bar>> bars{bars_of(noisy.rendering.film, {0, 1})};
  EXPECT_LT(value_range(bars, {}).high, 3);
  const std::string svg = film_figure({noisy}, options());
  EXPECT_EQ(count(svg, "class=\"beyond\""), 2u);  // at the edge and in the legend
  EXPECT_EQ(count(svg, ">beyond the axis, up to 1000000 W/m<"), 1u);
}

TEST(FilmFigure, TheReferenceAloneDoesNotSetTheAxis) {
  LabelledFilm rough = film(20);
  for (std::size_t k = 0; k < 20; ++k) rough.rendering.film.value[k] = k % 2 == 0 ? 0.5 : 1.5;
  rough.rendering.film.reliable.assign(20, false);
  const std::vector<Bar> reference = bars_of(film(20, 1).rendering.film, {0, 1});
  std::vector<std::vector<Bar>> bars{bars_of(rough.rendering.film, {0, 1})};
  EXPECT_GE(value_range(bars, reference).high, 1.5);
  EXPECT_LE(value_range(bars, reference).low, 0.5);
  // Values that are far too high are cut, so that the reference can be followed.
  for (Bar& bar : bars.front()) bar.value *= 100;
  EXPECT_LT(value_range(bars, reference).high, 3.5);
}

TEST(FilmFigure, WhatLiesBeyondTheAxisIsToldOnItsScale) {
  LabelledFilm dark = film(20, 1e-7);
  dark.rendering.film.value[4] = dark.rendering.film.standard_error[4] = 1.3912e-4;
  dark.rendering.film.reliable[4] = false;
  const std::string svg = film_figure({dark}, options());
  EXPECT_GE(count(svg, ", 10⁻⁹ W/m<"), 1u);
  EXPECT_EQ(count(svg, ">beyond the axis, up to 139000·10⁻⁹ W/m<"), 1u);
}

TEST(FilmFigure, BandsAre95PercentIntervals) {
  FilmEstimate estimate = film(1).rendering.film;
  estimate.degrees_of_freedom = 4;
  EXPECT_NEAR(*bars_of(estimate, {0, 1})[0].half_width, 2.776 * 0.05, 1e-4);
  estimate.degrees_of_freedom = 1e9;
  EXPECT_NEAR(*bars_of(estimate, {0, 1})[0].half_width, 1.960 * 0.05, 1e-4);
}

TEST(FilmFigure, MillionsOfBinsMakeASmallFigureThatSaysWhatAStepIs) {
  const LabelledFilm fine = film(1200000);
  const std::vector<Bar> bars = bars_of(fine.rendering.film, {0, 1});
  EXPECT_LE(bars.size(), most_bars);
  EXPECT_EQ(bars.front().position.low, 0);
  EXPECT_EQ(bars.back().position.high, 1);
  const std::string svg = film_figure({fine}, options());
  EXPECT_LT(svg.size(), 100000u);
  const std::smatch found = [&] {
    std::smatch match;
    std::regex_search(svg, match, std::regex("each step averages ([0-9]+) bins"));
    return match;
  }();
  ASSERT_FALSE(found.empty());
  // Steps are as wide as the eye can tell apart, on a panel of about 190 points.
  EXPECT_NEAR(1200000 / std::stod(found[1]), 190 / 0.8, 15);
}

TEST(FilmFigure, SurvivesFilmsOfZerosOfNothingKnownAndOfAnySize) {
  for (const double value : {0., 1e-30, 1e30, 1e300}) {
    LabelledFilm unknown = film(20, value);
    unknown.rendering.film.standard_error.assign(20, nan);
    unknown.rendering.film.reliable.assign(20, false);
    unknown.rendering.film.degrees_of_freedom = 0;
    EXPECT_TRUE(is_well_formed(film_figure({film(20, value), unknown}, options()))) << value;
    EXPECT_TRUE(is_well_formed(film_figure({unknown}, options()))) << value;
  }
  LabelledFilm nothing = film(20);
  nothing.rendering.film.value.assign(20, nan);
  EXPECT_TRUE(is_well_formed(film_figure({nothing}, options())));
}

std::size_t panels(const std::vector<LabelledFilm>& films, const FilmFigureOptions& how) {
  return count(film_figure(films, how), "<clipPath");
}

// As if estimated anew: independent noise about one smooth film.
LabelledFilm noisy(std::size_t bins, double noise, std::uint64_t seed) {
  LabelledFilm result = film(bins);
  Rng rng(seed, Purpose::test, 0);
  for (std::size_t k = 0; k < bins; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(bins);
    result.rendering.film.value[k] = 1 + 0.5 * std::sin(4 * x) + noise * (rng.uniform() - 0.5);
  }
  return result;
}

TEST(FilmFigure, AutomaticLayoutOverlaysTwoFilmsAndSeparatesMore) {
  EXPECT_EQ(panels({film(20), film(20)}, options()), 1u);
  EXPECT_EQ(panels({film(20), film(20), film(20)}, options()), 3u);
}

TEST(FilmFigure, AutomaticLayoutSeparatesTwoFilmsThatCannotBeFollowed) {
  for (const std::size_t bins : {16, 32, 256, 1000}) {
    const bool many = bins >= 256;
    EXPECT_EQ(panels({noisy(bins, 0.3, 1), noisy(bins, 0.3, 2)}, options()), many ? 2u : 1u)
        << bins;
    EXPECT_EQ(panels({noisy(bins, 0, 1), noisy(bins, 0, 2)}, options()), 1u) << bins;
  }
  // However noisy, films that lie apart can be told apart.
  LabelledFilm above = noisy(256, 0.3, 2);
  for (double& value : above.rendering.film.value) value += 2;
  EXPECT_EQ(panels({noisy(256, 0.3, 1), above}, options()), 1u);
}

TEST(FilmFigure, AnyLayoutCanBeForced) {
  FilmFigureOptions how = options();
  how.layout = Layout::overlay;
  EXPECT_EQ(panels({noisy(1000, 0.3, 1), noisy(1000, 0.3, 2), film(20)}, how), 1u);
  how.layout = Layout::panels;
  EXPECT_EQ(panels({film(20), film(20)}, how), 2u);
}

TEST(FilmFigure, PanelsShareTheirAxesAndEachHasTheReference) {
  FilmFigureOptions how = options();
  how.reference = film(20);
  const std::string svg =
      film_figure({noisy(256, 0.3, 1), noisy(256, 0.3, 2), noisy(256, 0.3, 3)}, how);
  EXPECT_EQ(count(svg, "stroke-width=\"0.6\" stroke-dasharray=\"none\""), 3u + 1u);  // the legend
}

TEST(FilmFigure, ALogarithmicAxisHoldsWhatIsAboveZero) {
  LabelledFilm deep = film(20);
  for (std::size_t k = 0; k < 20; ++k)
    deep.rendering.film.value[k] = k == 0 ? 0 : std::pow(10, -static_cast<double>(k) / 4);
  FilmFigureOptions how = options();
  how.values = Spacing::logarithmic;
  const std::string svg = film_figure({deep}, how);
  EXPECT_TRUE(is_well_formed(svg));
  for (const char* label : {">1<", ">0.1<", ">0.01<", ">0.001<", ">0.0001<"})
    EXPECT_LE(count(svg, label), 1u) << label;
  EXPECT_EQ(count(svg, ">beyond the axis, down to 0 W/m<"), 1u);
  for (const double value : {0., -1., nan, 1e-300, 1e300})
    EXPECT_TRUE(is_well_formed(film_figure({film(20, value)}, how))) << value;
}

TEST(FilmFigure, OnANarrowPageTheSceneStandsAboveTheFilms) {
  FilmFigureOptions how = options();
  how.inset = room();
  how.width = 238;
  LabelledFilm named = film(20);
  named.label = "a name that takes so much room that it needs several lines of a narrow page";
  const std::string svg = film_figure({named, named, named}, how);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, "width=\"238pt\""), 1u);
  EXPECT_EQ(count(svg, "…"), 0u);  // nothing is cut
}

TEST(FilmFigure, SaysWhenARunWasInterrupted) {
  LabelledFilm part = film(20);
  part.rendering.complete = false;
  EXPECT_NE(film_figure({part}, options()).find(", interrupted<"), std::string::npos);
}

}  // namespace
}  // namespace wander::figure

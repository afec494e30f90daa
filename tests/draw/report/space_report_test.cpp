// The report of a comparison of images: pictures of one exposure, the parts where they differ, maps
// of their errors, in one file without scripts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/report/contender_image.h"
#include "draw/report/crops.h"
#include "draw/report/report.h"
#include "records/png.h"
#include "records/tone.h"
#include "tests/draw/report/report_checks.h"
#include "tests/support/images.h"
#include "tests/support/space_scene_text.h"

namespace wander::test {
namespace {

using compare::Comparison;
using compare::Runs;

Runs image_runs(int width, int height, int channels) {
  Runs runs;
  runs.budgets = {"1s", "2s"};
  runs.replicates = 3;
  runs.provenance.dimension = 3;
  runs.provenance.scene_text =
      channels == 3 ? coloured_room(width, height) : grey_room(width, height);
  runs.contenders = {{"mlt <1>", "mlt"}, {"bdpt", "bdpt"}};
  runs.details.resize(2);
  runs.reference.film = image_run(width, height, channels, 99).rendering.film;
  runs.reference.origin = "a longer run";
  std::uint64_t seed = 0;
  for (std::size_t r = 0; r < runs.replicates; ++r)
    for (std::size_t b = 0; b < 2; ++b)
      for (std::size_t c = 0; c < 2; ++c) {
        Rendering made = image_run(width, height, channels, ++seed).rendering;
        runs.runs.push_back(
            {c, b, r, seed, 1000 * (b + 1), 1. + static_cast<double>(b), 0, 0, made.film});
        if (r == 0 && b == 1) runs.details[c] = std::move(made);
      }
  return runs;
}

std::size_t with(const Page& page, const char* name, const char* attribute, const char* value) {
  return static_cast<std::size_t>(std::ranges::count_if(page.elements, [&](const Element& element) {
    const auto found = element.attributes.find(attribute);
    return element.name == name && found != element.attributes.end() && found->second == value;
  }));
}

TEST(SpaceReport, ShowsEveryContenderBesideTheReference) {
  for (const int channels : {1, 3}) {
    const std::string html = report_html(compare::summarize(image_runs(40, 30, channels)));
    expect_sound(html);
    EXPECT_EQ(html.find("<script"), html.npos);
    const Page page = read_page(html);
    EXPECT_EQ(with(page, "svg", "class", "store"), 3u);  // each picture once
    EXPECT_EQ(with(page, "div", "class", "crops"), 3u);
    EXPECT_EQ(with(page, "div", "class", "over"), 2u);  // one split for each contender
    EXPECT_EQ(with(page, "input", "type", "radio"), 6u);
    EXPECT_EQ(with(page, "use", "href", "#picture-2"), 3u);  // the reference: once, and in splits
    EXPECT_EQ(with(page, "svg", "aria-label", "film of mlt &lt;1&gt; at 2s"), 1u);
    for (const char* part : {"relMSE", "MAE", "W/(m²·sr)", "relative error of a pixel",
                             "z: difference / standard error of both", "all numbers together"})
      EXPECT_NE(html.find(part), html.npos) << part;
  }
}

// Noise is not compressed: pictures are made smaller before the page is too large.
TEST(SpaceReport, StaysSmallWhateverTheResolution) {
  Runs runs = image_runs(8, 6, 3);
  runs.provenance.scene_text = coloured_room(800, 600);
  runs.reference.film = image_run(800, 600, 3).rendering.film;
  for (compare::Run& run : runs.runs) run.film = runs.reference.film;
  for (Rendering& details : runs.details) details.film = runs.reference.film;
  EXPECT_LT(report_html(compare::summarize(runs)).size(), 4'500'000u);
}

// All pictures of a page have the exposure of the reference.
TEST(SpaceReport, HasOneExposure) {
  Runs runs = image_runs(20, 16, 1);
  const double white = white_of(runs.reference.film);
  for (compare::Run& run : runs.runs)
    for (double& x : run.film.value) x *= 100;
  const std::string html = report_html(compare::summarize(runs));
  EXPECT_NE(html.find(fmt::format("white is a luminance of {:.3g}", white)), html.npos);
  const std::string saturated =
      png_address(to_png(std::vector<std::uint8_t>(20 * 16, 255), 20, 16, 1));
  EXPECT_NE(html.find("id=\"picture-0\""), html.npos);
  EXPECT_NE(html.find(saturated), html.npos);
}

FilmEstimate even(int width, int height, double value) {
  FilmEstimate film{.shape = {height, width}};
  film.value.assign(static_cast<std::size_t>(width * height), value);
  film.standard_error.assign(film.value.size(), 0.01);
  film.reliable.assign(film.value.size(), true);
  film.degrees_of_freedom = 30;
  return film;
}

TEST(Crops, AreWhereTheContendersDiffer) {
  const FilmEstimate reference = even(64, 48, 0.5);
  FilmEstimate one = reference, other = reference;
  const auto at = [](std::size_t x, std::size_t y) { return y * 64 + x; };
  for (std::size_t y = 30; y < 40; ++y)
    for (std::size_t x = 44; x < 54; ++x) one.value[at(x, y)] = 0;
  for (std::size_t y = 2; y < 14; ++y)  // here both are wrong alike
    for (std::size_t x = 2; x < 14; ++x) one.value[at(x, y)] = other.value[at(x, y)] = 0;
  const std::vector<const FilmEstimate*> both{&one, &other};
  const auto crops = report::choose_crops(both, reference, 1, 3);
  ASSERT_EQ(crops.size(), 3u);
  EXPECT_LE(crops[0].x, 44u);
  EXPECT_GE(crops[0].x + crops[0].side, 54u);
  EXPECT_LE(crops[0].y, 30u);
  EXPECT_GE(crops[0].y + crops[0].side, 40u);
  const FilmEstimate part = report::cropped(one, crops[0]);
  EXPECT_EQ(part.shape, (std::vector<int>{12, 12}));
  EXPECT_EQ(std::ranges::count(part.value, 0.), 100);
  // A film alone is held against the reference.
  const std::vector<const FilmEstimate*> alone{&other};
  EXPECT_LT(report::choose_crops(alone, reference, 1, 1).at(0).x, 14u);
  EXPECT_TRUE(report::choose_crops({}, reference, 1, 3).empty());
}

TEST(ContenderImage, HasTheErrorsOfItsPixels) {
  Runs runs;
  runs.budgets = {"1s"};
  runs.replicates = 2;
  runs.provenance.dimension = 3;
  runs.provenance.scene_text = grey_room(4, 2);
  runs.contenders = {{"pt", "pt"}};
  runs.reference.film = even(4, 2, 2);
  runs.reference.film.value[7] = runs.reference.film.standard_error[7] = 0;
  for (std::size_t r = 0; r < 2; ++r) {
    runs.runs.push_back({0, 0, r, r + 1, 100, 1, 0, 0, even(4, 2, 2)});
    runs.runs.back().film.value[5] = r == 0 ? 3 : 2.5;
    runs.runs.back().film.value[6] = r == 0 ? 2.5 : 1.5;
    runs.runs.back().film.value[7] = 0;
  }
  const Comparison made = compare::summarize(runs);
  const auto image = report::image_of({made, report::scene_of(made)}, 0);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->run.replicate, 0u);
  EXPECT_TRUE(std::isnan(image->error.values[0])) << "the reference knows no more";
  EXPECT_EQ(image->error.values[7], 0) << "nothing is there, and nothing was found";
  const double size = 4 + 1e-4 * 1.75 * 1.75;
  EXPECT_NEAR(image->error.values[5], std::sqrt((0.625 - 1e-4) / size), 1e-12);
  EXPECT_EQ(image->z.values[0], 0);
  EXPECT_NEAR(image->z.values[5], 0.75 / std::sqrt(0.125 / 2 + 1e-4), 1e-9);
  EXPECT_EQ(image->z.values[6], 0);
}

}  // namespace
}  // namespace wander::test

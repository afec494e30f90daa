// Images as figures: the maps beside them, their colours and what is told of them.
#include "draw/figure/image_figure.h"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <png.h>

#include <cmath>

#include "draw/figure/image_maps.h"
#include "draw/figure/image_panel.h"
#include "records/tone.h"
#include "tests/draw/figure/figure_checks.h"
#include "tests/support/images.h"

namespace wander::figure {
namespace {

using test::image_run;

struct Picture {
  std::uint32_t width, height;
  std::vector<Rgb> pixels;
};

Picture decoded(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png_image_begin_read_from_memory(&png, bytes.data(), bytes.size());
  png.format = PNG_FORMAT_RGB;
  Picture picture{png.width, png.height, std::vector<Rgb>(std::size_t{png.width} * png.height)};
  png_image_finish_read(&png, nullptr, picture.pixels.data(), 0, nullptr);
  return picture;
}

// The images of a document in their order; every second one is the scale of the one before.
std::vector<Picture> images_in(const std::string& svg) {
  const std::string start = "data:image/png;base64,";
  std::vector<Picture> pictures;
  for (auto at = svg.find(start); at != std::string::npos; at = svg.find(start, at)) {
    at += start.size();
    const std::size_t end = svg.find('"', at);
    std::string bytes(3 * (end - at) / 4, '\0');
    EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                    reinterpret_cast<const unsigned char*>(svg.data() + at),
                    static_cast<int>(end - at));
    pictures.push_back(decoded(bytes));
  }
  return pictures;
}

// Of an image of so many columns, which may be enlarged.
Rgb pixel(const Picture& picture, std::size_t index, std::size_t columns) {
  const std::size_t times = picture.width / columns;
  const std::size_t x = index % columns * times + times / 2;
  const std::size_t y = index / columns * times + times / 2;
  return picture.pixels[y * picture.width + x];
}

// Two pixels in one row.
FilmEstimate two(double first, double second, double first_error, double second_error) {
  return {.shape = {1, 2},
          .value = {first, second},
          .standard_error = {first_error, second_error},
          .reliable = {true, true},
          .degrees_of_freedom = 100};
}

FilmEstimate coloured(std::vector<double> value, std::vector<double> error) {
  const int width = static_cast<int>(value.size() / 3);
  std::vector<bool> reliable(value.size(), true);
  return {.shape = {1, width, 3},
          .value = std::move(value),
          .standard_error = std::move(error),
          .reliable = std::move(reliable),
          .degrees_of_freedom = 100};
}

TEST(ImageMaps, HoldTheDifferenceInUnitsOfTheErrorOfBoth) {
  FilmEstimate a = two(5, 1, 3, 0.5);
  const FilmEstimate b = two(10, 1, 4, 0);
  const PixelMap map = difference_map(a, b);
  EXPECT_EQ(map.width, 2u);
  EXPECT_EQ(map.height, 1u);
  EXPECT_DOUBLE_EQ(map.values[0], -1);  // 5 of hypot(3, 4)
  EXPECT_EQ(map.values[1], 0);
  a.reliable[0] = false;
  EXPECT_TRUE(std::isnan(difference_map(a, b).values[0]));
  EXPECT_TRUE(std::isnan(difference_map(b, a).values[0]));
  a.standard_error[1] = not_known;
  a.value[1] = 2;
  EXPECT_TRUE(std::isnan(difference_map(a, b).values[1]));
}

TEST(ImageMaps, HoldTheErrorInUnitsOfTheValue) {
  const PixelMap map = relative_error_map(two(5, 0, 0.5, 0.1));
  EXPECT_DOUBLE_EQ(map.values[0], 0.1);
  EXPECT_TRUE(std::isnan(map.values[1]));
}

TEST(ImageMaps, TakeColoursByTheirLuminance) {
  const FilmEstimate a = coloured({1, 2, 3}, {0.1, 0, 0}), b = coloured({0, 2, 3}, {0, 0.2, 0});
  const double value = 0.2126 + 2 * 0.7152 + 3 * 0.0722;
  EXPECT_DOUBLE_EQ(relative_error_map(a).values[0], 0.2126 * 0.1 / value);
  EXPECT_NEAR(difference_map(a, b).values[0], 0.2126 / (0.2126 * 0.1 + 0.7152 * 0.2), 1e-12);
  FilmEstimate doubtful = a;
  doubtful.reliable[2] = false;
  EXPECT_TRUE(std::isnan(difference_map(doubtful, b).values[0]));
}

TEST(ImageMaps, OfLargeImagesAreThinned) {
  EXPECT_EQ(pixels_per_pixel(1024, 1024), 1u);
  EXPECT_EQ(pixels_per_pixel(1025, 3), 2u);
  FilmEstimate image{.shape = {2, 2049}};
  for (int i = 0; i < 2 * 2049; ++i) image.value.push_back(i % 2049);
  const PixelMap few = thinned({2049, 2, image.value});
  EXPECT_EQ(few.width, 683u);
  EXPECT_EQ(few.height, 1u);
  EXPECT_EQ(few.values[1], 3);
  const FilmEstimate squares = averaged(image);
  EXPECT_EQ(squares.shape, (std::vector{1, 683}));
  EXPECT_DOUBLE_EQ(squares.value[1], 4);
  // A square at the edge is of what there is.
  image.shape = {3, 1366};
  image.value.assign(3 * 1366, 2);
  for (const double value : averaged(image).value) EXPECT_DOUBLE_EQ(value, 2);
}

std::string figure_of(const std::vector<RunRecord>& runs, ImageFigureOptions options = {}) {
  std::vector<LabelledFilm> films;
  for (const RunRecord& run : runs)
    films.push_back({"film " + std::to_string(films.size()), run.rendering});
  return image_figure(films, options);
}

TEST(ImageFigure, ShowsThePictureAndItsError) {
  for (const int channels : {1, 3}) {
    const RunRecord run = image_run(40, 20, channels);
    const std::string svg =
        figure_of({run}, {.title = "<&>", .value = {"mean radiance", "W/(m²·sr)"}});
    EXPECT_TRUE(is_well_formed(svg));
    const auto images = images_in(svg);
    ASSERT_EQ(images.size(), 4u);
    // Each pixel 25 times, side by side.
    EXPECT_EQ(images[0].width, 1000u);
    EXPECT_EQ(images[0].height, 500u);
    const FilmEstimate& film = run.rendering.film;
    const double white = white_of(film);
    for (std::size_t p = 0; p < 800; ++p)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(pixel(images[0], p, 40)[c],
                  srgb_byte(film.value[channels == 1 ? p : 3 * p + c] / white))
            << p;
    EXPECT_EQ(images[2].width, 1000u);
    EXPECT_NE(svg.find(">relative standard error<"), std::string::npos);
    EXPECT_NE(svg.find(channels == 1 ? ">mean radiance, W/(m²·sr)<"
                                     : ">luminance of mean radiance, W/(m²·sr)<"),
              std::string::npos);
  }
}

// On a column of a journal the titles of the scales take two lines, and none is wider than its scale.
TEST(ImageFigure, KeepsTitlesOfScalesOnTheirPanel) {
  constexpr double column = 84 / 25.4 * 72;
  ImageFigureOptions options{.title = "narrow", .value = {"mean radiance", "W/(m²·sr)"}};
  options.width = column;
  const std::string svg = figure_of({image_run(40, 20, 3)}, options);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(count(svg, ">luminance of mean radiance, W/(m²·sr)<"), 0u);
  EXPECT_EQ(count(svg, ">W/(m²·sr)<") + count(svg, ">radiance, W/(m²·sr)<"), 1u);
}

// The scale of an image that is much higher than wide is wider than it.
TEST(ImageFigure, OfANarrowImageHasTitlesThatCanBeRead) {
  for (const int width : {1, 10}) {
    const std::string svg = figure_of({image_run(width, 300, 3)},
                                      {.title = "tall", .value = {"mean radiance", "W/m²"}});
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_EQ(count(svg, "…"), 0u) << width;
  }
}

// The first is held against the second; where they differ upwards it is red.
TEST(ImageFigure, HoldsOneOfTwoAgainstTheOther) {
  RunRecord one = image_run(40, 20, 1, 1), other = image_run(40, 20, 1, 2);
  one.rendering.film.value[45] = other.rendering.film.value[45] + 100;
  one.rendering.film.value[46] = other.rendering.film.value[46] - 100;
  one.rendering.film.value[47] = other.rendering.film.value[47];
  const std::string svg = figure_of({one, other});
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_NE(svg.find(">film 0 − film 1<"), std::string::npos);
  EXPECT_NE(svg.find("|z|\u00a0=\u00a0"), std::string::npos);
  const auto images = images_in(svg);
  ASSERT_EQ(images.size(), 8u);
  const auto map = [&](std::size_t p) { return pixel(images[2], p, 40); };
  EXPECT_EQ(map(45), difference_colours().back());
  EXPECT_EQ(map(46), difference_colours().front());
  EXPECT_GT(map(47)[0], 240);
  EXPECT_GT(map(47)[2], 240);
  EXPECT_EQ(map(0), (Rgb{0xb0, 0xb0, 0xb0})) << "not reliable";
}

TEST(ImageFigure, HoldsAllAgainstAReference) {
  ImageFigureOptions options;
  options.reference = LabelledFilm{"exact", image_run(40, 20, 3, 9).rendering};
  const std::string svg = figure_of({image_run(40, 20, 3, 1), image_run(40, 20, 3, 2)}, options);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(images_in(svg).size(), 12u);
  EXPECT_NE(svg.find(">film 0 − exact<"), std::string::npos);
  EXPECT_NE(svg.find(">film 1 − exact<"), std::string::npos);
}

TEST(ImageFigure, IsSoundWhateverItShows) {
  for (const double size : {0., 1e-30, 1e300}) {
    RunRecord run = image_run(30, 60, 3);
    for (double& value : run.rendering.film.value) value *= size;
    for (double& error : run.rendering.film.standard_error) error *= size;
    EXPECT_TRUE(is_well_formed(figure_of({run}))) << size;
    run.rendering.film.value[4] = not_known;
    run.rendering.film.value[9] = INFINITY;
    run.rendering.film.reliable.assign(run.rendering.film.reliable.size(), false);
    EXPECT_TRUE(is_well_formed(figure_of({run, run}))) << size;
  }
}

TEST(Colours, OfDifferencesAreLightestInTheMiddle) {
  const auto lightness = [](const Rgb& c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; };
  const ColourMap& colours = difference_colours();
  for (std::size_t k = 1; k < 128; ++k)
    EXPECT_GE(lightness(colours[k]), lightness(colours[k - 1])) << k;
  for (std::size_t k = 129; k < colours.size(); ++k)
    EXPECT_LE(lightness(colours[k]), lightness(colours[k - 1])) << k;
}

}  // namespace
}  // namespace wander::figure

// The picture of fluence: tones, their scale, and the verb that computes it.
#include "draw/figure/fluence_figure.h"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <png.h>

#include <cmath>

#include "draw/figure/plane_picture.h"
#include "draw/figure/style.h"
#include "draw/figure/tones.h"
#include "records/exr.h"
#include "tests/draw/figure/figure_checks.h"
#include "tests/tools/command_line.h"

namespace wander::figure {
namespace {

// Values that differ from cell to cell: the largest file.
std::vector<double> uneven(const PlaneGrid& grid, double size) {
  std::vector<double> values;
  for (std::size_t k = 0; k < grid.size(); ++k)
    values.push_back(size * std::exp(std::sin(12.9898 * static_cast<double>(k)) * 3));
  return values;
}

struct Image {
  std::uint32_t width;
  std::vector<Rgb> pixels;
};

// The first image of a document.
Image embedded(const std::string& svg) {
  const std::string start = "data:image/png;base64,";
  const std::size_t from = svg.find(start) + start.size(), end = svg.find('"', from);
  std::string bytes(3 * (end - from) / 4, '\0');
  EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                  reinterpret_cast<const unsigned char*>(svg.data() + from),
                  static_cast<int>(end - from));
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png_image_begin_read_from_memory(&png, bytes.data(), bytes.size());
  png.format = PNG_FORMAT_RGB;
  Image image{png.width, std::vector<Rgb>(std::size_t{png.width} * png.height)};
  png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr);
  return image;
}

std::string figure_of(const std::vector<double>& values, const PlaneGrid& grid) {
  Rendering picture;
  picture.film.value = values;
  return fluence_figure(room(), grid, picture, "<&>");
}

TEST(FluenceFigure, IsWellFormedAndSmallWhateverItShows) {
  const PlaneGrid grid = grid_over(room(), 256);
  for (const double size : {1e-30, 1e-6, 1., 1e12, 1e300}) {
    const std::string svg = figure_of(uneven(grid, size), grid);
    EXPECT_TRUE(is_well_formed(svg)) << size;
    EXPECT_LT(svg.size(), 2000000u);
    EXPECT_NE(svg.find(">fluence, W/m<"), std::string::npos);
  }
  std::vector<double> odd(grid.size());
  EXPECT_TRUE(is_well_formed(figure_of(odd, grid))) << "dark";
  odd[3] = nan;
  odd[4] = INFINITY;
  EXPECT_TRUE(is_well_formed(figure_of(odd, grid)));
}

// One pixel to a cell, of the colour that the scale gives its value.
TEST(Tones, AreAnImageOfTheValues) {
  std::vector<double> values;
  for (int k = 0; k < 200; ++k) values.push_back(std::exp(0.02 * k));
  const PlaneGrid grid({0, 0}, {20, 10}, 20);
  const ToneScale scale = tone_scale(values);
  Svg svg({100, 50}, "", "");
  draw_tones(svg, values, grid, scale, light_colours(), {0, 50}, {100, 0});
  const Image image = embedded(std::move(svg).finish());
  ASSERT_EQ(image.width, 20u);
  ASSERT_EQ(image.pixels.size(), values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_EQ(image.pixels[k], light_colours()[scale.tone(values[k])]) << k;
}

// Equal steps look equal, and the dark end is dark.
TEST(Colours, GrowLighterFromBlack) {
  const auto lightness = [](const Rgb& c) { return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2]; };
  EXPECT_LT(lightness(light_colours().front()), 3);
  EXPECT_GT(lightness(light_colours().back()), 230);
  for (std::size_t k = 1; k < light_colours().size(); ++k) {
    EXPECT_GE(lightness(light_colours()[k]), lightness(light_colours()[k - 1]) - 1) << k;
    EXPECT_LE(lightness(ink_colours()[k]), lightness(ink_colours()[k - 1])) << k;
  }
}

// Walls are light on it, and dark in the figures on paper.
TEST(FluenceFigure, ShowsTheSceneOnDarkGround) {
  const PlaneGrid grid = grid_over(room(), 16);
  const std::string svg = figure_of(uneven(grid, 1), grid);
  const auto rules = svg.find("<style>"), marks = svg.find("class=\"on-dark\"");
  ASSERT_NE(rules, std::string::npos);
  EXPECT_LT(rules, marks);
  EXPECT_LT(svg.find("class=\"dark-rim\""), marks);
  EXPECT_NE(svg.find(".on-dark [stroke='" + std::string(style::wall) + "']{stroke:#f2f0f4}"),
            std::string::npos);
}

TEST(Tones, GrowWithTheValueAndFireflyDoesNotDarkenThem) {
  std::vector<double> values(10000, 1);
  values[0] = 1e9;
  const ToneScale scale = tone_scale(values);
  EXPECT_GT(scale.tone(1), 128);
  int last = 0;
  for (double value = 1e-6; value < 1e12; value *= 1.2) {
    EXPECT_GE(scale.tone(value), last);
    last = scale.tone(value);
  }
  EXPECT_EQ(last, 255);
  EXPECT_EQ(scale.tone(0), 0);
  EXPECT_EQ(scale.tone(nan), 0);
}

TEST(LogAxis, LabelsPowersOfTenAndWhatIsBetweenThemWhereThereIsRoom) {
  const Axis wide = make_log_axis({"fluence", "W/m"}, {0.01, 0.5}, {0, 300});
  EXPECT_EQ(wide.labels, (std::vector<std::string>{"0.01", "0.02", "0.05", "0.1", "0.2", "0.5"}));
  EXPECT_EQ(wide.title, "fluence, W/m");
  const Axis narrow = make_log_axis({"x", ""}, {1e-7, 1e-4}, {0, 90});
  EXPECT_EQ(narrow.labels, (std::vector<std::string>{"10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴"}));
}

using PlotFluence = test::CommandLine;

TEST_F(PlotFluence, MakesAFigureAndAnImageOfTheSamePicture) {
  EXPECT_EQ(wander("plot box.json --fluence -b 2000 --resolution 20 -o light.svg").exit_code, 0);
  EXPECT_TRUE(is_well_formed(test::contents(folder / "light.svg")));
  const test::Outcome image =
      wander("plot box.json --fluence -b 2000 --resolution 20 -t 2 --json -o light.exr");
  EXPECT_EQ(image.exit_code, 0);
  EXPECT_HAS(image.out, "\"kind\": \"fluence\"");
  const RunRecord run = read_exr(folder / "light.exr");
  EXPECT_EQ(run.rendering.film.shape, (std::vector<int>{10, 20}));
  EXPECT_EQ(run.rendering.film.value.size(), 200u);
  EXPECT_EQ(run.rendering.film.standard_error.size(), 200u);
  EXPECT_EQ(run.rendering.samples, 2000u);
  EXPECT_HAS(wander("plot light.exr -o again.svg").err, "this is a picture");
  const auto window = read_window(folder / "light.exr");
  ASSERT_TRUE(window);
  EXPECT_EQ(window->low, (std::array{0., 0.}));
  EXPECT_EQ(window->high, (std::array{2., 1.}));
  EXPECT_HAS(wander("inspect light.exr").out, "window          (0, 0) to (2, 1) m");
  EXPECT_HAS(wander("inspect light.exr --json").out, "\"window\"");
}

TEST_F(PlotFluence, RefusesWhatMakesNoSense) {
  for (const char* arguments :
       {"plot box.json --fluence -o light.jpg", "plot box.json -b 2s -o light.svg",
        "plot box.json --resolution 9 -o light.svg",
        "plot box.json --fluence --resolution 60000 -o light.svg",
        "plot box.json --fluence --chain 1 -o light.svg", "plot box.json --draws 1:2 -o a.svg",
        "plot box.json --draws 2:1 -o a.svg", "plot box.json --figure nothing -o a.svg"}) {
    const test::Outcome outcome = wander(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_EQ(entries(), 1u);
}

using PlotTrajectory = test::CommandLine;

TEST_F(PlotTrajectory, DrawsEachFigureOfARecordedTrajectory) {
  ASSERT_EQ(wander("trace box.json --steps 50 --chains 2 -o box.nc").exit_code, 0);
  for (const char* which : {"paths", "trace", "acceptance", "autocorrelation", "density", "all"}) {
    const std::string figure = std::string(which) + ".svg";
    EXPECT_EQ(wander(std::string("plot box.nc --figure ") + which + " -o " + figure).exit_code, 0);
    EXPECT_TRUE(is_well_formed(test::contents(folder / figure))) << which;
  }
  EXPECT_HAS(wander("plot box.nc --mutation lense -o a.svg").err, "unknown mutation");
  EXPECT_HAS(wander("plot box.nc --class XX -o a.svg").err, "unknown class");
  EXPECT_HAS(wander("plot box.nc --chain 2 -o a.svg").err, "the chains 0 to 1");
  EXPECT_HAS(wander("plot box.nc --draws 50:60 -o a.svg").err, "the draws 0 to 49");
  EXPECT_HAS(wander("plot box.nc box.json -o a.svg").err, "one at a time");
}

}  // namespace
}  // namespace wander::figure

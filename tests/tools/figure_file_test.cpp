// Figures as files: what their names say they are, they are, as large on the page as was asked for.
#include <gtest/gtest.h>

#include <cstdint>
#include <regex>

#include "tests/draw/figure/figure_checks.h"
#include "tests/tools/command_line.h"

namespace wander {
namespace {

class FigureFile : public test::CommandLine {
 protected:
  std::string plotted(const std::string& arguments, const char* file) const {
    const auto outcome = wander("plot " + arguments + " -o " + file);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return test::contents(folder / file);
  }
  void expect_usage_error(const std::string& arguments, const char* part) const {
    const auto outcome = wander("plot " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_HAS(outcome.err, part);
  }
};

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + k));
  return value;
}

double width_in_points(const std::string& text, const char* expression) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(expression)) ? std::stod(found[1]) : 0;
}

double width_of_svg(const std::string& svg) {
  return width_in_points(svg.substr(0, 400), R"( width="([0-9.]+)pt")");
}

TEST_F(FigureFile, APngIsOneWithTheSizeOfTheFigureAtItsResolution) {
  const std::string svg = plotted("box.json", "box.svg");
  for (const auto& [options, dpi] : {std::pair{"", 300.}, {" --dpi 150", 150.}}) {
    const std::string png = plotted(std::string("box.json --force") + options, "box.png");
    ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    ASSERT_EQ(png.substr(12, 4), "IHDR");
    EXPECT_NEAR(big_endian(png, 16), width_of_svg(svg) / 72 * dpi, 0.5);
    // The resolution, in pixels to the metre.
    const std::size_t at = png.find("pHYs");
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(big_endian(png, at - 4), 9u);
    EXPECT_NEAR(big_endian(png, at + 4), dpi / 0.0254, 0.5);
  }
}

TEST_F(FigureFile, APdfIsOneWithAPageOfTheSizeOfTheFigureAndTheSameEveryTime) {
  const std::string pdf = plotted("box.json --width 84mm", "box.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NEAR(width_in_points(pdf, R"(/MediaBox \[ 0 0 ([0-9.]+) )"), 84 / 25.4 * 72, 0.01);
  EXPECT_EQ(pdf, plotted("box.json --width 84mm", "again.pdf"));
}

TEST_F(FigureFile, TheCaseOfAnEndingDoesNotMatter) {
  EXPECT_EQ(plotted("box.json", "box.PDF").substr(0, 5), "%PDF-");
}

TEST_F(FigureFile, AnyOtherEndingIsRefusedBeforeAnythingIsComputed) {
  for (const char* name : {"box", "box.jpg", "box.exr", "box.svg.gz"}) {
    expect_usage_error(std::string("box.json -o ") + name, ".svg, .png or .pdf");
    // A million seconds would be noticed.
    expect_usage_error(std::string("box.json --fluence -b 1000000s -o ") + "box.jpg", ".exr");
  }
  EXPECT_EQ(entries(), 1u);
}

// film.exr says nothing of time.
TEST_F(FigureFile, AFilmFromItsFileIsOfWhatItsMethodMakes) {
  ASSERT_EQ(wander("render box.json -m mlt -b 2k -q -o run").exit_code, 0);
  const std::string figure = plotted("run/film.exr", "film.svg");
  EXPECT_HAS(figure, ": 2000 mutations, error ");
  EXPECT_LACKS(figure, "nan");
}

TEST_F(FigureFile, APipeTakesSvg) {
  const auto outcome = wander("plot box.json -o /dev/stdout");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(figure::is_well_formed(outcome.out));
}

TEST_F(FigureFile, TheWidthIsThatOfThePageAndWordsKeepTheirSize) {
  const std::string usual = plotted("box.json", "usual.svg");
  for (const auto& [text, points] : {std::pair{"84mm", 84 / 25.4 * 72},
                                     {"8.4cm", 84 / 25.4 * 72},
                                     {"3.3in", 3.3 * 72},
                                     {"300pt", 300.},
                                     {"400px", 300.}}) {
    const std::string svg = plotted(std::string("box.json --force --width ") + text, "box.svg");
    EXPECT_NEAR(width_of_svg(svg), points, 0.01) << text;
    EXPECT_EQ(figure::count(svg, "font-size=\"7\""), figure::count(usual, "font-size=\"7\""));
  }
  for (const char* text : {"84", "5mm", "2000mm", "-84mm", "mm", "84 mm", "84km"})
    expect_usage_error(std::string("box.json -o b.svg --width '") + text + "'", "84mm");
}

TEST_F(FigureFile, EveryKindOfFigureTakesTheWidth) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 1k -o run").exit_code, 0);
  ASSERT_EQ(wander("trace box.json --steps 20 --chains 2 -o t.nc").exit_code, 0);
  for (const char* what : {"box.json", "run", "run run", "t.nc", "t.nc --figure acceptance",
                           "t.nc --figure autocorrelation", "t.nc --figure paths",
                           "box.json --fluence -b 1k --resolution 16"}) {
    const std::string svg = plotted(std::string(what) + " --force --width 84mm", "f.svg");
    EXPECT_TRUE(figure::is_well_formed(svg)) << what;
    EXPECT_NEAR(width_of_svg(svg), 84 / 25.4 * 72, 0.01) << what;
  }
}

TEST_F(FigureFile, OptionsOfOtherKindsAreRefused) {
  expect_usage_error("box.json --dpi 200 -o box.svg", "--dpi is for FILE.png");
  expect_usage_error("box.json --dpi 20 -o box.png", "from 36 to 1200");
  expect_usage_error("box.json --log-y -o box.svg", "--log-y is for films");
  expect_usage_error("box.json --fluence -b 1k --width 84mm -o box.exr", "--resolution");
  expect_usage_error("box.json --width 900mm --dpi 1200 -o box.png", "smaller --dpi");
}

TEST_F(FigureFile, TheValuesOfFilmsCanBeLogarithmic) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 1k -o run").exit_code, 0);
  const std::string linear = plotted("run", "linear.svg"), log = plotted("run --log-y", "log.svg");
  EXPECT_TRUE(figure::is_well_formed(log));
  EXPECT_LACKS(log, ">0<");
  EXPECT_NE(linear, log);
}

}  // namespace
}  // namespace wander

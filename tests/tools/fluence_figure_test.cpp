// The picture of fluence: tones, their scale, and the verb that computes it.
#include "tools/figure/fluence_figure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/output/exr.h"
#include "tests/tools/command_line.h"
#include "tests/tools/figure_checks.h"
#include "tools/figure/plane_picture.h"
#include "tools/figure/tones.h"

namespace wander::figure {
namespace {

// Values that differ from cell to cell: the largest file.
std::vector<double> uneven(const PlaneGrid& grid, double size) {
  std::vector<double> values;
  for (std::size_t k = 0; k < grid.size(); ++k)
    values.push_back(size * std::exp(std::sin(12.9898 * static_cast<double>(k)) * 3));
  return values;
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

TEST(Tones, GrowWithTheValueAndFireflyDoesNotDarkenThem) {
  std::vector<double> values(10000, 1);
  values[0] = 1e9;
  const ToneScale scale = tone_scale(values);
  EXPECT_GT(scale.tone(1), tone_count / 2);
  int last = 0;
  for (double value = 1e-6; value < 1e12; value *= 1.2) {
    EXPECT_GE(scale.tone(value), last);
    last = scale.tone(value);
  }
  EXPECT_EQ(last, tone_count - 1);
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

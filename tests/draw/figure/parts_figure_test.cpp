// What samples and chains carry, as figures: of a row of bins and of an image, also where numbers are
// not known.
#include "draw/figure/parts_figure.h"

#include <gtest/gtest.h>

#include "core/film_statistics.h"
#include "tests/draw/figure/figure_checks.h"
#include "tests/support/images.h"
#include "tests/tools/command_line.h"

namespace wander::figure {
namespace {

Rendering row_of_bins() {
  Rendering run;
  run.method = "mlt";
  run.film = {.shape = {4}, .value = {1, 2, 3, 0}, .standard_error = {0.1, 0.1, 0.1, 0}};
  run.film.reliable = {true, true, true, false};
  run.pooling = {{}, 100, 0.25, {0.25, 0.5, 0.75, 0}, {{"LE", 0.6, 0.1}, {"LSE", 0.4, 0.475}}};
  return run;
}

TEST(PartsFigure, OfBinsDrawsBothAndEachClass) {
  const std::string svg = parts_of_film(row_of_bins(), {.title = "row"});
  for (const char* words :
       {">carried by samples<", ">share of chains<", ">LSE<", "60 % of the light", "47.5 %",
        "Who carries the light of each class of path"})
    EXPECT_HAS(svg, words);
}

TEST(PartsFigure, NamesHowManyClassesItLeavesOut) {
  Rendering run = row_of_bins();
  for (int n = 0; n < 12; ++n)
    run.pooling->classes.push_back({"L" + std::string(n, 'D') + "E", 0.01, 0.5});
  EXPECT_HAS(parts_of_film(run, {.title = "row"}), "5 more are not shown");
}

// The letters of an image within the document may spell anything.
void expect_numbers(const std::string& svg) {
  for (const char* none : {" nan", "nan ", "nan,", ",nan", "\"nan", ">nan"})
    EXPECT_LACKS(svg, none);
}

TEST(PartsFigure, LeavesOutWhatIsNotKnown) {
  Rendering run = row_of_bins();
  run.pooling->film_of_samples[1] = not_known;
  run.film.value[2] = not_known;
  expect_numbers(parts_of_film(run, {.title = "row"}));
  run.film.value.assign(4, not_known);
  expect_numbers(parts_of_film(run, {.title = "row"}));
  Rendering image = test::chains_image_run(6, 4, 3).rendering;
  image.film.value[3] = not_known;
  image.pooling->film_of_samples[9] = not_known;
  expect_numbers(parts_of_image(image, {.title = "image"}));
}

}  // namespace
}  // namespace wander::figure

// `wander plot` of a comparison: its error against time.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lab/compare/comparison_json.h"
#include "tests/draw/figure/figure_checks.h"
#include "tests/draw/report/comparison_maker.h"
#include "tests/tools/command_line.h"

namespace wander {
namespace {

class PlotComparison : public test::CommandLine {
 protected:
  PlotComparison() {
    test::fs::create_directory(folder / "compared");
    const compare::Comparison made =
        test::make_comparison({"gallery:article-1", {"bdpt", "pt"}, {5'000, 20'000}, 2});
    write("compared/compare.json", compare::to_json(made).dump());
  }
};

TEST_F(PlotComparison, DrawsTheErrorOfEachContenderAgainstTime) {
  const auto outcome = wander("plot compared -o error.svg --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_HAS(outcome.out, "\"comparison\"");
  const std::string svg = test::contents(folder / "error.svg");
  EXPECT_TRUE(figure::is_well_formed(svg));
  for (const char* part : {">Error against time<", ">time, s<", ">relative RMSE, %<", ">bdpt<",
                           ">pt<", "class=\"interval\""})
    EXPECT_HAS(svg, part);
}

TEST_F(PlotComparison, OneAtATimeAndNothingBesideIt) {
  for (const char* more : {"compared", "--reference box.json"}) {
    const auto outcome = wander(std::string("plot compared ") + more + " -o error.svg");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_HAS(outcome.err, "one at a time");
  }
  EXPECT_FALSE(exists("error.svg"));
}

}  // namespace
}  // namespace wander

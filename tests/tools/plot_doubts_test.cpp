// What is doubtful of a figure of several films, or of a reference, and which steps of a trajectory it shows.
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "records/run_files.h"
#include "records/run_json.h"
#include "tests/support/images.h"
#include "tests/tools/command_line.h"

namespace wander::test::plot_doubts_test {
namespace {

class PlotDoubts : public CommandLine {
 protected:
  void put(const char* name, const RunRecord& run) const {
    fs::create_directory(folder / name);
    write_run(run, {}, folder / name);
  }
};

constexpr const char* one_seed = "both are of one seed";
constexpr const char* another_scene = "another scene";

TEST_F(PlotDoubts, TellThatFilmsAreOfSeveralScenes) {
  ASSERT_EQ(wander("render gallery:article-1 -m bdpt -b 2k -o a -q").exit_code, 0);
  ASSERT_EQ(wander("render gallery:article-2 -m bdpt -b 2k -o b -q").exit_code, 0);
  const Outcome together = wander("plot a b -o f.svg");
  EXPECT_EQ(together.exit_code, 0);
  EXPECT_HAS(together.err, another_scene);
  EXPECT_HAS(contents(folder / "f.svg"), "article-1, article-2");
  for (const char* command : {"plot a --force -o f.svg", "inspect a"}) {
    const Outcome held = wander(std::string(command) + " --reference b");
    EXPECT_EQ(held.exit_code, 0);
    EXPECT_HAS(held.out + held.err, another_scene);
    EXPECT_LACKS(held.out + held.err, one_seed);
  }
  EXPECT_LACKS(wander("plot a a --force -o f.svg").err, another_scene);
}

// The first of two images is held against the second, as against a --reference.
TEST_F(PlotDoubts, AreThoseOfAReferenceForTheSecondOfTwoImages) {
  put("one", image_run(24, 16, 3, 1));
  put("same", image_run(24, 16, 3, 1));
  put("other", image_run(24, 16, 3, 2));
  EXPECT_HAS(wander("plot one same -o f.svg").err, one_seed);
  EXPECT_LACKS(wander("plot one other --force -o f.svg").err, one_seed);
}

TEST_F(PlotDoubts, SayWhatIsDrawnInsteadOfATable) {
  std::ofstream(folder / "film.csv") << "bin,value\n0,1\n";
  const Outcome table = wander("plot film.csv -o f.svg");
  EXPECT_EQ(table.exit_code, 2);
  EXPECT_HAS(table.err, "film.csv is a table for other programs");
}

TEST_F(PlotDoubts, LookAtAllSeedsOfAMergedRun) {
  for (const char* seed : {"1", "2", "3"})
    ASSERT_EQ(wander(std::string("render box.json -m bdpt -b 2k -q -o r") + seed + " -s " + seed)
                  .exit_code,
              0);
  ASSERT_EQ(wander("merge r1 r2 -o all -q").exit_code, 0);
  for (const char* part : {"r1", "r2"})
    EXPECT_HAS(wander(std::string("inspect all --reference ") + part).out, one_seed);
  EXPECT_LACKS(wander("inspect all --reference r3").out, one_seed);
}

// Rooms of a width just above a power of ten had a bar of no length.
TEST_F(PlotDoubts, DoNotLieInTheLengthOfTheScaleBar) {
  ASSERT_EQ(wander("render gallery:parallel -m bdpt -b 2k -o p -q").exit_code, 0);
  ASSERT_EQ(wander("plot p -o p.svg").exit_code, 0);
  EXPECT_LACKS(contents(folder / "p.svg"), ">0 m<");
  EXPECT_HAS(contents(folder / "p.svg"), ">0.2 m<");
}

TEST_F(PlotDoubts, AreNoneOfDrawsByTheirNumbers) {
  ASSERT_EQ(wander("trace box.json --steps 200 --chains 2 --window 100:200 --every 7 -o w.nc -q")
                .exit_code,
            0);
  ASSERT_EQ(wander("plot w.nc --figure acceptance --draws 114:128 -o f.svg").exit_code, 0);
  EXPECT_HAS(contents(folder / "f.svg"), "draws 114 to 121");
  expect_one_fault(wander("plot w.nc --draws 0:100 -o no.svg"), 2,
                   {"the draws 100 to 198, one of 7"});
}

TEST_F(PlotDoubts, AreNoneOfFiguresThatShowAllSteps) {
  ASSERT_EQ(wander("trace box.json --steps 50 --chains 2 -o t.nc -q").exit_code, 0);
  for (const char* figure : {"trace", "autocorrelation"})
    for (const char* filter : {"--mutation lens", "--class LE"})
      expect_one_fault(wander(std::string("plot t.nc -o no.svg --figure ") + figure + " " + filter),
                       2, {"narrows paths, acceptance and density"});
}

// Whatever seeds a comparison makes its runs of, a reference may have one of them.
TEST_F(PlotDoubts, OfAReferenceAreToldByComparisonsToo) {
  const std::string comparison = "compare box.json -m bdpt -b 1k --replicates 2 -q --json -o ";
  const Outcome first = wander(comparison + "c");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::uint64_t seed = nlohmann::json::parse(first.out)["runs"][1]["seed"];
  for (const auto& [name, of] : {std::pair("same", seed), std::pair("other", seed + 1000)}) {
    const std::string render = "render box.json -m pt -b 2k -q -o ";
    ASSERT_EQ(wander(render + name + " -s " + std::to_string(of)).exit_code, 0);
  }
  EXPECT_HAS(wander(comparison + "d --reference same").out, one_seed);
  EXPECT_LACKS(wander(comparison + "e --reference other").out, one_seed);
}

TEST_F(PlotDoubts, TellThatPathsAreOfAnotherSceneThanTheFilmUnderThem) {
  ASSERT_EQ(wander("trace gallery:ring --steps 4 --chains 1 -q -o t.nc").exit_code, 0);
  ASSERT_EQ(wander("render gallery:ring -m pt -b 2k -q -o own").exit_code, 0);
  const auto record = read_run(folder / "own");
  const auto& shape = record.rendering.film.shape;
  put("other", image_run(shape[1], shape[0], 1));
  EXPECT_LACKS(wander("plot t.nc own --figure paths -o a.svg").err, another_scene);
  const Outcome over = wander("plot t.nc other --figure paths -o b.svg");
  EXPECT_EQ(over.exit_code, 0) << over.err;
  EXPECT_HAS(over.err, another_scene);
}

}  // namespace
}  // namespace wander::test::plot_doubts_test

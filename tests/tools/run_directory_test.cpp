// What stands in the directory of a run, whatever stood there before and wherever the run ends.
#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace run_directory_test {

using nlohmann::json;

class RunDirectoryOf : public CommandLine {
 protected:
  std::string bytes_of(const char* file) const { return contents(folder / file); }
};

// A limit of 150 KB for a file stands for a disk that is nearly full.
TEST_F(RunDirectoryOf, ACheckpointThatDoesNotFitTakesNoFilmWithIt) {
  for (const char* kept : {"", "--checkpoint 0.01 "}) {
    const Outcome outcome = shell(
        "ulimit -f 300; \"$WANDER\" render box.json -m mlt -b 400k -q --json --force -o out " +
        std::string(kept));
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_HAS(outcome.err, "cannot write out/checkpoint: ");
    EXPECT_TRUE(json::parse(outcome.out).contains("error"));
    const json run = json::parse(bytes_of("out/run.json"));
    EXPECT_EQ(run["samples"], 400'000);
    EXPECT_EQ(run["complete"], true);
    EXPECT_TRUE(exists("out/film.exr"));
  }
}

TEST_F(RunDirectoryOf, OfAnotherRunIsLeftUntilThereIsSomethingOfTheNew) {
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -o run").exit_code, 0);
  const std::string run = bytes_of("run/run.json"), film = bytes_of("run/film.exr"),
                    checkpoint = bytes_of("run/checkpoint");
  shell("timeout -s KILL 1 \"$WANDER\" render box.json -m pt -b 3h -s 2 --force -q -o run");
  EXPECT_EQ(bytes_of("run/run.json"), run);
  EXPECT_EQ(bytes_of("run/film.exr"), film);
  EXPECT_TRUE(bytes_of("run/checkpoint") == checkpoint);
  // With something of the new one nothing is left of the old.
  shell(
      "cp run/checkpoint before; \"$WANDER\" render box.json -m pt -b 3h -s 2 --force -q -o run "
      "--checkpoint 0.1 & n=0; while cmp -s run/checkpoint before && [ $n -lt 600 ]; do sleep 0.1; "
      "n=$((n+1)); done; sleep 0.2; kill -9 $!");
  EXPECT_FALSE(bytes_of("run/checkpoint") == checkpoint);
  EXPECT_FALSE(exists("run/run.json"));
  EXPECT_FALSE(exists("run/film.exr"));
  EXPECT_HAS(wander("inspect run").err, "did not come to its end");
  ASSERT_EQ(wander("render --continue -o run -b 100ms -q").exit_code, 0);
  EXPECT_EQ(json::parse(bytes_of("run/run.json"))["seed"], 2);
}

TEST_F(RunDirectoryOf, IsRefusedBeforeTheRunWhereItsCheckpointCannotBe) {
  fs::create_directories(folder / "run/checkpoint/mine");
  const Outcome outcome = wander("render box.json -m pt -b 3h -o run --force");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_HAS(outcome.err, "cannot write run/checkpoint: Is a directory");
}

// Nor is what was kept of the old one gone where nothing of the new one fits.
TEST_F(RunDirectoryOf, ThatCannotBeReplacedStaysWhole) {
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -o run").exit_code, 0);
  EXPECT_EQ(shell("ulimit -f 4; \"$WANDER\" render box.json -m mlt -b 20k -q -s 2 --force -o run")
                .exit_code,
            1);
  EXPECT_EQ(json::parse(bytes_of("run/run.json"))["seed"], 1);
  EXPECT_EQ(wander("render --continue -o run -q").exit_code, 0);
}

TEST_F(RunDirectoryOf, WithoutACheckpointHasNoneOfAnother) {
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -o run").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -o run --force --checkpoint 0").exit_code, 0);
  EXPECT_FALSE(exists("run/checkpoint"));
}

// What --force replaces is not found again beside what replaced it.
TEST_F(RunDirectoryOf, HoldsARunOrAComparisonAndNeverBoth) {
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -o it").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -s 2 -o other").exit_code, 0);
  ASSERT_EQ(wander("compare box.json -m bdpt -b 2k --replicates 2 -q -o it --force").exit_code, 0);
  for (const char* file : {"it/run.json", "it/film.exr", "it/film.csv", "it/checkpoint"})
    EXPECT_FALSE(exists(file)) << file;
  EXPECT_HAS(wander("inspect it").out, "bdpt");
  write("it/notes.txt", "mine");
  for (const char* command : {"render box.json -m pt -b 2k", "merge other third"}) {
    ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -s 3 -o third --force").exit_code, 0);
    ASSERT_EQ(wander(std::string(command) + " -q -o it --force").exit_code, 0);
    for (const char* file :
         {"it/compare.json", "it/compare.csv", "it/report.html", "it/reference.json", "it/kept"})
      EXPECT_FALSE(exists(file)) << file;
    EXPECT_TRUE(exists("it/run.json"));
    ASSERT_EQ(wander("compare box.json -m bdpt -b 2k --replicates 2 -q -o it --force").exit_code,
              0);
  }
  EXPECT_EQ(bytes_of("it/notes.txt"), "mine");
}

TEST_F(RunDirectoryOf, WhatIsReadIsNotReplaced) {
  write("box.svg", box);
  for (const char* command :
       {"trace box.json --steps 2 -o ./box.json", "plot box.svg -o box.svg"}) {
    const Outcome outcome = wander(std::string(command) + " --force");
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_HAS(outcome.err, "would be replaced");
  }
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -q -o reference").exit_code, 0);
  for (const char* reference : {"reference", "reference/run.json"})
    EXPECT_EQ(wander(std::string("compare box.json -b 2k --replicates 2 --force -o reference "
                                 "--reference ") +
                     reference)
                  .exit_code,
              2);
  EXPECT_TRUE(exists("reference/run.json"));
  EXPECT_EQ(bytes_of("box.json"), box);
  EXPECT_EQ(bytes_of("box.svg"), box);
}

}  // namespace run_directory_test
}  // namespace wander::test

// `compare --continue`: a comparison that was killed, interrupted or finished goes on, makes no run
// twice, and has the numbers of one that never stopped; what cannot go on says why.
#include <random>

#include "records/seal.h"
#include "tests/tools/continued_comparison.h"

namespace wander::test {
namespace {

// SIGKILL at random moments, from the start of the program; then as a user would go on.
TEST_F(ContinuingComparison, KilledAnywhereItHasTheNumbersOfOneThatNeverStopped) {
  const std::string all = "box.json -m bdpt,mlt -b 10k,20k --replicates 4 -q -o ";
  ASSERT_EQ(compare(all + "whole").exit_code, 0);
  std::mt19937_64 random(1);
  int killed = 0;
  for (int kill = 0; kill < 6; ++kill) {
    const std::string command = exists("cut/kept/plan") ? "--continue -q -o " : all;
    const double seconds = 0.05 + 0.2 * std::uniform_real_distribution()(random);
    const Outcome outcome =
        shell("export XDG_CACHE_HOME=\"$PWD/cache\"; timeout -s KILL " + std::to_string(seconds) +
              " \"$WANDER\" compare " + command + "cut -t " + std::to_string(1 + kill % 3));
    ASSERT_TRUE(outcome.exit_code == 137 || outcome.exit_code == 0) << outcome.err;
    killed += outcome.exit_code == 137 ? 1 : 0;
  }
  EXPECT_GT(killed, 0);
  const std::string last = exists("cut/kept/plan") ? "--continue -q -o cut" : all + "cut";
  const Outcome outcome = compare(last);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(numbers_in("cut"), numbers_in("whole"));
}

TEST_F(ContinuingComparison, WhatWasInterruptedGoesOnToItsEndAndMakesNoRunTwice) {
  expect_to_go_on("box.json", "80k");
}

TEST_F(ContinuingComparison, MoreReplicatesAreThoseOfALargerOne) {
  ASSERT_EQ(compare("box.json -m pt,mlt -b 1k,2k --replicates 5 -q -o whole").exit_code, 0);
  ASSERT_EQ(compare("box.json -m pt,mlt -b 1k,2k --replicates 2 -q -o cut").exit_code, 0);
  ASSERT_EQ(compare("--continue -o cut --replicates 5 --target 0.5 -q").exit_code, 0);
  EXPECT_EQ(numbers_in("cut"), numbers_in("whole"));
  EXPECT_EQ(json::parse(contents(folder / "cut/compare.json"))["target"], 0.5);
  EXPECT_EQ(compare("--continue -o cut -q").exit_code, 0);
  EXPECT_EQ(json::parse(contents(folder / "cut/compare.json"))["target"], 0.5);
}

TEST_F(ContinuingComparison, FailedRunsAreKeptToo) {
  std::string dark = box;
  const std::string before = "    { \"type\": \"segment\", \"from\": [0.5,0.1]";
  dark.insert(dark.find(before),
              "    { \"type\": \"segment\", \"from\": [0,0.5], \"to\": [2,0.5] },\n");
  write("dark.json", dark);
  ASSERT_EQ(compare("dark.json -m pt,mlt -b 100 --replicates 2 -q -o cut").exit_code, 0);
  const json once = numbers_in("cut");
  ASSERT_EQ(compare("--continue -q -o cut").exit_code, 0);
  EXPECT_EQ(numbers_in("cut"), once);
  EXPECT_EQ(once["failures"].size(), 2u);
}

TEST_F(ContinuingComparison, WhatIsGivenMustBeWhatTheComparisonHas) {
  ASSERT_EQ(compare("box.json -m pt,mlt -b 1k,2k --replicates 3 --dial large_step=0.2 -q -o run")
                .exit_code,
            0);
  write("other.json", std::string(box) + "\n");
  expect_refused("other.json --continue -o run", 2, {"its scene is box.json (sha256 "});
  expect_refused("--continue -o run -m pt", 2, {"its methods are pt,mlt, not pt;"});
  expect_refused("--continue -o run -b 1k,4k -s 2", 2,
                 {"its budgets are 1k,2k, not 1k,4k", "its seed is 1, not 2"});
  expect_refused("--continue -o run --reference run.json", 2,
                 {"its --reference is auto, not run.json"});
  expect_refused("--continue -o run --dial large_step=0.3", 2,
                 {"its --dial is large_step=0.2, not large_step=0.3"});
  expect_refused("--continue -o run --sweep kernel=2", 2, {"its --sweep is none, not kernel=2"});
  expect_refused("--continue -o run --replicates 2", 2, {"is of 3 replicates"});
  expect_refused("--continue -o run --force", 2, {"leave one of them out"});
  expect_refused("--continue", 2, {"--continue needs -o DIR"});
  EXPECT_EQ(compare("box.json -m pt,mlt -b 2000,1000 -s 1 --continue -o run -q").exit_code, 0);
}

TEST_F(ContinuingComparison, WhereNothingIsKeptItSaysWhatToDo) {
  expect_refused("--continue -o nowhere", 2, {"nowhere holds nothing of a comparison", "--force"});
  ASSERT_EQ(wander("render box.json -m pt -b 1k -q -o run").exit_code, 0);
  expect_refused("--continue -o run", 2, {"run holds nothing of a comparison"});
  expect_refused("-m pt -b 1k -o new", 2, {"SCENE is required"});
}

TEST_F(ContinuingComparison, WhatIsDamagedIsRefused) {
  ASSERT_EQ(compare(std::string(tiny) + " -q -o run").exit_code, 0);
  for (const char* name : {"run/kept/plan", "run/kept/reference", "run/kept/runs-0001"}) {
    const std::string whole = contents(folder / name);
    for (const std::size_t place : {std::size_t{30}, whole.size() / 2, whole.size() - 2}) {
      change(name, [&](std::string& bytes) { bytes[place] ^= 1; });
      expect_refused("--continue -o run", 3, {name, "damaged or cut short", "--force"});
      change(name, [&](std::string& bytes) { bytes = whole.substr(0, place); });
      expect_refused("--continue -o run", 3, {"damaged or cut short"});
      change(name, [&](std::string& bytes) { bytes = whole; });
    }
    change(name, [](std::string& bytes) { bytes = "mine"; });
    expect_refused("--continue -o run", 3, {"is no part of a comparison"});
    change(name, [&](std::string& bytes) { bytes = whole; });
  }
  EXPECT_EQ(compare("--continue -q -o run").exit_code, 0);
}

TEST_F(ContinuingComparison, PartsOfAnotherComparisonOrVersionAreRefused) {
  ASSERT_EQ(compare(std::string(tiny) + " -q -o run").exit_code, 0);
  ASSERT_EQ(compare(std::string(tiny) + " -q -s 2 -o other").exit_code, 0);
  const std::string whole = contents(folder / "run/kept/runs-0001");
  change("run/kept/runs-0001",
         [&](std::string& bytes) { bytes = contents(folder / "other/kept/runs-0001"); });
  expect_refused("--continue -o run", 3, {"kept/runs-0001: it is of another comparison"});
  change("run/kept/runs-0001",
         [&](std::string& bytes) { bytes = contents(folder / "run/kept/reference"); });
  expect_refused("--continue -o run", 3, {"it is another part of a comparison"});
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string other(*unsealed(whole));
    other.replace(other.find(from), from.size(), to);
    change("run/kept/runs-0001", [&](std::string& bytes) { bytes = sealed(other); });
  };
  with("wanderlight-kept/5", "wanderlight-kept/9");
  expect_refused("--continue -o run", 3, {"its format is wanderlight-kept/9"});
  with("\"version\":\"", "\"version\":\"9.");
  expect_refused("--continue -o run", 3, {"of version 9."});
  with("\"part\"", "\"pert\"");
  expect_refused("--continue -o run", 3, {"its header cannot be read"});
}

TEST_F(ContinuingComparison, ANewComparisonLeavesNothingOfTheOld) {
  ASSERT_EQ(compare(std::string(tiny) + " -q -o run").exit_code, 0);
  ASSERT_EQ(compare("box.json -m pt -b 1k --replicates 2 -q -o run --force").exit_code, 0);
  const Outcome outcome = compare("--continue -o run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_HAS(outcome.err, "carried on from 2 of 2 runs");
}

// Every run fails: what was to be replaced is as it was, and can be carried on.
TEST_F(ContinuingComparison, OneThatComesToNothingLeavesTheOldAsItWas) {
  ASSERT_EQ(compare(std::string(tiny) + " -q -o run").exit_code, 0);
  const std::string before = contents(folder / "run/compare.json");
  std::string dark = box;
  const std::string lamp = "    { \"type\": \"segment\", \"from\": [0.5,0.1]";
  dark.insert(dark.find(lamp),
              "    { \"type\": \"segment\", \"from\": [0,0.5], \"to\": [2,0.5] },\n");
  write("dark.json", dark);
  fs::copy_file(folder / "run/reference.json", folder / "known.json");
  const Outcome failed =
      compare("dark.json -m mlt -b 100 --replicates 2 --reference known.json -q -o run --force");
  EXPECT_NE(failed.exit_code, 0) << failed.err;
  EXPECT_HAS(failed.err, "light");
  EXPECT_FALSE(fs::exists(folder / "run/kept.before"));
  EXPECT_EQ(contents(folder / "run/compare.json"), before);
  const Outcome outcome = compare("--continue -o run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_HAS(outcome.err, "carried on from ");
  // And one that has made a run leaves nothing of it.
  ASSERT_EQ(compare("box.json -m pt -b 1k --replicates 2 -q -o run --force").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "run/kept.before"));
}

TEST_F(ContinuingComparison, AnOutputThatExistsNamesBothWays) {
  ASSERT_EQ(compare(std::string(tiny) + " -q -o run").exit_code, 0);
  expect_refused(std::string(tiny) + " -o run", 2,
                 {"holds a comparison;", "--force", "--continue"});
  for (const char* name : {"compare.json", "compare.csv", "report.html", "reference.json"})
    fs::remove(folder / "run" / name);
  expect_refused(std::string(tiny) + " -o run", 2,
                 {"holds a comparison that did not come to its end", "--continue"});
  // What a program that was killed at its very start has left stands in nobody's way.
  fs::remove_all(folder / "run/kept");
  fs::create_directory(folder / "run/kept");
  EXPECT_EQ(compare(std::string(tiny) + " -q -o run").exit_code, 0);
}

}  // namespace
}  // namespace wander::test

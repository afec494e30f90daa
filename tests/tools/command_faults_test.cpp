// One attempt tells all that is wrong with a command; misspelt options are answered with the
// nearest; `help` is a word for --help.
#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;
using CommandFaults = CommandLine;

TEST_F(CommandFaults, AMissingOutputHidesNoOtherFault) {
  write("bad.json", R"({"format": "wanderlight-scene/1", "dimension": 7, "shapes": [])"
                    "\n}\n");
  const Outcome outcome = wander("render bad.json -m bdtp -b soon --chain 3 -t 0 -s x");
  EXPECT_EQ(outcome.exit_code, 2);
  for (const char* part : {"render needs -o", "did you mean \"bdpt\"?", "budget 'soon'",
                           "render has no option --chain", "did you mean --chains?", "threads '0'",
                           "seed 'x'", "\nbad.json:1:", "/dimension"})
    EXPECT_HAS(outcome.err, part);
  EXPECT_LACKS(outcome.err, "too many");
  EXPECT_LACKS(outcome.err, "--method is required");
}

TEST_F(CommandFaults, OfEveryVerbThatComputes) {
  write("bad.json", "{}");
  for (const char* command :
       {"render bad.json -m pt", "compare bad.json", "trace bad.json", "plot bad.json"}) {
    const Outcome outcome = wander(command);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_HAS(outcome.err, " needs -o ");
    EXPECT_HAS(outcome.err, "bad.json:1:");
  }
  EXPECT_HAS(wander("compare bad.json -m nope -o out").err, "bad.json:1:");
  EXPECT_HAS(wander("check bad.json -o out").err, "bad.json:1:");
  EXPECT_EQ(wander("compare bad.json -o out").exit_code, 3);
}

TEST_F(CommandFaults, AreOneDocumentWithJson) {
  write("bad.json", "{}");
  const Outcome outcome = wander("render bad.json -m nope --json");
  EXPECT_EQ(outcome.exit_code, 2);
  const json error = json::parse(outcome.out).at("error");
  EXPECT_HAS(error["message"].get<std::string>(), "unknown method \"nope\"");
  EXPECT_HAS(error["message"].get<std::string>(), "bad.json:1:");
  EXPECT_GT(error["faults"].size(), 0U);
}

// In the same words, though each contender meets it.
TEST_F(CommandFaults, OfAllContendersAreToldOnce) {
  write("dim.json", R"({"format": "wanderlight-scene/1", "dimension": 2, "shapes": [
    {"type": "segment", "from": [1, 1], "to": [0, 1], "light": {"radiance": 1}},
    {"type": "segment", "from": [1e20, 0], "to": [1e20, 1]},
    {"type": "segment", "from": [0, 0], "to": [1, 0], "sensor": {"bins": 8}}]})");
  const Outcome outcome =
      wander("compare dim.json -m pt,bdpt --sweep precision=float -b 1k -o out");
  EXPECT_EQ(outcome.exit_code, 2);
  const std::string refusal = "cannot hold this scene";
  const std::size_t first = outcome.err.find(refusal);
  ASSERT_NE(first, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find(refusal, first + 1), std::string::npos) << outcome.err;
}

TEST_F(CommandFaults, AnOptionThatIsGivenTwiceIsNamedWithWhatItTakes) {
  EXPECT_HAS(wander("render box.json -m pt -b 1k -b 2k -o out").err,
             "--budget is given 2 times; it takes one BUDGET;");
  EXPECT_HAS(wander("compare box.json -m pt -m bdpt -b 1k -o out").err,
             "--methods is given 2 times; it takes one METHOD,...;");
}

TEST_F(CommandFaults, AMissingArgumentIsToldWithTheOthers) {
  const Outcome outcome = wander("render -b never");
  for (const char* part :
       {"SCENE is required", "--method is required", "budget 'never'", "needs -o"})
    EXPECT_HAS(outcome.err, part);
  const Outcome cut = wander("render box.json -o out -m");
  EXPECT_EQ(cut.exit_code, 2);
  EXPECT_HAS(cut.err, "--method");
  EXPECT_LACKS(cut.err, "required;");
}

TEST_F(CommandFaults, AMisspeltOptionIsAnsweredWithTheNearest) {
  EXPECT_HAS(wander("trace box.json --chain 2 -o t.nc").err, "did you mean --chains?");
  EXPECT_HAS(wander("trace box.json --chian=2 -o t.nc").err, "did you mean --chains?");
  EXPECT_HAS(wander("plot box.json --chian 2 -o t.svg").err, "did you mean --chain?");
  EXPECT_HAS(wander("plot box.json --forse -o t.svg").err, "did you mean --force?");
  EXPECT_HAS(wander("render box.json -m pt -o o --steps 9").err, "it is an option of trace");
  const Outcome far = wander("render box.json -m pt -o o --zzzzzzz");
  EXPECT_HAS(far.err, "render has no option --zzzzzzz; see `wander render --help`");
  EXPECT_HAS(wander("render box.json other.json -m pt -o o").err,
             "'other.json' is one argument too many");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(CommandFaults, AnOptionOfTrajectoriesOnAnotherFileSaysSo) {
  const Outcome outcome = wander("plot box.json --chain 0 -o t.svg");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_HAS(outcome.err, "box.json is no trajectory");
}

TEST_F(CommandFaults, HelpIsAWordForTheOption) {
  EXPECT_EQ(wander("help").out, wander("--help").out);
  EXPECT_EQ(wander("help").exit_code, 0);
  for (const std::string verb : {"render", "plot"}) {
    EXPECT_EQ(wander("help " + verb).out, wander(verb + " --help").out);
    EXPECT_EQ(wander("help " + verb).exit_code, 0);
  }
  const Outcome unknown = wander("help rendre");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_HAS(unknown.err, "did you mean \"render\"?");
  EXPECT_EQ(wander("render --help -b never").exit_code, 0);
}

// ---- standard input and output

TEST_F(CommandFaults, ASceneComesFromStandardInput) {
  const Outcome file = wander("inspect box.json"), piped = wander("inspect - < box.json");
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_EQ(piped.out, file.out);
  EXPECT_EQ(wander("render - -m pt -b 1k -o run -q < box.json").exit_code, 0);
  EXPECT_EQ(json::parse(contents(folder / "run/run.json"))["scene"]["text"], box);
  EXPECT_EQ(wander("trace - --steps 5 -o t.nc -q < box.json").exit_code, 0);
  EXPECT_EQ(wander("check - --samples 5k --mutations bidirectional=1 -q < box.json").exit_code, 0);
  EXPECT_EQ(wander("compare - -m pt -b 1k --replicates 2 -o out -q < box.json").exit_code, 0);
  EXPECT_EQ(wander("plot - -o a.svg < box.json && \"$WANDER\" plot box.json -o b.svg").exit_code,
            0);
  EXPECT_EQ(contents(folder / "a.svg"), contents(folder / "b.svg"));
  const Outcome bad = wander("inspect - < /dev/null");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_TRUE(bad.err.starts_with("<stdin>:1:1: ")) << bad.err;
  EXPECT_EQ(shell("yes | \"$WANDER\" inspect -").exit_code, 3);
}

TEST_F(CommandFaults, AFigureGoesToStandardOutput) {
  ASSERT_EQ(wander("plot box.json -o box.svg").exit_code, 0);
  const Outcome printed = wander("plot box.json -o -");
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_EQ(printed.out, contents(folder / "box.svg"));
  EXPECT_TRUE(wander("plot box.json --fluence -b 1k -q -o -").out.starts_with("<"));
  EXPECT_EQ(wander("gallery slit -o -").out, wander("gallery slit").out);
  EXPECT_FALSE(exists("-"));
  const Outcome both = wander("plot box.json -o - --json");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_HAS(both.err, "--json");
}

TEST_F(CommandFaults, WhatDoesNotFitStandardOutputIsRefused) {
  EXPECT_HAS(wander("trace box.json -o -").err, "no netCDF file can be made");
  EXPECT_HAS(wander("render box.json -m pt -o -").err, "a directory of files");
  EXPECT_HAS(wander("compare box.json -o -").err, "a directory of files");
  EXPECT_HAS(wander("inspect box.json -o x").err, "inspect writes no files");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(CommandFaults, TheGalleryWritesAFile) {
  EXPECT_EQ(wander("gallery slit -o slit.json").exit_code, 0);
  EXPECT_EQ(contents(folder / "slit.json"), wander("gallery slit").out);
  EXPECT_EQ(wander("gallery slit -o slit.json --force --json").out,
            wander("gallery slit --json").out);
}

}  // namespace
}  // namespace wander::test

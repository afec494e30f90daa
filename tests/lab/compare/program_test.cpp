// `wander compare` as a user meets it: what lies on the disk, what is repeatable, what is refused.
#include <fmt/format.h>

#include <functional>
#include <set>

#include "tests/lab/compare/compare_command.h"

namespace wander::test {
namespace {

// What may differ between two runs of the same command.
json without_times(json document) {
  const std::set<std::string> facts{"command", "command_line", "provenance", "threads",
                                    "efficiency"};
  const std::function<void(json&)> strip = [&](json& node) {
    if (node.is_object())
      for (auto it = node.begin(); it != node.end();)
        it = it.key().find("seconds") != std::string::npos || facts.contains(it.key())
                 ? node.erase(it)
                 : std::next(it);
    for (json& child : node)
      if (child.is_structured()) strip(child);
  };
  strip(document);
  return document;
}

TEST_F(CompareCommand, LeavesItsFilesAndTheSameDocumentOnStdout) {
  const Outcome outcome = compare(std::string(tiny) + " -o deep/out --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"report.html", "compare.json", "compare.csv", "reference.json"})
    EXPECT_TRUE(exists((std::string("deep/out/") + name).c_str())) << name;
  const json printed = json::parse(outcome.out);
  EXPECT_EQ(printed, json::parse(contents(folder / "deep/out/compare.json")));
  EXPECT_EQ(printed["complete"], true);
  EXPECT_EQ(printed["runs"].size(), 12u);
  EXPECT_HAS(outcome.err, "relative RMSE");
  EXPECT_HAS(outcome.err, "deep/out");
}

TEST_F(CompareCommand, WithSamplesTheSameSeedGivesTheSameForAnyNumberOfThreads) {
  const json one = compared(std::string(tiny) + " -t 1"),
             two = compared(std::string(tiny) + " -t 2");
  EXPECT_EQ(without_times(one)["cells"], without_times(two)["cells"]);
  EXPECT_EQ(without_times(one)["runs"], without_times(two)["runs"]);
  const json other = compared(std::string(tiny) + " -s 2");
  EXPECT_NE(without_times(one)["runs"], without_times(other)["runs"]);
}

TEST_F(CompareCommand, EachRunIsRepeatedByItsCommand) {
  const json document =
      compared("box.json -m mlt -b 5k --replicates 2 --sweep 'mutations=lens=1,bidirectional=1;'");
  for (const json& run : document["runs"]) {
    std::string command = run["command"];
    command.replace(0, std::string("wander").size(), "\"$WANDER\"");
    const Outcome outcome = shell(command + " -q --force");
    ASSERT_EQ(outcome.exit_code, 0) << command << outcome.err;
    const json repeated = json::parse(contents(folder / "run" / "run.json"));
    EXPECT_EQ(repeated["samples"], run["samples"]) << command;
    EXPECT_EQ(repeated["seed"], run["seed"]) << command;
    double mean = 0;
    for (const json& value : repeated["film"]["value"]) mean += value.get<double>() / 8;
    EXPECT_DOUBLE_EQ(mean, run["errors"]["mean"].get<double>()) << command;
  }
}

TEST_F(CompareCommand, SweepsAreContenders) {
  const json document =
      compared("box.json -m pt,mmlt -b 2k --replicates 2 --sweep estimator=kelemen,expected");
  std::vector<std::string> labels;
  for (const json& contender : document["contenders"]) labels.push_back(contender["label"]);
  EXPECT_EQ(labels, (std::vector<std::string>{"pt", "mmlt estimator=expected (default)",
                                              "mmlt estimator=kelemen"}));
  const json lengths = compared("box.json -m pt -b 2k --replicates 2 --sweep max_vertices=4,6");
  EXPECT_EQ(lengths["contenders"].size(), 2u);
}

TEST_F(CompareCommand, MistakesAreExitTwoAndLeaveNothing) {
  for (const char* arguments :
       {"box.json", "box.json -o o -m nope", "box.json -o o -m pt,pt", "box.json -o o -b 1s,1k",
        "box.json -o o -b soon", "box.json -o o --replicates 1", "box.json -o o --replicates many",
        "box.json -o o --sweep shoe=1", "box.json -o o --sweep max_vertices=1",
        "box.json -o o -m pt --sweep estimator=kelemen", "box.json -o o --dial max_vertices",
        "box.json -o o --target 0", "box.json -o o --target soon", "box.json -o o --nonsense"}) {
    const Outcome outcome = compare(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err, "") << arguments;
    EXPECT_EQ(entries(), 1u) << arguments;
  }
  EXPECT_HAS(compare("box.json -o o --sweep max_vertex=3").err, "did you mean \"max_vertices\"?");
}

TEST_F(CompareCommand, ReplacesItsOwnDirectoryOnlyWithForce) {
  EXPECT_EQ(compare(std::string(tiny) + " -o out -q").exit_code, 0);
  EXPECT_EQ(compare(std::string(tiny) + " -o out -q").exit_code, 2);
  EXPECT_EQ(compare(std::string(tiny) + " -o out -q --force").exit_code, 0);
  fs::create_directory(folder / "mine");
  write("mine/notes.txt", "mine");
  EXPECT_EQ(compare(std::string(tiny) + " -o mine -q").exit_code, 2);
}

// ---- what goes wrong

// A wall shields the sensor.
std::string dark_box() {
  std::string scene = box;
  const std::string before = "    { \"type\": \"segment\", \"from\": [0.5,0.1]";
  return scene.insert(scene.find(before),
                      "    { \"type\": \"segment\", \"from\": [0,0.5], \"to\": [2,0.5] },\n");
}

TEST_F(CompareCommand, AChainWithoutLightIsAFailedRunAndNotTheEnd) {
  write("dark.json", dark_box());
  const Outcome all = compare("dark.json -m mlt -b 100 --replicates 2 -o o");
  EXPECT_EQ(all.exit_code, 1);
  EXPECT_HAS(all.err, "found no light path");
  EXPECT_FALSE(exists("o"));
  const json some = compared("dark.json -m pt,mlt -b 100 --replicates 2");
  EXPECT_EQ(some["runs"].size(), 2u);
  EXPECT_EQ(some["failures"].size(), 2u);
  EXPECT_HAS(some["failures"][0]["message"].get<std::string>(), "found no light path");
}

TEST_F(CompareCommand, WithoutLightThereIsNothingToMeasureAgainst) {
  std::string dark = dark_box();  // and a mirror, so that no exact film says so
  const std::string diffuse = R"("type": "diffuse")";
  write("dark.json", dark.replace(dark.find(diffuse), diffuse.size(), R"("type": "mirror")"));
  const Outcome outcome = compare("dark.json -m pt,mlt -b 100 --replicates 2 -o o");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_HAS(outcome.err, "found no light; look for walls without a gap");
  EXPECT_FALSE(exists("o"));
}

TEST_F(CompareCommand, AnInterruptedComparisonIsSavedAsIncomplete) {
  const Outcome outcome = interrupted_at(
      "replicate [2-9] ", "box.json -m pt -b 0.05s,0.1s --replicates 500 -t 1 -o out");
  ASSERT_EQ(outcome.exit_code, 130) << outcome.err;
  const json document = json::parse(contents(folder / "out" / "compare.json"));
  EXPECT_EQ(document["complete"], false);
  EXPECT_GT(document["runs"].size(), 0u);
  EXPECT_LT(document["runs"].size(), 1000u);
  EXPECT_HAS(outcome.err, "not complete");
}

TEST_F(CompareCommand, OneInterruptedBeforeItsFirstRunHasItsReference) {
  write("mirror.json", mirror_box());
  const Outcome outcome = interrupted_at("replicate", "box.json -b 60s --replicates 2 -o o");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const json document = json::parse(contents(folder / "o" / "compare.json"));
  EXPECT_EQ(document["complete"], false);
  EXPECT_EQ(document["runs"].size(), 0u);
  EXPECT_TRUE(exists("o/report.html"));
  EXPECT_HAS(document["reference"]["origin"].get<std::string>(), "exact");
}

TEST_F(CompareCommand, AnInterruptedReferenceIsWhatIsKnownOfIt) {
  write("mirror.json", mirror_box());
  const Outcome outcome = interrupted_at("reference: ", "mirror.json -b 3s --replicates 2 -o o");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const json document = json::parse(contents(folder / "o" / "compare.json"));
  EXPECT_EQ(document["complete"], false);
  EXPECT_EQ(document["runs"].size(), 0u);
  EXPECT_TRUE(exists("o/report.html"));
  EXPECT_HAS(document["reference"]["origin"].get<std::string>(), "interrupted");
  for (const json& value : document["reference"]["film"]["value"]) EXPECT_TRUE(value.is_number());
}

TEST_F(CompareCommand, OneInterruptedInItsTrialSaysThatThereIsNoReference) {
  write("mirror.json", mirror_box());
  const Outcome outcome = interrupted_at("trial", "mirror.json -b 15s --replicates 2 -o o");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const json document = json::parse(contents(folder / "o" / "compare.json"));
  EXPECT_EQ(document["complete"], false);
  EXPECT_EQ(document["runs"].size(), 0u);
  EXPECT_TRUE(exists("o/report.html"));
  EXPECT_HAS(document["cautions"].dump(), "There is no reference");
}

// Between a fifth and the end.
TEST_F(CompareCommand, AnInterruptedComparisonKnowsTheErrorsOfWhatItMade) {
  write("mirror.json", mirror_box());
  std::string values = "0.01";
  for (int i = 2; i < 50; ++i) values += fmt::format(",{:.2f}", 0.01 * i);
  const Outcome outcome = interrupted_at("\"fraction\":0.[2-9]",
                                         "mirror.json -m mlt -b 0.2s --replicates 2 -o out "
                                         "--sweep large_step=" +
                                             values);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  const json document = json::parse(contents(folder / "out" / "compare.json"));
  EXPECT_EQ(document["complete"], false);
  ASSERT_GT(document["runs"].size(), 0u);
  EXPECT_LT(document["runs"].size(), 98u);
  for (const json& run : document["runs"])
    EXPECT_TRUE(run["errors"]["relative_mse"].is_number()) << run["errors"];
  EXPECT_TRUE(exists("out/report.html"));
  EXPECT_TRUE(exists("out/compare.csv"));
}

TEST_F(CompareCommand, SaysHowLongItWillTake) {
  EXPECT_HAS(compare(std::string(tiny) + " -o out").err, "12 runs of 1k, 2k: about ");
  EXPECT_LACKS(compare(std::string(tiny) + " -o quiet -q").err, "about");
  write("mirror.json", mirror_box());
  EXPECT_HAS(compare("mirror.json -m pt -b 0.05s --replicates 2 -o long").err,
             "2 runs of 0.05s, and a reference of about 0.3 s: about 0.4 s");
}

TEST_F(CompareCommand, ProgressIsOfAllRunsTogether) {
  const Outcome outcome =
      compare("box.json -m pt -b 0.3s --replicates 4 --json -q --progress json");
  ASSERT_EQ(outcome.exit_code, 0);
  std::istringstream lines(outcome.err);
  double last = 0;
  for (std::string line; std::getline(lines, line);) {
    const json report = json::parse(line);
    EXPECT_GE(report["fraction"], last);
    last = report["fraction"];
    const std::string phase = report["phase"];
    if (phase != "forecast") {
      EXPECT_HAS(phase, "replicate");
    }
  }
  EXPECT_GT(last, 0.5);
}

}  // namespace
}  // namespace wander::test

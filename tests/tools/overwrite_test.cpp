// An output that exists is replaced only with --force, and the refusal comes before any work.
#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;

class Overwriting : public CommandLine {
 protected:
  // Refused at once: the budget would outlast every test.
  void expect_refused(const std::string& command) {
    const Outcome outcome = shell("timeout 20 \"$WANDER\" " + command);
    EXPECT_EQ(outcome.exit_code, 2) << command << "\n" << outcome.err;
    EXPECT_HAS(outcome.err, "--force");
    EXPECT_EQ(outcome.err.find("--continue") != std::string::npos,
              command.starts_with("render") || command.starts_with("compare"));
    const Outcome with_json = shell("timeout 20 \"$WANDER\" " + command + " --json");
    EXPECT_EQ(with_json.exit_code, 2) << command;
    EXPECT_HAS(json::parse(with_json.out).at("error").at("message").get<std::string>(), "--force");
  }
};

TEST_F(Overwriting, ARunIsReplacedOnlyWithForce) {
  ASSERT_EQ(wander("render box.json -m pt -b 1k -o out -q").exit_code, 0);
  expect_refused("render box.json -m lt -b 1h -o out");
  expect_refused("render box.json -m lt -b 1h -o out/");
  expect_refused("compare box.json -m pt,lt -b 30min,1h -o out");
  EXPECT_HAS(wander("render box.json -m lt -o out").err, "out holds a run");
  EXPECT_EQ(json::parse(contents(folder / "out/run.json"))["method"], "pt");
  EXPECT_EQ(wander("render box.json -m lt -b 1k -o out -q --force").exit_code, 0);
  EXPECT_EQ(json::parse(contents(folder / "out/run.json"))["method"], "lt");
}

TEST_F(Overwriting, AnInterruptedRunIsAnOutputToo) {
  ASSERT_EQ(wander("render box.json -m pt -b 1k -o out -q").exit_code, 0);
  json run = json::parse(contents(folder / "out/run.json"));
  run["complete"] = false;
  write("out/run.json", run.dump(1));
  expect_refused("render box.json -m pt -b 1h -o out");
}

// Killed before its first file was whole.
TEST_F(Overwriting, WhatAKilledRunLeftBehindIsNoOutputAndGoes) {
  fs::create_directory(folder / "out");
  write("out/.wander-4711-0.tmp", "half");
  EXPECT_EQ(wander("render box.json -m pt -b 1k -o out -q").exit_code, 0);
  EXPECT_FALSE(exists("out/.wander-4711-0.tmp"));
  fs::create_directory(folder / "other");
  write("other/.wander-4711-0.tmp", "half");
  write("other/mine", "mine");
  expect_refused("render box.json -m pt -b 1h -o other");
  EXPECT_TRUE(exists("other/.wander-4711-0.tmp"));
}

TEST_F(Overwriting, ADirectoryInWhichAnotherProgramIsAtWorkIsLeftToIt) {
  fs::create_directory(folder / "out");
  for (const char* command : {"render box.json -m pt -b 1k -o out -q --force",
                              "compare box.json -m pt -b 1k --replicates 2 -o out -q"}) {
    const Outcome outcome = shell(std::string("flock out \"$WANDER\" ") + command);
    expect_one_fault(outcome, 1, {"another program is writing into out"});
    EXPECT_TRUE(fs::is_empty(folder / "out"));
  }
  EXPECT_EQ(wander("render box.json -m pt -b 1k -o out -q").exit_code, 0);
}

TEST_F(Overwriting, AComparisonIsReplacedOnlyWithForce) {
  const std::string compare = "compare box.json -m pt,bdpt -b 1k --replicates 2 -q -o out";
  ASSERT_EQ(wander(compare).exit_code, 0);
  const std::string before = contents(folder / "out/compare.json");
  expect_refused("compare box.json -m pt,lt -b 30min,1h -o out");
  EXPECT_HAS(wander(compare).err, "out holds a comparison");
  EXPECT_EQ(contents(folder / "out/compare.json"), before);
  EXPECT_EQ(wander(compare + " --force").exit_code, 0);
}

TEST_F(Overwriting, AFileIsReplacedOnlyWithForceEvenBesideARun) {
  ASSERT_EQ(wander("render box.json -m pt -b 1k -o . -q --force").exit_code, 0);
  for (const char* name : {"figure.svg", "light.svg", "chains.nc", "scene.json"})
    write(name, "mine");
  for (const char* command :
       {"plot box.json -o figure.svg", "plot box.json --fluence -b 1h -o light.svg",
        "trace box.json --steps 1000000 -o chains.nc", "gallery slit -o scene.json"})
    expect_refused(command);
  for (const char* name : {"figure.svg", "light.svg", "chains.nc", "scene.json"})
    EXPECT_EQ(contents(folder / name), "mine") << name;
  EXPECT_EQ(wander("plot box.json -o figure.svg --force").exit_code, 0);
  EXPECT_EQ(wander("gallery slit -o scene.json --force").exit_code, 0);
  EXPECT_EQ(contents(folder / "scene.json"), wander("gallery slit").out);
}

}  // namespace
}  // namespace wander::test

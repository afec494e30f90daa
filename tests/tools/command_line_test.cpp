// The program as a user meets it: exit codes, messages, and what lies on the disk afterwards.
#include "tests/tools/command_line.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace wander::test {
namespace {

using nlohmann::json;

// Replaces the sensor shape of the box by a pinhole.
std::string box_with_camera() {
  json scene = json::parse(box);
  scene["shapes"].erase(2);
  scene["camera"] = {{"type", "perspective"},
                     {"position", {0.1, 0.5}},
                     {"target", {2, 0.5}},
                     {"fov_deg", 60},
                     {"resolution", 8}};
  return scene.dump(1);
}

// ---- help and usage

TEST_F(CommandLine, HelpNamesEveryVerbThatExistsAndNoOther) {
  const Outcome help = wander("--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  for (const char* word : {"render", "trace", "compare", "inspect", "gallery", "plot", "check",
                           "merge", "import", "Exit codes", "130"})
    EXPECT_HAS(help.out, word);
}

TEST_F(CommandLine, WithoutAVerbTheProgramExplainsItself) {
  const Outcome nothing = wander("");
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_HAS(nothing.err, "wander render");
}

TEST_F(CommandLine, EveryVerbHasHelpWithAnExample) {
  for (const std::string verb :
       {"render", "trace", "compare", "inspect", "gallery", "plot", "check", "merge", "import"}) {
    const Outcome help = wander(verb + " --help");
    EXPECT_EQ(help.exit_code, 0) << verb;
    EXPECT_HAS(help.out, "wander " + verb);
    EXPECT_HAS(help.out, "--threads");
    EXPECT_HAS(help.out, "Example");
  }
}

TEST_F(CommandLine, TheVersionIsPrintedAlone) {
  const Outcome version = wander("--version");
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_TRUE(version.out.starts_with("wander ")) << version.out;
}

TEST_F(CommandLine, EveryMistakeInTheCommandLineIsExitTwo) {
  for (const char* arguments : {"fly",
                                "render",
                                "render box.json",
                                "render box.json -m nope --json",
                                "render box.json -m pt -b soon --json",
                                "render box.json -m pt",
                                "render box.json -m pt -o o -t 0",
                                "render box.json -m pt -o o -s -1",
                                "render box.json -m pt -o o --max-vertices 1",
                                "render box.json -m pt -o o -b 'error<2'",
                                "render box.json -m pt -o o --mutations primary=1",
                                "render box.json -m mlt -o o --mutations shove=1",
                                "render box.json -m mmlt -o o --mutations primary=1",
                                "render box.json -m mlt -o o --estimator kelemen",
                                "render box.json -m pssmlt -o o --estimator none",
                                "render box.json extra -m pt -o o",
                                "render box.json -m pt -m lt -o o",
                                "render box.json -m pt -o o --progress loud",
                                "render box.json -m pt -o o --nonsense",
                                "render box.json -m pt -o o -q -v",
                                "inspect",
                                "gallery nowhere",
                                "inspect gallery:nowhere",
                                "render -m",
                                "compare box.json"}) {
    const Outcome outcome = wander(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err, "") << arguments;
    EXPECT_EQ(entries(), 1U) << arguments;
  }
}

// Whoever leaves out `gallery:` is told, with a folder of that name or without.
TEST_F(CommandLine, ANameOfTheGalleryIsRecognized) {
  fs::create_directory(folder / "slit");
  for (const char* source : {"slit", "slit/", "./slit", "lens", "lens.json"}) {
    const Outcome outcome = wander("render " + std::string(source) + " -m pt -o o");
    EXPECT_EQ(outcome.exit_code, 3) << source;
    EXPECT_HAS(outcome.err,
               std::string("or did you mean gallery:") +
                   (std::string(source).find("slit") != std::string::npos ? "slit" : "lens"));
  }
  EXPECT_LACKS(wander("inspect none.json").err, "gallery:");
  write("slit.json", "{}");
  EXPECT_LACKS(wander("inspect slit.json").err, "gallery:");  // a file, if not a scene
}

TEST_F(CommandLine, AMistypedWordIsAnsweredWithTheNearest) {
  EXPECT_HAS(wander("rendre box.json").err, "did you mean \"render\"?");
  EXPECT_HAS(wander("render box.json -m bdtp -o o").err, "did you mean \"bdpt\"?");
}

TEST_F(CommandLine, NaiveLightTracingThroughAPinholeIsRefusedWithTheReason) {
  write("camera.json", box_with_camera());
  const Outcome outcome = wander("render camera.json -m lt-naive -b 1k -o o");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_HAS(outcome.err, "pinhole");
  EXPECT_FALSE(exists("o"));
}

TEST_F(CommandLine, WithJsonAFailureIsOneDocumentOnStdout) {
  for (const char* arguments : {"fly --json", "render --json", "render bad.json -m pt --json",
                                "render missing.json -m pt --json", "inspect bad.json --json"}) {
    write("bad.json", R"({"format": "wanderlight-scene/1",)");
    const Outcome outcome = wander(arguments);
    EXPECT_NE(outcome.exit_code, 0) << arguments;
    const json document = json::parse(outcome.out);
    EXPECT_NE(document.at("error").at("message"), "") << arguments;
    EXPECT_TRUE(document.at("error").at("faults").is_array()) << arguments;
  }
}

// ---- invalid input

TEST_F(CommandLine, AnInvalidSceneIsExitThreeWithItsPlaceAndLeavesNothing) {
  write("bad.json", std::string(box).substr(0, 200));
  for (const char* arguments : {"render bad.json -m pt -b 1k -o out", "inspect bad.json"}) {
    const Outcome outcome = wander(arguments);
    EXPECT_EQ(outcome.exit_code, 3) << arguments;
    EXPECT_TRUE(outcome.err.starts_with("bad.json:")) << outcome.err;
  }
  EXPECT_EQ(entries(), 2U);
}

TEST_F(CommandLine, ABrokenRunIsExitThree) {
  fs::create_directory(folder / "run");
  write("run/run.json", R"({"schema": "wanderlight-run/1"})");
  EXPECT_EQ(wander("inspect run").exit_code, 3);
  fs::create_directory(folder / "empty");
  EXPECT_EQ(wander("inspect empty").exit_code, 3);
}

// ---- render

TEST_F(CommandLine, ARenderLeavesThreeFilesAndTheSameDocumentOnStdout) {
  const Outcome outcome = wander("render box.json -m bdpt -b 2k -o deep/run --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"deep/run/film.exr", "deep/run/film.csv", "deep/run/run.json"})
    EXPECT_TRUE(exists(name)) << name;
  const json printed = json::parse(outcome.out);
  EXPECT_EQ(printed, json::parse(contents(folder / "deep/run/run.json")));
  EXPECT_EQ(printed["method"], "bdpt");
  EXPECT_EQ(printed["samples"], 2000);
  EXPECT_EQ(printed["film"]["value"].size(), 8U);
  EXPECT_EQ(printed["scene"]["text"], box);
  EXPECT_HAS(outcome.err, "relative error");
}

TEST_F(CommandLine, AMarkovChainRunReportsItsMutations) {
  const Outcome outcome = wander("render box.json -m mlt -b 20k -o run --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_TRUE(document["mutations"].contains("bidirectional"));
  EXPECT_GT(document["chains"]["groups"], 1);
  EXPECT_HAS(outcome.err, "normalization");
  EXPECT_HAS(outcome.err, "bidirectional");
}

TEST_F(CommandLine, TheBaselinesInPrimarySampleSpaceRunWithEitherEstimator) {
  for (const std::string method : {"pssmlt", "mmlt"}) {
    std::vector<json> films;
    for (const char* estimator : {"", " --estimator kelemen", " --estimator expected"}) {
      const Outcome outcome =
          wander("render box.json -m " + method + " -b 20k --json -q" + estimator);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      const json document = json::parse(outcome.out);
      EXPECT_EQ(document["method"], method);
      EXPECT_EQ(document["samples"], 20000);
      EXPECT_TRUE(document["mutations"].contains("primary_small"));
      EXPECT_TRUE(document["mutations"].contains("primary_large"));
      films.push_back(document["film"]);
    }
    EXPECT_NE(films[1], films[2]);
    EXPECT_EQ(films[0], films[method == "pssmlt" ? 1 : 2]);
  }
}

TEST_F(CommandLine, JsonAloneWritesNoFileAndQuietSaysNothing) {
  const Outcome outcome = wander("render box.json -m pt -b 1k --json -q");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(json::parse(outcome.out)["seed"], 1);
  EXPECT_EQ(entries(), 1U);
}

TEST_F(CommandLine, ProgressAsJsonIsLinesOfJson) {
  const Outcome outcome = wander("render box.json -m pt -b 1s -t 1 --json -q --progress json");
  ASSERT_EQ(outcome.exit_code, 0);
  ASSERT_NE(outcome.err, "");
  std::istringstream lines(outcome.err);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(json::parse(line).contains("fraction")) << line;
}

TEST_F(CommandLine, OnlyAnEmptyDirectoryIsFilledWithoutForce) {
  fs::create_directory(folder / "out");
  EXPECT_EQ(wander("render box.json -m pt -b 1k -o out -q").exit_code, 0);

  fs::create_directory(folder / "mine");
  write("mine/notes.txt", "mine");
  const Outcome refused = wander("render box.json -m pt -b 1k -o mine");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_HAS(refused.err, "--force");
  EXPECT_FALSE(exists("mine/run.json"));
  EXPECT_EQ(wander("render box.json -m pt -b 1k -o mine --force -q").exit_code, 0);
  EXPECT_EQ(contents(folder / "mine/notes.txt"), "mine");
}

TEST_F(CommandLine, AnUnwritablePlaceIsExitOneAndNamed) {
  const Outcome file = wander("render box.json -m pt -b 1k -o box.json");
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_HAS(file.err, "cannot write box.json: Not a directory");
  const Outcome below = wander("render box.json -m pt -b 1k -o box.json/run");
  EXPECT_EQ(below.exit_code, 1);
  const Outcome proc = wander("render box.json -m pt -b 1k -o /proc/run");
  EXPECT_EQ(proc.exit_code, 1);
  EXPECT_HAS(proc.err, "/proc/run");
}

TEST_F(CommandLine, AFullDiskIsExitOneAndLeavesNothing) {
  const Outcome outcome =
      shell("(ulimit -f 1; \"$WANDER\" render box.json -m mlt -b 20k -q -o out 2>&1) | cat");
  EXPECT_HAS(outcome.out, "cannot write out/");
  EXPECT_HAS(outcome.out, "File too large");
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(shell("ulimit -f 1; \"$WANDER\" render box.json -m mlt -b 20k -q -o out").exit_code, 1);
}

TEST_F(CommandLine, StdoutThatCannotBeWrittenIsExitOne) {
  EXPECT_EQ(wander("render box.json -m pt -b 1k --json -q >/dev/full").exit_code, 1);
  EXPECT_EQ(wander("gallery >/dev/full").exit_code, 1);
  EXPECT_EQ(wander("--help >/dev/full").exit_code, 1);
  EXPECT_EQ(wander("render box.json -m pt -b 1k --json -q >&-").exit_code, 1);
}

TEST_F(CommandLine, AnInterruptedRunIsSavedAsIncomplete) {
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    const Outcome outcome =
        shell("timeout -s " + signal +
              " --preserve-status 1 \"$WANDER\" render box.json -m bdpt -b 60s -t 1 -o " + signal);
    ASSERT_EQ(outcome.exit_code, 130) << outcome.err;
    const json run = json::parse(contents(folder / signal / "run.json"));
    EXPECT_EQ(run["complete"], false);
    EXPECT_LT(run["seconds"], 30);
    EXPECT_HAS(outcome.err, "INCOMPLETE");
  }
}

TEST_F(CommandLine, OneInterruptionThatArrivesTwiceIsSavedToo) {
  const Outcome outcome = shell(
      "\"$WANDER\" render box.json -m bdpt -b 60s -t 1 -o twice & run=$!; sleep 1; kill -INT $run; "
      "sleep 0.02; kill -INT $run; wait $run");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(json::parse(contents(folder / "twice" / "run.json"))["complete"], false);
}

// As `nohup` has it.
TEST_F(CommandLine, AHangUpThatIsIgnoredInterruptsNothing) {
  const Outcome outcome = shell(
      "trap '' HUP; \"$WANDER\" render box.json -m bdpt -b 3s -t 1 -o on & run=$!; sleep 1; kill "
      "-HUP $run; wait $run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// ---- inspect and gallery

TEST_F(CommandLine, InspectSaysWhatASceneRequires) {
  const Outcome outcome = wander("inspect box.json --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json needs = json::parse(outcome.out)["requires"];
  EXPECT_EQ(needs["dimension"], 2);
  EXPECT_EQ(needs["colour_channels"], 1);
  EXPECT_EQ(needs["materials"], json({"diffuse"}));
  EXPECT_EQ(needs["shapes"], json({"polyline", "segment"}));
  EXPECT_EQ(needs["specular"], false);
  EXPECT_EQ(needs["caustic_paths_possible"], false);
  EXPECT_EQ(needs["mutations"], json({"bidirectional", "lens", "primary_small", "primary_large"}));
  EXPECT_HAS(wander("inspect box.json").out, "4 vertices");
}

TEST_F(CommandLine, InspectHoldsARunAgainstItsReference) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 20k -o a -q").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m pt -b 20k -o b -q -s 2").exit_code, 0);
  const Outcome outcome = wander("inspect a --reference b/run.json --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json comparison = json::parse(outcome.out)["comparison"];
  EXPECT_TRUE(comparison["same_scene"]);
  EXPECT_LT(comparison["relative_rmse"], 0.5);
  EXPECT_FALSE(comparison["may_share_samples"]);
  const std::string of_seeds = wander("inspect a/film.exr --reference b").out;
  EXPECT_HAS(of_seeds, "relative RMSE");
  EXPECT_LACKS(of_seeds, "one seed");
  EXPECT_EQ(wander("inspect box.json --reference b").exit_code, 2);
  EXPECT_EQ(wander("inspect a --reference box.json").exit_code, 3);
}

// Films of one seed may have samples in common.
TEST_F(CommandLine, RunsOfOneSeedAreNotHeldAgainstEachOtherWithoutAWord) {
  ASSERT_EQ(wander("render box.json -m bdpt -b 20k -o a -q").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m pt -b 20k -o b -q").exit_code, 0);
  EXPECT_HAS(wander("inspect a --reference b").out, "both are of one seed");
  EXPECT_TRUE(
      json::parse(wander("inspect a --reference b --json").out)["comparison"]["may_share_samples"]);
  EXPECT_HAS(wander("plot a --reference b -o one.svg").err, "both are of one seed");
  ASSERT_EQ(wander("render box.json -m pt -b 20k -o c -q -s 2").exit_code, 0);
  ASSERT_EQ(wander("render box.json -m mlt -b 20k -o d -q").exit_code, 0);
  for (const char* other : {"c", "d"})
    EXPECT_LACKS(wander(std::string("plot a --force -o two.svg --reference ") + other).err,
                 "one seed");
}

TEST_F(CommandLine, EverySceneOfTheGalleryIsListedPrintedAndValid) {
  const Outcome listing = wander("gallery --json");
  ASSERT_EQ(listing.exit_code, 0);
  const json scenes = json::parse(listing.out)["scenes"];
  ASSERT_FALSE(scenes.empty());
  for (const json& scene : scenes) {
    const std::string name = scene["name"];
    EXPECT_NE(scene["description"], "") << name;
    EXPECT_EQ(wander("inspect gallery:" + name).exit_code, 0) << name;
    EXPECT_EQ(wander("gallery " + name + " -o copy.json --force").exit_code, 0) << name;
    EXPECT_EQ(wander("inspect copy.json").exit_code, 0) << name;
  }
}

}  // namespace
}  // namespace wander::test

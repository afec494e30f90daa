// What the program does at the edge: of scenes, files and machines.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;
using Extremes = CommandLine;

double processor_seconds_of_programs() {
  rusage use;
  getrusage(RUSAGE_CHILDREN, &use);
  return double(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
         1e-6 * double(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

TEST_F(Extremes, AreCheckedForEveryMethodInBothPrecisions) {
  const Outcome check = wander("check gallery:parallel --extremes --samples 1k");
  EXPECT_EQ(check.exit_code, 0) << check.err;
  for (const char* part :
       {"bdpt in double", "mmlt in float", "lengths x 2^100            ", "radiances x 2^-100",
        "turned by 90 degrees", "a material that is not used",
        "are the same to the last bit, 0 differ", ": passed\n"})
    EXPECT_HAS(check.out, part);
  // Single precision has a range of its own.
  EXPECT_HAS(check.out, "refused: ");
  const Outcome outcome = wander("check box.json --extremes --samples 1k --json");
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["schema"], "wanderlight-extremes/1");
  EXPECT_EQ(document["passed"], true);
  EXPECT_EQ(document["checks"].size(), 2 * 8 * 10u);
  for (const json& one : document["checks"]) EXPECT_NE(one["verdict"], "differs") << one;
}

TEST_F(Extremes, AFilmHasErrorsAtBothEndsOfTheRangeOfRadiances) {
  for (const char* radiance : {"1e-36", "1e36"}) {
    json scene = json::parse(box);
    for (json& shape : scene["shapes"])
      if (shape.contains("light")) shape["light"]["radiance"] = json::parse(radiance);
    write("edge.json", scene.dump(1));
    for (const char* method : {"bdpt", "mlt", "pssmlt", "mmlt"}) {
      const Outcome run =
          wander(fmt::format("render edge.json -m {} -b 20k -q --json -o run --force", method));
      ASSERT_EQ(run.exit_code, 0) << run.err;
      EXPECT_EQ(run.err, "");
      const json film = json::parse(run.out)["film"];
      for (std::size_t i = 0; i < film["value"].size(); ++i)
        EXPECT_TRUE(film["value"][i] == 0 || film["standard_error"][i] > 0) << method << ' ' << i;
    }
  }
}

TEST_F(Extremes, APipeIsNotWaitedFor) {
  ASSERT_EQ(mkfifo((folder / "pipe.json").c_str(), 0600), 0);
  for (const char* verb : {"inspect pipe.json", "plot pipe.json -o a.svg", "check pipe.json",
                           "render pipe.json -m bdpt -b 1k -o run"}) {
    const Outcome outcome = shell(fmt::format("timeout 20 \"$WANDER\" {}", verb));
    EXPECT_EQ(outcome.exit_code, 3) << verb;
    EXPECT_HAS(outcome.err, "pipe.json:1:1: /: this is a pipe; give its text on standard input");
  }
  EXPECT_EQ(shell("bash -c '\"$WANDER\" inspect <(cat box.json)'").exit_code, 0);
}

TEST_F(Extremes, ADirectoryInPlaceOfAFileHasAPlace) {
  ASSERT_EQ(wander("compare box.json -m bdpt,pt -b 2k --replicates 2 -q -o duel").exit_code, 0);
  fs::remove(folder / "duel/kept/plan");
  fs::create_directory(folder / "duel/kept/plan");
  const Outcome again =
      wander("compare box.json -m bdpt,pt -b 2k --replicates 2 -q -o duel --continue");
  EXPECT_EQ(again.exit_code, 3);
  EXPECT_HAS(again.err, "duel/kept/plan: it cannot be read");
}

// Each key of an object is looked for among those before it: ten times the keys are ten times the work on any
// machine, and a hundred times where each is compared with all (some 50 with what else the
// program does, by the time of such a search alone: 19 s of 90 000 keys, 0.2 s of 9000).
TEST_F(Extremes, AFileOfManyUnknownKeysIsReadAndRefused) {
  const auto seconds_of = [&](int keys) {
    std::string text = R"({"format": "wanderlight-scene/1", "dimension": 2, "shapes": [])";
    for (int i = 0; i < keys; ++i) text += fmt::format(", \"key{}\": 1", i);
    write("keys.json", text + "}");
    const double before = processor_seconds_of_programs();
    const Outcome outcome = wander("inspect keys.json");
    const double seconds = processor_seconds_of_programs() - before;
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_HAS(outcome.err, "unknown key \"key0\"");
    EXPECT_HAS(outcome.err, "more faults follow");
    return seconds;
  };
  const double few = seconds_of(9'000);
  EXPECT_LT(seconds_of(90'000), 25 * few);
}

// The text of a scene is in all that is made of it, and may be longer than 64 KB.
TEST_F(Extremes, ASceneOfALongTextIsRenderedTracedAndPlotted) {
  json scene = json::parse(R"({ "format": "wanderlight-scene/1", "dimension": 3, "shapes": [
    { "type": "sphere", "center": [0, 0, 0], "radius": 1, "light": { "radiance": 1 } }],
    "camera": { "type": "perspective", "position": [0, 0, 8], "target": [0, 0, 0], "fov_deg": 40,
                "resolution": [4, 4] } })");
  for (int i = 0; i < 1200; ++i)
    scene["shapes"].push_back(
        {{"type", "triangle"}, {"points", {{i, 9, 0}, {i + 0.5, 9, 0}, {i, 9.5, 0}}}});
  write("long.json", scene.dump());
  ASSERT_GT(scene.dump().size(), std::size_t{1} << 16);
  for (const char* command :
       {"render long.json -m mlt -b 1k -q -t 1 -o run",
        "render long.json -m mlt -b 1k -q -s 2 -o other", "merge run other -o both",
        "trace long.json --steps 64 --chains 2 -o trace.nc", "plot both/film.nc -o film.svg",
        "plot run/film.exr -o film.png", "plot trace.nc -o trace.svg",
        "compare long.json -m pt,bdpt -b 1k --replicates 2 -q -o duel"}) {
    const Outcome outcome = wander(command);
    EXPECT_EQ(outcome.exit_code, 0) << command << ": " << outcome.err;
  }
}

TEST_F(Extremes, LongPathsAreSampledByEveryMethod) {
  json scene = json::parse(box);
  scene["max_vertices"] = 1000;
  write("long.json", scene.dump(1));
  for (const char* method : {"bdpt", "mlt", "pssmlt"}) {
    const Outcome run =
        wander(fmt::format("render long.json -m {} -b 2k -q -t 1 -o run --force", method));
    EXPECT_EQ(run.exit_code, 0) << method << ": " << run.err;
  }
}

// Of light that hardly any sample finds, b is hard to fit; what is said of it is in the warnings.
TEST_F(Extremes, LibrariesSayNothingOfTheirOwn) {
  const Outcome run = shell(
      "\"$WANDER\" gallery glass-caustic-camera | sed 's/\"reflectance\": 0.7 /\"reflectance\": "
      "7e-31 /; s/\"resolution\": [0-9]*/\"resolution\": 8/' > "
      "faint.json; \"$WANDER\" render faint.json -m pssmlt -b 500 -t 1 -q -o run");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_HAS(contents(folder / "faint.json"), "7e-31");
}

TEST_F(Extremes, ACameraLooksAcrossAnyDistance) {
  for (const char* distance : {"1e-20", "1e30"}) {
    write("far.json", fmt::format(R"({{ "format": "wanderlight-scene/1", "dimension": 3, "shapes": [
      {{ "type": "sphere", "center": [0, 0, 0], "radius": {0}, "light": {{ "radiance": 1 }} }}],
      "camera": {{ "type": "perspective", "position": [0, 0, {1}], "target": [0, 0, 0],
                  "fov_deg": 40, "resolution": [4, 4] }} }})",
                                  distance, std::stod(distance) * 4));
    EXPECT_EQ(wander("inspect far.json").exit_code, 0) << wander("inspect far.json").err;
  }
}

TEST_F(Extremes, InspectSaysWhereGlassMakesNoSense) {
  json scene = json::parse(box);
  scene["materials"]["glass"] = {{"type", "dielectric"}, {"ior", 1.5}};
  for (const double x : {0.9, 1.1})
    scene["shapes"].push_back(
        {{"type", "circle"}, {"center", {x, 0.5}}, {"radius", 0.15}, {"material", "glass"}});
  write("discs.json", scene.dump(1));
  const Outcome inspection = wander("inspect discs.json");
  EXPECT_EQ(inspection.exit_code, 0);
  EXPECT_HAS(inspection.err, "in a medium of index 1.5");
  EXPECT_HAS(inspection.out, "at the sensor   index of refraction 1\n");
  EXPECT_HAS(inspection.out, "bidirectional samples find some");
  const json probe = json::parse(wander("inspect discs.json --json").out)["probe"];
  EXPECT_EQ(probe["index_at_sensor"], 1);
  EXPECT_GT(probe["samples_with_light"], 0);
}

}  // namespace
}  // namespace wander::test

// `wander import` as a command: what it writes, what it says, and what it leaves alone.
#include <nlohmann/json.hpp>

#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

using nlohmann::json;

constexpr const char* ball = R"(<scene version="3.0.0">
  <default name="width" value="20"/>
  <integrator type="path"><integer name="max_depth" value="3"/></integrator>
  <shape type="cube">
    <emitter type="area"/>
  </shape>
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm">
      <integer name="width" value="$width"/>
      <integer name="height" value="10"/>
      <rfilter type="FILTER"/>
    </film>
  </sensor>
</scene>
)";

class Import : public CommandLine {
 protected:
  Import() {
    const std::string text = ball;
    const std::size_t filter = text.find("FILTER");
    write("box.xml", std::string(text).replace(filter, 6, "box"));
    write("tent.xml", std::string(text).replace(filter, 6, "tent"));
  }
};

TEST_F(Import, WritesASceneWithItsMeshes) {
  const Outcome outcome = wander("import box.xml -o cube.json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_HAS(outcome.err, "all of it is exact");
  EXPECT_TRUE(exists("cube-meshes/cube.ply"));
  EXPECT_EQ(entries(), 5U);  // box.json, two scenes of Mitsuba, the scene and its meshes
  const json scene = json::parse(contents(folder / "cube.json"));
  EXPECT_EQ(scene["name"], "cube");
  EXPECT_EQ(scene["max_vertices"], 4);
  EXPECT_EQ(wander("inspect cube.json").exit_code, 0);
}

TEST_F(Import, SaysWhatItApproximatedInOneDocument) {
  const Outcome exact = wander("import tent.xml -o s.json --json");
  EXPECT_EQ(exact.exit_code, 3);
  EXPECT_HAS(exact.err, "tent.xml:12:7: /scene/sensor/film/rfilter: the pixel filter \"tent\"");
  const json fault = json::parse(exact.out)["error"]["faults"][0];
  EXPECT_EQ(fault["line"], 12);
  EXPECT_EQ(fault["path"], "/scene/sensor/film/rfilter");
  EXPECT_FALSE(exists("s.json"));
  EXPECT_FALSE(exists("s-meshes"));

  const Outcome near = wander("import tent.xml -o s.json --json --approximate -D width=7");
  EXPECT_EQ(near.exit_code, 0);
  EXPECT_HAS(near.err, "warning: tent.xml:12:7: ");
  const json said = json::parse(near.out);
  EXPECT_EQ(said["schema"], "wanderlight-import/1");
  EXPECT_EQ(said["files"], json({"s-meshes/cube.ply"}));
  EXPECT_EQ(said["approximations"].size(), 1U);
  const json scene = json::parse(contents(folder / "s.json"));
  EXPECT_EQ(scene["camera"]["resolution"], json({7, 10}));
  EXPECT_HAS(scene["description"].get<std::string>(),
             "the pixel filter \"tent\" is imported as a box");
}

TEST_F(Import, ReplacesNothingWithoutForce) {
  EXPECT_EQ(wander("import box.xml -o a.json").exit_code, 0);
  expect_one_fault(wander("import box.xml -o a.json"), 2, {"a.json exists", "--force"});
  EXPECT_EQ(wander("import box.xml -o a.json --force").exit_code, 0);
  fs::remove(folder / "a.json");
  expect_one_fault(wander("import box.xml -o a.json"), 2, {"a-meshes exists", "--force"});
}

TEST_F(Import, WithFaultsLeavesWhatIsThere) {
  write("s.json", "mine");
  EXPECT_EQ(wander("import tent.xml -o s.json --force").exit_code, 3);
  EXPECT_EQ(contents(folder / "s.json"), "mine");
  write("tiny.xml",
        "<scene version='3.0.0'><shape type='sphere'><float name='radius' value='1e-160'/>"
        "<emitter type='area'/></shape><sensor type='perspective'/></scene>");
  const Outcome tiny = wander("import tiny.xml -o s.json --force");
  EXPECT_EQ(tiny.exit_code, 3);
  EXPECT_HAS(tiny.err, "tiny.xml:1:24: /scene/shape: what comes of it is no valid scene");
  EXPECT_EQ(contents(folder / "s.json"), "mine");
  EXPECT_EQ(shell("ls -A | grep -c '^[.]'").out, "0\n");
}

TEST_F(Import, TellsItsUsage) {
  expect_one_fault(wander("import box.xml"), 2, {"needs -o SCENE.json"});
  expect_one_fault(wander("import box.xml -o -"), 2, {"name a file"});
  expect_one_fault(wander("import box.xml -o tent.xml --force"), 2, {"no XML; name it tent.json"});
  expect_one_fault(wander("import box.xml -o s.json -D width"), 2, {"-D NAME=VALUE"});
  expect_one_fault(wander("import none.xml -o s.json"), 3, {"none.xml:1:1: ", "no such file"});
  expect_one_fault(wander("import box.xml -o s.json -D height=3"), 3, {"the scene has no $height"});
  expect_one_fault(wander("import box.xml -o nowhere/s.json"), 1, {"nowhere/s.json"});
}

}  // namespace
}  // namespace wander::test

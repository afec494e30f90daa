// A scene is its text and what is in the meshes and textures that it names: where these change it is another, and where
// they move it can be found.
#include <nlohmann/json.hpp>

#include "records/run_json.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace scene_files_test {

using nlohmann::json;

constexpr const char* scene = R"({
  "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 3,
  "materials": { "plaster": { "type": "diffuse", "reflectance": 0.75 } },
  "shapes": [
    { "type": "mesh", "file": "tri.obj", "material": "plaster" },
    { "type": "sphere", "center": [0,0,2], "radius": 0.3, "light": { "radiance": 5 } } ],
  "camera": { "type": "perspective", "position": [0,0,1.5], "target": [0,0,0], "up": [0,1,0],
              "fov_deg": 60, "resolution": [4,3] }
})";
constexpr const char* large = "v -3 -3 0\nv 3 -3 0\nv 0 3 0\nf 1 2 3\n";
constexpr const char* small = "v -0.3 -0.3 0\nv 0.3 -0.3 0\nv 0 0.3 0\nf 1 2 3\n";

class SceneFiles : public CommandLine {
 protected:
  SceneFiles() {
    write("scene.json", scene);
    write("tri.obj", large);
  }
  void expect_refused(const std::string& arguments,
                      std::initializer_list<const char*> words) const {
    SCOPED_TRACE(arguments);
    const std::size_t before = entries();
    const Outcome outcome = wander(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    for (const char* word : words) EXPECT_HAS(outcome.err, word);
    EXPECT_EQ(entries(), before);
  }
  void render(const std::string& out, const std::string& seed) const {
    ASSERT_EQ(wander("render scene.json -m bdpt -b 2k -q -s " + seed + " -o " + out).exit_code, 0);
  }
};

TEST_F(SceneFiles, AreInTheRecordOfARun) {
  render("run", "1");
  const json recorded = json::parse(contents(folder / "run/run.json"))["scene"];
  const std::string sum = shell("sha256sum tri.obj").out;
  EXPECT_EQ(recorded["files"]["tri.obj"], sum.substr(0, 64));
  EXPECT_EQ(recorded["sha256"], shell("sha256sum scene.json").out.substr(0, 64));
  EXPECT_HAS(wander("inspect scene.json").out, sum.substr(0, 64).c_str());
  EXPECT_EQ(json::parse(wander("inspect scene.json --json").out)["files"], recorded["files"]);
}

TEST_F(SceneFiles, OfARunThatGoesOnAreWhatTheyWere) {
  render("run", "1");
  const std::string before = contents(folder / "run/checkpoint");
  write("tri.obj", small);
  expect_refused("render --continue -o run -b 4k", {"scene.json: what it names is not what it was",
                                                    "tri.obj (sha256 ", "put it back"});
  expect_refused("render scene.json --continue -o run -b 4k",
                 {"its scene has other files: tri.obj (sha256 "});
  EXPECT_EQ(contents(folder / "run/checkpoint"), before);
  write("tri.obj", large);
  EXPECT_EQ(wander("render scene.json --continue -o run -b 4k -q").exit_code, 0);
}

TEST_F(SceneFiles, OfRunsThatAreMergedAreTheSame) {
  render("a", "1");
  write("tri.obj", small);
  render("b", "2");
  expect_refused("merge a b -o both", {"its scene has other files: tri.obj"});
  expect_refused("merge a -o one", {"scene.json: what it names is not what it was"});
}

TEST_F(SceneFiles, AreFoundFromAnotherFolder) {
  render("a", "1");
  render("b", "2");
  ASSERT_EQ(wander("merge a b -q -o here").exit_code, 0);
  const auto elsewhere = [&](const std::string& arguments) {
    return shell("mkdir -p far && cd far && \"$WANDER\" " + arguments);
  };
  EXPECT_EQ(elsewhere("merge ../a ../b -q -o there").exit_code, 0);
  EXPECT_EQ(elsewhere("render --continue -o ../a -b 3k -q").exit_code, 0);
  const auto film = [&](const char* run) { return read_run(folder / run).rendering.film.value; };
  EXPECT_EQ(film("here"), film("far/there"));
}

// Whatever its path goes through.
TEST_F(SceneFiles, MayBeNamedInARoundaboutWay) {
  change("scene.json",
         [](std::string& text) { text.replace(text.find("tri.obj"), 7, "gone/../tri.obj"); });
  fs::create_directories(folder / "real/d");
  fs::create_directory_symlink(folder / "real/d", folder / "link");
  fs::rename(folder / "scene.json", folder / "real/scene.json");
  fs::rename(folder / "tri.obj", folder / "real/tri.obj");
  ASSERT_EQ(wander("render link/../scene.json -m bdpt -b 2k -q -o run").exit_code, 0);
  EXPECT_EQ(wander("render --continue -o run -b 4k -q").exit_code, 0);
}

TEST_F(SceneFiles, ThatHaveMovedAreToBeNamed) {
  render("a", "1");
  render("b", "2");
  fs::create_directory(folder / "moved");
  fs::rename(folder / "tri.obj", folder / "moved/tri.obj");
  fs::rename(folder / "scene.json", folder / "moved/scene.json");
  const Outcome lost = wander("merge a b -o both");
  EXPECT_EQ(lost.exit_code, 3);
  EXPECT_HAS(lost.err, "there is no such file");
  EXPECT_HAS(lost.err, "when it was kept: name it where it is now");
  EXPECT_EQ(wander("merge a b --scene moved/scene.json -q -o both").exit_code, 0);
  EXPECT_EQ(wander("render moved/scene.json --continue -o a -b 3k -q").exit_code, 0);
  write("moved/tri.obj", small);
  expect_refused("merge b --scene moved/scene.json -o one",
                 {"scene moved/scene.json is not that of the run: its scene has other files"});
}

// What has no other place may lie beside the run, as the package of Python keeps meshes of arrays.
TEST_F(SceneFiles, ThatAreGoneMayLieBesideTheRun) {
  fs::create_directory(folder / "away");
  fs::copy(folder / "scene.json", folder / "away/scene.json");
  fs::copy(folder / "tri.obj", folder / "away/tri.obj");
  for (const char* run : {"a", "b"})
    ASSERT_EQ(wander(std::string("render away/scene.json -m bdpt -b 2k -q -o ") + run + " -s " +
                     (run[0] == 'a' ? "1" : "2"))
                  .exit_code,
              0);
  fs::remove_all(folder / "away");
  EXPECT_EQ(wander("render --continue -o a -b 3k -q").exit_code, 3);
  for (const char* run : {"a", "b"}) fs::copy(folder / "tri.obj", folder / run / "tri.obj");
  EXPECT_EQ(wander("merge a b -o both -q").exit_code, 0);
  EXPECT_EQ(wander("render --continue -o a -b 3k -q").exit_code, 0);
  write("b/tri.obj", small);
  expect_refused("render --continue -o b -b 3k", {"what it names is not what it was"});
}

// A reference that was kept for the scene as it was would be taken for the truth of another.
TEST_F(SceneFiles, HaveReferencesOfTheirOwn) {
  const auto compare = [&](const std::string& out) {
    const Outcome outcome = shell(
        "XDG_CACHE_HOME=\"$PWD/cache\" \"$WANDER\" compare scene.json -m pt,bdpt -b 20k "
        "--replicates 2 -q -o " +
        out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json comparison = json::parse(contents(folder / out / "compare.json"));
    EXPECT_EQ(comparison["cells"].size(), 2u);
    double worst = 0;
    for (const json& cell : comparison["cells"])
      worst = std::max(worst, cell["relative_rmse"]["value"].get<double>());
    return worst;
  };
  EXPECT_LT(compare("first"), 0.2);
  write("tri.obj", small);
  EXPECT_LT(compare("second"), 0.2) << "beside a film of the large triangle most of it is missing";
  expect_refused("compare --continue -o first --replicates 3",
                 {"scene.json: what it names is not what it was"});
}

}  // namespace scene_files_test
}  // namespace wander::test

// `wander plot` of what is in space: a scene, a trajectory over its outline or over a film, and the
// paths as lines for other programs.
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "records/trajectory_netcdf.h"
#include "tests/support/space_scene_text.h"
#include "tests/tools/command_line.h"

namespace wander::test {
namespace {

class SpacePlot : public CommandLine {
 protected:
  SpacePlot() { write("room.json", grey_room()); }

  void record(const std::string& more = "--steps 60 --chains 2") const {
    ASSERT_EQ(wander("trace room.json " + more + " -q -o steps.nc").exit_code, 0);
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST_F(SpacePlot, DrawsASceneAlone) {
  EXPECT_EQ(wander("plot room.json -o room.svg").exit_code, 0);
  EXPECT_HAS(contents(folder / "room.svg"), "class=\"wireframe\"");
  for (const char* scene : {"cornell", "ring", "pool"})  // meshes too
    EXPECT_EQ(wander("plot gallery:" + std::string(scene) + " --force -o a.pdf").exit_code, 0);
}

TEST_F(SpacePlot, DrawsATrajectoryOverTheOutline) {
  record();
  const Outcome all = wander("plot steps.nc -o all.svg --json");
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(nlohmann::json::parse(all.out)["kind"], "trajectory");
  const std::string svg = contents(folder / "all.svg");
  for (const char* part : {"class=\"wireframe\"", "class=\"accepted\"", "x solid and y dashed",
                           "x on the film", "y on the film"})
    EXPECT_HAS(svg, part);
  const Trajectory t = read_trajectory(folder / "steps.nc").trajectory;
  std::size_t accepted = 0, rejected = 0;
  for (std::size_t i = 0; i < 24; ++i)
    if (t.proposed.vertices[i] > 2) ++(t.accepted[i] != 0 ? accepted : rejected);
  ASSERT_EQ(wander("plot steps.nc --figure paths -o paths.svg").exit_code, 0);
  const std::string paths = contents(folder / "paths.svg");
  EXPECT_EQ(count(paths, "class=\"accepted\""), accepted);
  EXPECT_EQ(count(paths, "class=\"rejected\""), rejected);
  for (const char* figure : {"trace", "acceptance", "autocorrelation"})
    EXPECT_EQ(wander("plot steps.nc --force -o a.svg --figure " + std::string(figure)).exit_code,
              0);
}

// Where it was recorded, the scene and its meshes need not be.
TEST_F(SpacePlot, NeedsNoSceneFile) {
  ASSERT_EQ(wander("gallery ring -o ring.json").exit_code, 0);
  ASSERT_EQ(wander("trace ring.json --steps 4 --chains 1 -q -o steps.nc").exit_code, 0);
  fs::remove(folder / "ring.json");
  fs::remove_all(folder / "meshes");
  ASSERT_EQ(wander("plot steps.nc --figure paths -o paths.svg").exit_code, 0);
  ASSERT_EQ(wander("plot gallery:ring -o ring.svg").exit_code, 0);
  EXPECT_GT(contents(folder / "paths.svg").size(), contents(folder / "ring.svg").size());
}

TEST_F(SpacePlot, DrawsItOverAFilm) {
  record("--steps 4 --chains 1");
  ASSERT_EQ(wander("render room.json -m pt -b 2k -q -o film").exit_code, 0);
  ASSERT_EQ(wander("plot steps.nc film --figure paths --exposure 1 -o over.svg").exit_code, 0);
  EXPECT_EQ(count(contents(folder / "over.svg"), "data:image/png"), 1u);
  write("wide.json", grey_room(24, 8));
  ASSERT_EQ(wander("render wide.json -m pt -b 2k -q -o wide").exit_code, 0);
  expect_one_fault(wander("plot steps.nc wide -o a.svg"), 2, {"24 x 8 pixels", "12 x 8"});
  expect_one_fault(wander("plot steps.nc room.json -o a.svg"), 2, {"room.json is no image"});
  expect_one_fault(wander("plot steps.nc film film -o a.svg"), 2, {"one at a time"});
  expect_one_fault(wander("plot steps.nc --exposure 1 -o a.svg"), 2, {"--exposure is for images"});
  expect_one_fault(wander("plot steps.nc --figure density -o a.svg"), 2, {"of the plane"});
}

// Read as other programs do: vertices are counted from 1, through all objects.
TEST_F(SpacePlot, WritesPathsAsLines) {
  record();
  ASSERT_EQ(wander("plot steps.nc -o paths.obj").exit_code, 0);
  const Trajectory t = read_trajectory(folder / "steps.nc").trajectory;
  std::istringstream text(contents(folder / "paths.obj"));
  std::vector<std::array<double, 3>> vertices;
  std::map<std::string, std::vector<std::vector<std::size_t>>> lines;
  std::string object;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "o") words >> object;
    if (word == "v")
      words >> vertices.emplace_back()[0] >> vertices.back()[1] >> vertices.back()[2];
    if (word == "l")
      for (std::size_t index; words >> index;) {
        if (line.find("l " + std::to_string(index)) == 0) lines[object].emplace_back();
        ASSERT_LE(index, vertices.size());
        lines[object].back().push_back(index);
      }
  }
  std::size_t accepted = 0, rejected = 0;
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.proposed.vertices[i] == 0) continue;
    if (t.accepted[i] != 0 && !first) first = i;
    ++(t.accepted[i] != 0 ? accepted : rejected);
  }
  EXPECT_EQ(lines["accepted"].size(), accepted);
  EXPECT_EQ(lines["rejected"].size(), rejected);
  EXPECT_EQ(lines["start"].size(), 2u);
  ASSERT_TRUE(first);
  const std::vector<std::size_t>& path = lines["accepted"].front();
  ASSERT_EQ(path.size(), static_cast<std::size_t>(t.proposed.vertices[*first]));
  for (std::size_t k = 0; k < path.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(
          vertices[path[k] - 1][axis],
          t.proposed.position[(*first * static_cast<std::size_t>(t.max_vertices) + k) * 3 + axis]);
}

TEST_F(SpacePlot, LinesAreOfOneTrajectoryInSpace) {
  record("--steps 4 --chains 1");
  ASSERT_EQ(wander("trace box.json --steps 4 --chains 1 -q -o flat.nc").exit_code, 0);
  expect_one_fault(wander("plot flat.nc -o a.obj"), 2, {"flat.nc", "in the plane"});
  expect_one_fault(wander("plot room.json -o a.obj"), 2, {"a.obj", "room.json is none"});
  expect_one_fault(wander("plot steps.nc --figure paths -o a.obj"), 2, {"without --figure"});
  expect_one_fault(wander("plot steps.nc --dpi 100 -o a.obj"), 2, {"--dpi is for FILE.png"});
  expect_one_fault(wander("plot steps.nc -o a.gif"), 2, {"a.gif", ".svg, .png or .pdf", ".obj"});
  ASSERT_EQ(wander("plot steps.nc -o a.obj").exit_code, 0);
  EXPECT_EQ(wander("plot steps.nc -o a.obj").exit_code, 2);  // it exists
  EXPECT_FALSE(exists("a.gif"));
}

}  // namespace
}  // namespace wander::test

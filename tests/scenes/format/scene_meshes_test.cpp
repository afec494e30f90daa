// Meshes of a scene: found in its folder and nowhere else, put where their transforms say.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/requirements.h"
#include "tests/scenes/format/space_texts.h"

namespace wander {
namespace {

namespace fs = std::filesystem;

const std::string one_triangle = "v 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\n";

class SceneFolder : public ::testing::Test {
 protected:
  SceneFolder() { fs::create_directories(place_ / "scene" / "in"); }
  ~SceneFolder() override { fs::remove_all(place_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(place_ / name) << text;
  }
  // Of a scene with this mesh: members beside its type.
  SceneDocument read(const std::string& members) const {
    write("scene/s.json", with_solid("{ \"type\": \"mesh\", " + members + " }"));
    return read_scene_file(place_ / "scene" / "s.json");
  }
  Triangles mesh(const std::string& members) const {
    return *std::get<description::Mesh>(read(members).scene.shapes[2].kind).triangles;
  }
  std::string fault(const std::string& members, const std::string& key = "file") const {
    try {
      read(members);
    } catch (const SceneFileError& error) {
      EXPECT_EQ(error.faults.size(), 1u);
      EXPECT_EQ(error.faults[0].pointer, "/shapes/2/" + key);
      return error.faults[0].what;
    }
    return "";
  }

  fs::path place_ = fs::temp_directory_path() / ("wander-meshes-" + std::to_string(getpid()));
};

TEST_F(SceneFolder, HoldsItsMeshes) {
  write("scene/in/a.OBJ", one_triangle);
  EXPECT_EQ(mesh(R"("file": "in/a.OBJ")").points[1], (std::array{0.0, 2.0, 0.0}));
  EXPECT_EQ(mesh(R"("file": "in/../in/./a.OBJ")").corners.size(), 1u);
}

TEST_F(SceneFolder, MayBeTheOneInWhichWeStand) {
  write("scene/a.obj", one_triangle);
  write("scene/s.json", with_solid(R"({ "type": "mesh", "file": "a.obj" })"));
  const fs::path before = fs::current_path();
  fs::current_path(place_ / "scene");
  EXPECT_EQ(read_scene_file("s.json").scene.shapes.size(), 3u);
  fs::current_path(before);
}

TEST_F(SceneFolder, HasMeshesThatAreMoved) {
  write("scene/a.obj", one_triangle);
  const Triangles moved = mesh(R"("file": "a.obj",
    "transform": [[2, 0, 0, 10], [0, 0, 1, 20], [0, -1, 0, 30], [0, 0, 0, 1]])");
  EXPECT_EQ(moved.points[0], (std::array{12.0, 20.0, 30.0}));
  EXPECT_EQ(moved.points[1], (std::array{10.0, 20.0, 28.0}));
  EXPECT_EQ(moved.points[2], (std::array{10.0, 23.0, 30.0}));
  EXPECT_EQ(moved.corners[0], (std::array{0, 1, 2}));
}

TEST_F(SceneFolder, TurnsMirrorImagesRound) {
  write("scene/a.obj", one_triangle);
  const Triangles mirrored = mesh(R"("file": "a.obj",
    "transform": [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])");
  EXPECT_EQ(mirrored.points[0], (std::array{-1.0, 0.0, 0.0}));
  EXPECT_EQ(mirrored.corners[0], (std::array{0, 2, 1}));
}

// Normals stay at right angles to what they are normals of, and have the length 1.
TEST_F(SceneFolder, MovesNormalsByTheInverseTransposed) {
  write("scene/a.obj",
        "v 1 0 0\nv 0 2 0\nv 0 0 3\nvn 0 0 2\nvn 3 0 4\nvn 0 0 0\nf 1//1 2//2 3//3\n");
  const std::string smooth = R"("file": "a.obj", "normals": "smooth")";
  const Triangles unmoved = mesh(smooth);
  EXPECT_EQ(unmoved.normals[0], (std::array{0.0, 0.0, 1.0}));
  EXPECT_EQ(unmoved.normals[2], (std::array{0.0, 0.0, 0.0}));
  const Triangles moved =
      mesh(smooth + R"(, "transform": [[2, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3]])");
  const double length = std::hypot(1.5, 4);
  EXPECT_NEAR(moved.normals[1][0], 1.5 / length, 1e-15);
  EXPECT_NEAR(moved.normals[1][2], 4 / length, 1e-15);
  const Triangles mirrored =
      mesh(smooth + R"(, "transform": [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])");
  EXPECT_NEAR(mirrored.normals[1][0], -0.6, 1e-15);
  EXPECT_NEAR(mirrored.normals[1][2], 0.8, 1e-15);
  EXPECT_EQ(mirrored.corners[0], (std::array{0, 2, 1}));
  EXPECT_EQ(mirrored.normal_corners[0], (std::array{0, 2, 1}));
  EXPECT_TRUE(mesh(R"("file": "a.obj", "normals": "flat")").normals.empty());
  EXPECT_TRUE(mesh(R"("file": "a.obj")").normals.empty());
}

TEST_F(SceneFolder, TellsOfMeshesThatHaveNoNormals) {
  write("scene/a.obj", one_triangle);
  EXPECT_EQ(fault(R"("file": "a.obj", "normals": "smooth")", "normals"),
            "a.obj has no normals; give its corners normals, or say \"flat\"");
  EXPECT_EQ(fault(R"("file": "a.obj", "normals": "round")", "normals"),
            "\"round\" is not known; the nearest is \"flat\"; allowed are flat, smooth");
}

// A file may be shaded in one place and not in another.
TEST_F(SceneFolder, KnowsFlatMeshesFromSmoothOnes) {
  write("scene/a.obj", "v 1 0 0\nv 0 2 0\nv 0 0 3\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  write("scene/s.json", with_solid(R"({ "type": "mesh", "file": "a.obj" },
    { "type": "mesh", "file": "a.obj", "normals": "smooth" })"));
  const auto scene = read_scene_file(place_ / "scene" / "s.json").scene;
  const auto normals = [&](std::size_t shape) {
    return std::get<description::Mesh>(scene.shapes[shape].kind).triangles->normals.size();
  };
  EXPECT_EQ(normals(2), 0u);
  EXPECT_EQ(normals(3), 1u);
  EXPECT_TRUE(requires_of(scene).smooth_normals);
}

TEST_F(SceneFolder, IsNotLeft) {
  write("secret.obj", one_triangle);
  fs::create_directory(place_ / "scene-too");
  write("scene-too/a.obj", one_triangle);
  fs::create_symlink("../secret.obj", place_ / "scene" / "link.obj");
  fs::create_directory_symlink("..", place_ / "scene" / "up");
  for (const std::string file : {"../secret.obj", "in/../../secret.obj", "link.obj",
                                 "up/secret.obj", "../scene-too/a.obj", "../none.obj"})
    EXPECT_NE(fault("\"file\": \"" + file + "\"").find("leads out of the scene's folder"),
              std::string::npos)
        << file;
  EXPECT_NE(fault("\"file\": \"" + (place_ / "secret.obj").string() + "\"").find("absolute"),
            std::string::npos);
  fs::create_symlink("in", place_ / "scene" / "within");
  write("scene/in/a.obj", one_triangle);
  EXPECT_EQ(mesh(R"("file": "within/a.obj")").corners.size(), 1u);
}

TEST_F(SceneFolder, TellsWhatIsWrongWithAFile) {
  write("scene/a.obj", "v 0 0 0\nf 1 1 2\n");
  write("scene/empty.obj", "v 0 0 0\n");
  write("scene/a.stl", one_triangle);
  write("scene/far.obj", "v 1e50 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
  EXPECT_EQ(fault(R"("file": "none.obj")"), "none.obj: there is no such file; check the path");
  EXPECT_EQ(fault(R"("file": "a.obj")"), "a.obj: line 2: there is no corner 2; the file has 1");
  EXPECT_EQ(fault(R"("file": "empty.obj")"),
            "empty.obj: the file has no face; a mesh has one or more");
  EXPECT_EQ(fault(R"("file": "a.stl")"),
            "a.stl: the ending \".stl\" is not known; a mesh is .obj or .ply");
  fs::create_directory(place_ / "scene" / "folder.obj");
  EXPECT_EQ(fault(R"("file": "folder.obj")"),
            "folder.obj: this is no file of data; name an OBJ or PLY file");
  EXPECT_EQ(fault(R"("file": "far.obj",
    "transform": [[1e20, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])"),
            "far.obj: the transform leads beyond 1e60, the largest coordinate");
}

TEST_F(SceneFolder, TellsFaultsOfMeshesBesideThoseOfTheScene) {
  write("scene/s.json", with_solid(R"({ "type": "mesh", "file": "none.obj" },
    { "type": "mesh", "file": "none.obj", "materiel": "x" },
    { "type": "sphere", "center": [0, 0, 0], "radius": -1 })"));
  try {
    read_scene_file(place_ / "scene" / "s.json");
    FAIL();
  } catch (const SceneFileError& error) {
    ASSERT_EQ(error.faults.size(), 3u);
    EXPECT_EQ(error.faults[0].pointer, "/shapes/2/file");
    EXPECT_EQ(error.faults[1].pointer, "/shapes/3/materiel");
    EXPECT_EQ(error.faults[2].pointer, "/shapes/4/radius");
  }
}

}  // namespace
}  // namespace wander

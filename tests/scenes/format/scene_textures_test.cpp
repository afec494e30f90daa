// Textures of a scene: PNG files found in its folder and nowhere else, on what has texture coordinates.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/requirements.h"
#include "scenes/format/texture_file.h"
#include "tests/scenes/format/space_texts.h"
#include "tests/support/png_file.h"

namespace wander {
namespace {

namespace fs = std::filesystem;
using Colour = std::array<double, 3>;
using test::write_png;

const std::string sheet = R"({ "type": "parallelogram", "origin": [0, 0, 0],
    "edges": [[1, 0, 0], [0, 1, 0]], "material": "m" })";

class TexturedScene : public ::testing::Test {
 protected:
  TexturedScene() { fs::create_directories(place_ / "scene" / "in"); }
  ~TexturedScene() override { fs::remove_all(place_); }

  fs::path file(const std::string& name) const { return place_ / "scene" / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name)) << text;
  }
  static std::string text(const std::string& reflectance, const std::string& shape = sheet,
                          const std::string& type = "\"diffuse\"") {
    std::string text = with_solid(shape);
    const std::string key = "\"materials\": {";
    EXPECT_EQ(text.find(key), std::string::npos);
    return text.insert(
        text.find("\"shapes\""),
        key + " \"m\": { \"type\": " + type + ", \"reflectance\": " + reflectance + " } },\n  ");
  }
  SceneDocument read(const std::string& scene) const {
    write("s.json", scene);
    return read_scene_file(file("s.json"));
  }
  // Of the only fault, with its place.
  std::string fault(const std::string& scene) const {
    try {
      read(scene);
    } catch (const SceneFileError& error) {
      EXPECT_EQ(error.faults.size(), 1u) << error.what();
      return error.faults[0].pointer + ": " + error.faults[0].what;
    }
    return "";
  }
  description::Quantity reflectance(const SceneDocument& document) const {
    return std::get<description::Diffuse>(document.scene.materials[0].kind).reflectance;
  }

  fs::path place_ = fs::temp_directory_path() / ("wander-textures-" + std::to_string(getpid()));
};

constexpr const char* picture = R"({ "texture": "in/a.png" })";

// 188 is 0.5028865 [IEC 61966-2-1].
TEST_F(TexturedScene, HasTheColoursOfItsPictures) {
  write_png(file("in/a.png"), 2, 1, {255, 0, 0, 0, 188, 255});
  const SceneDocument document = read(text(picture));
  const auto said = reflectance(document);
  ASSERT_NE(said.texture, nullptr);
  EXPECT_TRUE(said.coloured);
  EXPECT_EQ(said.texture->at({0.25, 0.5}), (Colour{1, 0, 0}));
  const Colour right = said.texture->at({0.75, 0.5});
  EXPECT_NEAR(right[1], 0.5028865, 1e-7);
  EXPECT_EQ(right[2], 1);
  EXPECT_EQ(said.channels, said.texture->mean());
  EXPECT_TRUE(requires_of(document.scene).textures);
  EXPECT_EQ(requires_of(document.scene).colour_channels, 3);
  EXPECT_FALSE(requires_of(read(text("0.5")).scene).textures);
}

TEST_F(TexturedScene, ReadsPicturesOfAllKinds) {
  const auto expect_of = [&](Colour left, Colour right, bool coloured) {
    const auto texture = read_texture(file("in/a.png"));
    EXPECT_EQ(texture->is_coloured(), coloured);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(texture->at({0.25, 0.5})[k], left[k], 1e-7);
      EXPECT_NEAR(texture->at({0.75, 0.5})[k], right[k], 1e-7);
    }
  };
  const double half = 0.5028865;
  write_png(file("in/a.png"), 2, 1, {188, 0}, {PNG_COLOR_TYPE_GRAY, 8});
  expect_of({half, half, half}, {0, 0, 0}, false);
  write_png(file("in/a.png"), 2, 1, {0x80}, {PNG_COLOR_TYPE_GRAY, 1});
  expect_of({1, 1, 1}, {0, 0, 0}, false);
  write_png(file("in/a.png"), 2, 1, {188, 7, 255, 0}, {PNG_COLOR_TYPE_GRAY_ALPHA, 8});
  expect_of({half, half, half}, {1, 1, 1}, false);
  write_png(file("in/a.png"), 2, 1, {255, 0, 188, 0, 0, 255, 0, 9}, {PNG_COLOR_TYPE_RGB_ALPHA, 8});
  expect_of({1, 0, half}, {0, 1, 0}, true);
  write_png(file("in/a.png"), 2, 1, {0x40},
            {PNG_COLOR_TYPE_PALETTE, 2, {{188, 0, 0}, {0, 0, 255}}});
  expect_of({0, 0, 1}, {half, 0, 0}, true);
  // 0x8001 is 32769/65535.
  write_png(file("in/a.png"), 2, 1, {0x80, 0x01, 0xff, 0xff}, {PNG_COLOR_TYPE_GRAY, 16});
  const double middle = linear_of_srgb(32769.0 / 65535);
  expect_of({middle, middle, middle}, {1, 1, 1}, false);
  write_png(file("in/a.png"), 2, 1, {0, 0, 0x80, 0x01, 0xff, 0xff, 0xff, 0xff, 0, 0, 0, 1},
            {PNG_COLOR_TYPE_RGB, 16});
  expect_of({0, middle, 1}, {1, 0, 1 / 65535.0 / 12.92}, true);
}

TEST_F(TexturedScene, GivesMirrorsAndRoughConductorsTexturesToo) {
  write_png(file("in/a.png"), 1, 1, {188}, {PNG_COLOR_TYPE_GRAY, 8});
  const auto mirror = read(text(picture, sheet, "\"mirror\"")).scene;
  EXPECT_NE(std::get<description::Mirror>(mirror.materials[0].kind).reflectance.texture, nullptr);
  EXPECT_EQ(requires_of(mirror).colour_channels, 1);
  EXPECT_TRUE(requires_of(mirror).textures);
  const auto metal = read(text(picture, sheet, R"("rough_conductor", "roughness": 0.2)")).scene;
  EXPECT_TRUE(requires_of(metal).textures);
}

TEST_F(TexturedScene, TellsWhatIsWrongWithAFile) {
  EXPECT_EQ(fault(text(picture)),
            "/materials/m/reflectance/texture: in/a.png: there is no such file; check the path");
  write("in/a.png", "no picture");
  EXPECT_NE(fault(text(picture)).find("this is no PNG that can be read"), std::string::npos);
  write_png(file("in/a.png"), 64, 64, std::vector<png_byte>(64 * 64 * 3, 77));
  fs::resize_file(file("in/a.png"), 60);
  EXPECT_NE(fault(text(picture)).find("this is no PNG that can be read"), std::string::npos);
  fs::remove(file("in/a.png"));
  fs::create_directory(file("in/a.png"));
  EXPECT_EQ(fault(text(picture)),
            "/materials/m/reflectance/texture: in/a.png: this is no file of data; name a PNG file");
}

TEST_F(TexturedScene, DoesNotLeaveItsFolder) {
  write_png(place_ / "secret.png", 1, 1, {1, 2, 3});
  fs::create_symlink("../../secret.png", file("in/a.png"));
  const std::string out =
      "the path leads out of the scene's folder; textures lie in it, or in folders in it";
  EXPECT_EQ(fault(text(picture)), "/materials/m/reflectance/texture: in/a.png: " + out);
  EXPECT_EQ(fault(text(R"({ "texture": "../secret.png" })")),
            "/materials/m/reflectance/texture: ../secret.png: " + out);
  EXPECT_NE(fault(text("{ \"texture\": \"" + (place_ / "secret.png").string() + "\" }"))
                .find("a texture's path is relative to the scene"),
            std::string::npos);
  try {
    parse_scene(text(picture), "scene");
    FAIL();
  } catch (const SceneFileError& error) {
    EXPECT_NE(std::string(error.what()).find("no folder to look for textures in"),
              std::string::npos);
  }
}

TEST_F(TexturedScene, TellsOfReflectancesThatAreNone) {
  EXPECT_EQ(fault(text("{ \"texture\": 1 }")),
            "/materials/m/reflectance/texture: 1 is not a text; a texture is the path of a PNG "
            "file, relative to the scene");
  EXPECT_NE(fault(text("{ \"textur\": \"a.png\", \"texture\": \"a.png\" }"))
                .find("unknown key \"textur\""),
            std::string::npos);
  EXPECT_NE(fault(text("{}")).find("\"texture\" is missing"), std::string::npos);
}

// ---- what it lies on

TEST_F(TexturedScene, HasTexturesOnlyWhereThereAreCoordinates) {
  write_png(file("in/a.png"), 1, 1, {1, 2, 3});
  EXPECT_EQ(fault(text(picture, R"({ "type": "sphere", "center": [0, 0, 0], "radius": 1,
                               "material": "m" })")),
            "/shapes/2/material: \"m\" has a texture, and a sphere no texture coordinates; a "
            "texture lies "
            "on a parallelogram or a mesh");
  EXPECT_NE(fault(text(picture, R"({ "type": "triangle", "material": "m",
                                     "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]] })"))
                .find("a triangle no texture coordinates"),
            std::string::npos);
}

TEST_F(TexturedScene, FindsThemInObjFiles) {
  write_png(file("in/a.png"), 1, 1, {1, 2, 3});
  const std::string shape = R"({ "type": "mesh", "file": "a.obj", "material": "m" })";
  const auto mesh = [&](const std::string& scene) {
    return *std::get<description::Mesh>(read(scene).scene.shapes[2].kind).triangles;
  };
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  write("a.obj", points + "vt 0.5 0.25\nvt 1 2 0\nvt -3 4\nf 1/1 2/2 4/3 3/1\n");
  const Triangles triangles = mesh(text(picture, shape));
  EXPECT_EQ(triangles.coordinates[1], (std::array{1.0, 2.0}));
  EXPECT_EQ(triangles.coordinate_corners[1], (std::array{0, 2, 0}));
  EXPECT_TRUE(mesh(text("0.5", shape)).coordinates.empty());
  EXPECT_TRUE(mesh(text("0.5", shape)).coordinate_corners.empty());
  const std::string mirrored = R"({ "type": "mesh", "file": "a.obj", "material": "m",
      "transform": [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]] })";
  EXPECT_EQ(mesh(text(picture, mirrored)).coordinate_corners[0], (std::array{0, 2, 1}));
  write("a.obj", points + "vn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3//1\n");
  EXPECT_EQ(fault(text(picture, shape)),
            "/shapes/2/file: a.obj: line 7: a corner without texture coordinates, which its "
            "material's texture needs; a corner with them is v/vt");
  write("a.obj", points + "vt 0 0\nf 1/1 2/1 3/2\n");
  EXPECT_EQ(fault(text(picture, shape)),
            "/shapes/2/file: a.obj: line 6: there is no texture coordinate 2; the file has 1");
}

TEST_F(TexturedScene, FindsThemInPlyFiles) {
  write_png(file("in/a.png"), 1, 1, {1, 2, 3});
  const std::string shape = R"({ "type": "mesh", "file": "a.ply", "material": "m" })";
  const auto ply = [](const std::string& u, const std::string& v) {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nproperty float " +
           u + "\nproperty float " + v +
           "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 0.5 1\n1 0 0 2 3\n0 1 0 4 5\n3 0 1 2\n";
  };
  for (const auto& [u, v] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}}) {
    write("a.ply", ply(u, v));
    const auto scene = read(text(picture, shape)).scene;
    const auto& mesh = *std::get<description::Mesh>(scene.shapes[2].kind).triangles;
    EXPECT_EQ(mesh.coordinates[2], (std::array{4.0, 5.0}));
    EXPECT_TRUE(mesh.coordinate_corners.empty());
  }
  write("a.ply", ply("u", "w"));
  EXPECT_NE(fault(text(picture, shape)).find("a vertex without texture coordinates"),
            std::string::npos);
}

}  // namespace
}  // namespace wander

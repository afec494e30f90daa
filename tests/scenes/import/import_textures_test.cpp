// Bitmaps of Mitsuba that stay pictures, and where they lie.  As Mitsuba 3.9 has it: v runs down a
// picture, and up in an OBJ file.
#include "scenes/format/scene_file.h"
#include "tests/scenes/import/import_folder.h"
#include "tests/support/png_file.h"

namespace wander::test {
namespace {

using Uv = std::array<double, 2>;

class ImportedTextures : public ImportFolder {
 protected:
  ImportedTextures() {
    fs::create_directories(place_ / "in");
    write_png(place_ / "in/my q.png", 2, 1, {255, 0, 0, 0, 0, 255});
    write("a.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.1 0.2\nvt 0.6 0.2\nvt 0.1 0.9\nf 1/1 2/2 3/3\n");
    write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("a.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
          "float z\nproperty double u\nproperty double v\nelement face 1\nproperty list uchar int "
          "vertex_indices\nend_header\n0 0 0 0.1 0.2\n1 0 0 0.6 0.2\n0 1 0 0.1 0.9\n3 0 1 2\n");
  }

  static std::string bsdf(const std::string& properties = "") {
    return "<bsdf type='twosided'><bsdf type='diffuse'><texture type='bitmap' name='reflectance'>"
           "<string name='filename' value='in/my q.png'/>" +
           properties + "</texture></bsdf></bsdf>";
  }
  static std::string shape(const std::string& type, const std::string& properties,
                           const std::string& of_texture = "") {
    return scene_of("<shape type='" + type + "'>" + properties + bsdf(of_texture) + "</shape>");
  }
  static std::string file(const std::string& name) {
    return "<string name='filename' value='" + name + "'/>";
  }
  // Of the first triangle of the first shape.
  std::array<Uv, 3> coordinates(const std::string& xml) const {
    exact(xml);
    const SceneDocument read = parse_scene(scene(xml).text, "scene", files_in(place_));
    const auto& mesh = *std::get<description::Mesh>(read.scene.shapes[0].kind).triangles;
    const auto& numbers =
        (mesh.coordinate_corners.empty() ? mesh.corners : mesh.coordinate_corners)[0];
    const auto at = [&](std::int32_t i) { return mesh.coordinates[static_cast<std::size_t>(i)]; };
    return {at(numbers[0]), at(numbers[1]), at(numbers[2])};
  }
  static void expect_places(const std::array<Uv, 3>& found, const std::array<Uv, 3>& expected) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 2; ++axis)
        EXPECT_NEAR(found[i][axis], expected[i][axis], 1e-12) << i << ' ' << axis;
  }
};

TEST_F(ImportedTextures, AreCopiedBesideTheScene) {
  const Json scene = exact(shape("obj", file("a.obj")));
  EXPECT_EQ(
      scene["materials"]["diffuse"],
      Json::parse(R"({"type": "diffuse", "reflectance": {"texture": "scene-meshes/my_q.png"}})"));
  EXPECT_EQ(scene["shapes"][0]["file"], "scene-meshes/a.obj");
  const auto bytes = [&](const char* name) {
    std::ifstream stream(place_ / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  EXPECT_EQ(bytes("scene-meshes/my_q.png"), bytes("in/my q.png"));
  EXPECT_EQ(bytes("scene-meshes/a.obj"), bytes("a.obj"));
}

TEST_F(ImportedTextures, LieAsInMitsuba) {
  const std::array<Uv, 3> as_in_file{{{0.1, 0.2}, {0.6, 0.2}, {0.1, 0.9}}},
      turned{{{0.1, 0.8}, {0.6, 0.8}, {0.1, 0.1}}};
  const auto flip = [](const std::string& flag) {
    return "<boolean name='flip_tex_coords' value='" + flag + "'/>";
  };
  expect_places(coordinates(shape("obj", file("a.obj"))), as_in_file);
  expect_places(coordinates(shape("obj", file("a.obj") + flip("false"))), turned);
  expect_places(coordinates(shape("ply", file("a.ply"))), turned);
  expect_places(coordinates(shape("ply", file("a.ply") + flip("true"))), as_in_file);
  // Of the corners (-1, -1), (1, -1) and (1, 1).
  expect_places(coordinates(shape("rectangle", "")), {{{0, 1}, {1, 1}, {1, 0}}});
}

// v in Mitsuba is 1 - 0.2 = 0.8 at the first corner; 3 · 0.8 + 0.5 = 2.9 is -1.9 from below.
TEST_F(ImportedTextures, LieWhereTheirTransformsSay) {
  const std::string to_uv =
      "<transform name='to_uv'><scale x='2' y='3'/><translate y='0.5'/></transform>";
  expect_places(coordinates(shape("obj", file("a.obj"), to_uv)),
                {{{0.2, -1.9}, {1.2, -1.9}, {0.2, 0.2}}});
  expect_places(coordinates(shape("rectangle", "", to_uv)), {{{0, 0.5}, {2, 0.5}, {2, -2.5}}});
}

TEST_F(ImportedTextures, AreTheirMeansWhereTheyCannotBeSaid) {
  const auto mean = [&](const std::string& xml) {
    expect_near(approximate(xml, "the bitmap")["materials"]["diffuse"]["reflectance"],
                {0.5, 0, 0.5}, 1e-12);
  };
  mean(shape("sphere", ""));
  mean(shape("cube", ""));
  mean(shape("obj", file("bare.obj")));
  for (const char* property :
       {"<boolean name='raw' value='true'/>", "<string name='wrap_mode' value='clamp'/>",
        "<string name='filter_type' value='nearest'/>"})
    mean(shape("obj", file("a.obj"), property));
}

// One bsdf on two shapes, of which one has no coordinates.
TEST_F(ImportedTextures, AreMeansOnlyWhereTheyMustBe) {
  const std::string xml = scene_of(
      "<bsdf type='diffuse' id='wall'><texture type='bitmap' name='reflectance'>" +
      file("in/my q.png") + "</texture></bsdf><shape type='sphere'><ref id='wall'/></shape>" +
      "<shape type='obj'><transform name='to_world'><translate z='5'/></transform>" +
      file("a.obj") + "<ref id='wall'/></shape>");
  const Json json = approximate(xml, "the bitmap");
  EXPECT_EQ(json["shapes"][0]["material"], "wall");
  EXPECT_EQ(json["shapes"][1]["material"], "wall_2");
  EXPECT_TRUE(json["materials"]["wall_2"]["reflectance"].contains("texture"));
}

}  // namespace
}  // namespace wander::test

// Scene files: valid ones arrive with all their values, others with their faults.
#include "scenes/format/scene_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <filesystem>
#include <fstream>

#include "scenes/format/sha256.h"
#include "tests/scenes/format/scene_texts.h"

namespace wander::description::scene_file_test {
namespace {

const Quantity grey(double value) { return {{value, value, value}, false}; }

TEST(SceneFile, KeepsNamesAndLimits) {
  const SceneDocument document = parse(everything);
  EXPECT_EQ(document.scene.name, "all");
  EXPECT_EQ(document.scene.description, "é");
  EXPECT_EQ(document.scene.dimension, 2);
  EXPECT_EQ(document.scene.max_vertices, 12);
  EXPECT_FALSE(document.scene.camera.has_value());
  EXPECT_EQ(document.text, everything);
  EXPECT_EQ(document.digest.text, sha256(everything));
}

TEST(SceneFile, KeepsEveryMaterialInItsOrder) {
  const std::vector<Material> materials = parse(everything).scene.materials;
  ASSERT_EQ(materials.size(), 7u);
  EXPECT_EQ(materials[0].name, "z");
  EXPECT_EQ(std::get<Diffuse>(materials[0].kind).reflectance.channels, grey(0.75).channels);
  EXPECT_FALSE(std::get<Diffuse>(materials[0].kind).reflectance.coloured);
  EXPECT_EQ(std::get<Mirror>(materials[1].kind).reflectance.channels, grey(1).channels);
  EXPECT_EQ(std::get<Dielectric>(materials[2].kind).interior_index, 1.5);
  EXPECT_EQ(std::get<Dielectric>(materials[2].kind).exterior_index, 1.0);
  EXPECT_EQ(std::get<Dielectric>(materials[3].kind).exterior_index, 1.33);
  EXPECT_EQ(std::get<RoughConductor>(materials[4].kind).roughness, 0.2);
  EXPECT_EQ(std::get<RoughConductor>(materials[4].kind).reflectance.channels, grey(0.9).channels);
  EXPECT_EQ(std::get<RoughDielectric>(materials[5].kind).roughness, 1e-5);
  EXPECT_EQ(std::get<RoughDielectric>(materials[5].kind).interior_index, 2);
  EXPECT_EQ(std::get<RoughDielectric>(materials[5].kind).exterior_index, 0.5);
  EXPECT_TRUE(std::holds_alternative<Black>(materials[6].kind));
}

TEST(SceneFile, KeepsEveryShapeWithItsPlace) {
  const std::vector<Shape> shapes = parse(everything).scene.shapes;
  ASSERT_EQ(shapes.size(), 4u);
  const auto& segment = std::get<Segment>(shapes[0].kind);
  EXPECT_EQ(segment.from, (Coordinates{0.1, -2e-310, 0}));
  EXPECT_EQ(segment.to, (Coordinates{3, 4, 0}));
  EXPECT_EQ(shapes[0].material, 1u);
  EXPECT_EQ(shapes[0].id, "s");
  EXPECT_EQ(std::pair(shapes[0].line, shapes[0].column), std::pair(15, 5));

  const auto& polyline = std::get<Polyline>(shapes[1].kind);
  EXPECT_EQ(polyline.points, (std::vector<Coordinates>{{5, 5, 0}, {6, 5, 0}, {6, 6, 0}}));
  EXPECT_TRUE(polyline.closed);
  EXPECT_EQ(shapes[1].light->radiance.channels[2], 1e36);

  const auto& circle = std::get<Circle>(shapes[2].kind);
  EXPECT_EQ(circle.center, (Coordinates{20, 0, 0}));
  EXPECT_EQ(circle.radius, 2);
  EXPECT_FALSE(circle.flip);
  EXPECT_EQ(std::pair(shapes[2].line, shapes[2].column), std::pair(19, 5));

  const auto& arc = std::get<Arc>(shapes[3].kind);
  EXPECT_EQ(arc.radius, 2.5);
  EXPECT_EQ(std::pair(arc.from_degrees, arc.to_degrees), std::pair(350.0, 10.5));
  EXPECT_TRUE(arc.flip);
  EXPECT_EQ(shapes[3].name, "bowl");
  EXPECT_FALSE(shapes[3].material.has_value());
  EXPECT_EQ(shapes[3].sensor->resolution, std::vector<int>{100});
}

Camera camera_of(const std::string& more) {
  return *parse(shapes_only("[" + a_light + R"(], "camera": { "type": "perspective",
    "position": [1, 2], "target": [3, 4.5], "fov_deg": 60, "resolution": 32)" +
                            more + "}"))
              .scene.camera;
}

TEST(SceneFile, KeepsTheCamera) {
  const Camera plain = camera_of("");
  EXPECT_EQ(plain.position, (Coordinates{1, 2, 0}));
  EXPECT_EQ(plain.target, (Coordinates{3, 4.5, 0}));
  EXPECT_EQ(plain.fov_degrees, 60);
  EXPECT_EQ(plain.resolution, std::vector<int>{32});
  EXPECT_EQ(plain.aperture_radius, 0);
  EXPECT_FALSE(plain.focus_distance.has_value());

  const Camera lens = camera_of(R"(, "aperture_radius": 0.1, "focus_distance": 7)");
  EXPECT_EQ(lens.aperture_radius, 0.1);
  EXPECT_EQ(lens.focus_distance, 7);
}

TEST(SceneFile, HasEightVerticesAtMostUnlessItSaysOtherwise) {
  EXPECT_EQ(parse(shapes_only("[" + a_light + "," + a_sensor + "]")).scene.max_vertices, 8);
}

TEST(SceneFile, ReadsNumbersToTheLastDigitInAnyLocale) {
  const std::string text = with_shape(
      R"({ "type": "segment", "from": [0.1, 5e-324], "to": [1.7976931348623157e50, 1E2] })");
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"C", "de_DE.UTF-8", "fr_FR.UTF-8"}) {
    std::setlocale(LC_ALL, locale);  // where it is installed
    const auto segment = std::get<Segment>(parse(text).scene.shapes[2].kind);
    EXPECT_EQ(segment.from, (Coordinates{0.1, 5e-324, 0}));
    EXPECT_EQ(segment.to, (Coordinates{1.7976931348623157e50, 100, 0}));
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(SceneFile, MayBeginWithAByteOrderMarkAndHaveWindowsLineEnds) {
  std::string text = "\xEF\xBB\xBF" + with_shape("17");
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 2)
    text.insert(i, 1, '\r');
  const std::vector<Fault> faults = faults_of(text);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(std::pair(faults[0].line, faults[0].column), std::pair(10, 5));
}

TEST(SceneFile, TellsItsFaultsOnOneLineEach) {
  try {
    parse_scene(with_root("\"nam\": 1,\n\"max_vertices\": 1"), "dir/s.json");
    FAIL();
  } catch (const SceneFileError& error) {
    EXPECT_EQ(error.file, "dir/s.json");
    EXPECT_STREQ(
        error.what(),
        "dir/s.json:2:52: /nam: unknown key \"nam\"; did you mean \"name\"? allowed are "
        "format, dimension, max_vertices, materials, shapes, camera, name, id, description\n"
        "dir/s.json:3:17: /max_vertices: 1 is not allowed; max_vertices is an integer from "
        "2 to 100000");
  }
}

TEST(SceneFile, TellsAHundredFaultsAndThatThereAreMore) {
  std::string numbers = "1";
  for (int i = 0; i < 100'000; ++i) numbers += ",1";
  const std::vector<Fault> faults = faults_of(with_shape(numbers));
  ASSERT_EQ(faults.size(), 101u);
  EXPECT_EQ(faults[99].pointer, "/shapes/101");
  EXPECT_NE(faults[100].what.find("more faults follow"), std::string::npos);
}

std::string message_for(const std::filesystem::path& path) {
  try {
    read_scene_file(path);
  } catch (const SceneFileError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneFile, ThatCannotBeReadIsAFaultOfTheFile) {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("wander-{}", getpid());
  std::filesystem::create_directory(folder);
  const std::string place = folder.string();
  EXPECT_EQ(message_for(folder / "none.json"),
            place + "/none.json:1:1: /: there is no such file; check the path");
  EXPECT_EQ(message_for(folder), place + ":1:1: /: this is a directory; name a scene file in it");
  EXPECT_NE(message_for("/dev/zero").find("/dev/zero:1:1: /: the file is too large"),
            std::string::npos);
  std::ofstream(folder / "secret.json") << everything;
  chmod((folder / "secret.json").c_str(), 0);
  const bool is_root = geteuid() == 0;  // who may read it all the same
  EXPECT_EQ(message_for(folder / "secret.json").find("cannot be read") == std::string::npos,
            is_root);
  std::filesystem::remove_all(folder);
}

TEST(SceneFile, IsReadAsItsTextIs) {
  const auto path =
      std::filesystem::temp_directory_path() / fmt::format("wander-{}.json", getpid());
  std::ofstream(path, std::ios::binary) << everything;
  EXPECT_EQ(read_scene_file(path).digest.text, sha256(everything));
  std::filesystem::remove(path);
}

TEST(Sha256, EqualsThePublishedDigest) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace wander::description::scene_file_test

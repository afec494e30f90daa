// What a valid scene file of three dimensions says arrives in the description.
#include <gtest/gtest.h>

#include "core/requirements.h"
#include "tests/scenes/format/space_texts.h"

namespace wander::description::scene_file_space_test {
namespace {

TEST(SpaceFile, KeepsEveryShape) {
  const Scene scene = parse(everything_in_space).scene;
  EXPECT_EQ(scene.dimension, 3);
  ASSERT_EQ(scene.shapes.size(), 3u);
  const auto& triangle = std::get<Triangle>(scene.shapes[0].kind);
  EXPECT_EQ(triangle.points[2], (Coordinates{7, 8, 10}));
  const auto& sheet = std::get<Parallelogram>(scene.shapes[1].kind);
  EXPECT_EQ(sheet.origin, (Coordinates{0, 1, 2}));
  EXPECT_EQ(sheet.edges[1], (Coordinates{0, 1, 0.5}));
  EXPECT_EQ(scene.shapes[1].sensor->resolution, (std::vector<int>{30, 20}));
  const auto& ball = std::get<Sphere>(scene.shapes[2].kind);
  EXPECT_EQ(ball.center, (Coordinates{9, 9, 9}));
  EXPECT_TRUE(ball.flip);
}

TEST(SpaceFile, KeepsColoursAndKnowsGreyFromThem) {
  const Scene scene = parse(everything_in_space).scene;
  const Quantity red = std::get<Diffuse>(scene.materials[0].kind).reflectance,
                 grey = std::get<Mirror>(scene.materials[1].kind).reflectance;
  EXPECT_EQ(red.channels, (std::array{0.9, 0.1, 0.2}));
  EXPECT_TRUE(red.coloured);
  EXPECT_EQ(grey.channels, (std::array{0.5, 0.5, 0.5}));
  EXPECT_FALSE(grey.coloured);
  EXPECT_EQ(scene.shapes[2].light->radiance.channels, (std::array{1.0, 0.0, 2.0}));
}

TEST(SpaceFile, KeepsConductors) {
  const Scene scene = parse(space_only("[" + a_lamp + "," + a_screen + "]", R"(, "materials": {
    "a": { "type": "conductor", "eta": [0.2, 0.9, 1.1], "k": 3.5 },
    "b": { "type": "rough_conductor", "roughness": 0.3, "eta": 0.5, "k": [3, 3, 3] },
    "c": { "type": "conductor", "eta": 0, "k": 1e6 } })"))
                          .scene;
  const auto& smooth = std::get<Conductor>(scene.materials[0].kind);
  EXPECT_EQ(smooth.eta.channels, (std::array{0.2, 0.9, 1.1}));
  EXPECT_TRUE(smooth.eta.coloured);
  EXPECT_EQ(smooth.k.channels[2], 3.5);
  EXPECT_FALSE(smooth.k.coloured);
  const auto& rough = std::get<RoughMetal>(scene.materials[1].kind);
  EXPECT_EQ(rough.roughness, 0.3);
  EXPECT_EQ(rough.eta.channels[0], 0.5);
  EXPECT_EQ(rough.k.channels[1], 3);
  EXPECT_FALSE(rough.k.coloured);
}

TEST(SpaceFile, RequiresThreeChannelsWhereSomethingIsColoured) {
  EXPECT_EQ(requires_of(parse(everything_in_space).scene).colour_channels, 3);
  const Requirements grey =
      requires_of(parse(space_only("[" + a_lamp + "," + a_screen + "]")).scene);
  EXPECT_EQ(grey.colour_channels, 1);
  EXPECT_EQ(grey.dimension, 3);
  EXPECT_EQ(grey.shapes, (std::vector<std::string>{"parallelogram", "sphere"}));
}

TEST(SpaceFile, KeepsTheCamera) {
  const std::string view = R"("position": [1, 2, 3], "target": [4, 5, 7], "fov_deg": 40,
    "resolution": [64, 48])";
  const Camera plain = *parse(with_view(view)).scene.camera;
  EXPECT_EQ(plain.target, (Coordinates{4, 5, 7}));
  EXPECT_EQ(plain.up, (Coordinates{0, 1, 0}));
  EXPECT_EQ(plain.resolution, (std::vector<int>{64, 48}));
  const Camera lens = *parse(with_view(view + R"(, "up": [0, 0.5, 1], "aperture_radius": 0.1,
    "focus_distance": 7)"))
                           .scene.camera;
  EXPECT_EQ(lens.up, (Coordinates{0, 0.5, 1}));
  EXPECT_EQ(lens.aperture_radius, 0.1);
  EXPECT_EQ(lens.focus_distance, 7);
}

}  // namespace
}  // namespace wander::description::scene_file_space_test

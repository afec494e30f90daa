// What a walk through a scene says of its glass, and of light that does not arrive.
#include "lab/probe.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scenes/format/scene_file.h"

namespace wander {
namespace {

// A room with a lamp above and a sensor below, and between them these shapes of glass.
Probe probe_of(const std::string& shapes) {
  return probe(parse_scene(fmt::format(R"({{
    "format": "wanderlight-scene/1", "dimension": 2,
    "materials": {{ "wall": {{ "type": "diffuse", "reflectance": 0.5 }},
                    "glass": {{ "type": "dielectric", "ior": 1.5 }},
                    "water": {{ "type": "dielectric", "ior": 1.33 }},
                    "bubble": {{ "type": "rough_dielectric", "roughness": 0.1, "ior": 1,
                                 "exterior_ior": 1.5 }} }},
    "shapes": [
      {{ "type": "polyline", "points": [[0,0],[4,0],[4,2],[0,2]], "closed": true, "material": "wall" }},
      {{ "type": "segment", "from": [2.2,1.9], "to": [1.8,1.9], "light": {{ "radiance": 10 }} }},
      {{ "type": "segment", "from": [1,0.1], "to": [3,0.1], "sensor": {{ "bins": 4 }} }}{}{} ] }})",
                                       shapes.empty() ? "" : ", ", shapes),
                           "probed.json")
                   .scene);
}

std::string places_of(const Probe& found) {
  std::string places;
  for (const Fault& fault : found.warnings) places += fault.pointer + " ";
  return places;
}

const std::string below = R"({ "type": "arc", "center": [2,0], "radius": 1, "from_deg": 60,
                              "to_deg": 120, "material": "glass" })";
const std::string above = R"({ "type": "arc", "center": [2,1.7320508075688772], "radius": 1,
                              "from_deg": 240, "to_deg": 300, "material": "glass" })";

std::string turned_over(std::string shape) {
  return shape.insert(shape.size() - 1, R"(, "flip": true)");
}
std::string disc(const std::string& members) { return R"({ "type": "circle", )" + members + " }"; }

TEST(Probe, SaysNothingOfGlassThatMakesSense) {
  EXPECT_EQ(places_of(probe_of("")), "");
  EXPECT_FALSE(probe_of("").index_at_sensor);
  const Probe lens = probe_of(below + "," + above);
  EXPECT_EQ(places_of(lens), "");
  EXPECT_DOUBLE_EQ(lens.index_at_sensor.value(), 1);
  EXPECT_EQ(lens.samples, 4096u);
  EXPECT_GT(lens.samples_with_light, 3000u);
}

TEST(Probe, KnowsGlassInGlassAndWaterBetweenWalls) {
  EXPECT_EQ(
      places_of(probe_of(disc(R"("center": [2,1], "radius": 0.5, "material": "glass")") + "," +
                         disc(R"("center": [2,1], "radius": 0.2, "material": "bubble")"))),
      "");
  const Probe pool =
      probe_of(R"({ "type": "segment", "from": [0,1], "to": [4,1], "material": "water" })");
  EXPECT_EQ(places_of(pool), "/shapes/3 ");  // the sensor is under water, which may be meant
  EXPECT_NE(pool.warnings[0].what.find("the sensor is inside this glass"), std::string::npos);
  EXPECT_DOUBLE_EQ(pool.index_at_sensor.value(), 1.33);
}

TEST(Probe, FindsAFaceThatIsTurnedOver) {
  EXPECT_NE(places_of(probe_of(below + "," + turned_over(above))).find("/shapes/"),
            std::string::npos);
  EXPECT_NE(places_of(probe_of(turned_over(below) + "," + above)).find("/shapes/"),
            std::string::npos);
}

TEST(Probe, FindsBodiesThatOverlap) {
  const Probe found =
      probe_of(disc(R"("center": [1.8,1], "radius": 0.3, "material": "glass")") + "," +
               disc(R"("center": [2.2,1], "radius": 0.3, "material": "glass")"));
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings[0].what.find(
                "light meets this glass from the outside in a medium of index 1.5"),
            std::string::npos)
      << found.warnings[0].what;
}

TEST(Probe, FindsGlassThatIsOpen) {
  const std::string short_of = R"({ "type": "arc", "center": [2,0], "radius": 1, "from_deg": 65,
                                    "to_deg": 115, "material": "glass" })";
  EXPECT_NE(places_of(probe_of(short_of + "," + above)), "");
}

TEST(Probe, CountsSamplesUntilOneFindsLight) {
  const Probe sealed =
      probe_of(R"({ "type": "segment", "from": [0,0.5], "to": [4,0.5], "material": "wall" })");
  EXPECT_EQ(sealed.samples_with_light, 0u);
  EXPECT_GT(sealed.samples, 100'000u);
  ASSERT_EQ(sealed.warnings.size(), 1u);
  EXPECT_EQ(sealed.warnings[0].pointer, "/");
  EXPECT_NE(sealed.warnings[0].what.find("it is rare, or there is none"), std::string::npos);
}

TEST(Probe, WalksThroughSpaceAsWell) {
  const auto of = [](const std::string& balls) {
    return probe(parse_scene(R"({
      "format": "wanderlight-scene/1", "dimension": 3,
      "materials": { "glass": { "type": "dielectric", "ior": 1.5 } },
      "shapes": [
        { "type": "sphere", "center": [0,0,0], "radius": 10, "flip": true, "light": { "radiance": 1 } })" +
                                 balls + R"( ],
      "camera": { "type": "perspective", "position": [0,0,5], "target": [0,0,0], "fov_deg": 40,
                  "resolution": [4, 4] } })",
                             "space.json")
                     .scene);
  };
  const std::string one =
      R"(, { "type": "sphere", "center": [0,0,0], "radius": 1, "material": "glass" })";
  const std::string other =
      R"(, { "type": "sphere", "center": [1.5,0,0], "radius": 1, "material": "glass" })";
  EXPECT_EQ(places_of(of(one)), "");
  EXPECT_DOUBLE_EQ(of(one).index_at_sensor.value(), 1);
  EXPECT_NE(places_of(of(one + other)), "");
}

// Each has a luminance; of yellow paint under a blue lamp nothing is seen.
TEST(Probe, FindsNoLightOfColoursThatHaveNoChannelInCommon) {
  const auto of = [](const char* paint) {
    return probe(parse_scene(fmt::format(R"({{
      "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 3,
      "materials": {{ "paint": {{ "type": "diffuse", "reflectance": {} }} }},
      "shapes": [
        {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[0,0,1],[1,0,0]], "material": "paint" }},
        {{ "type": "sphere", "center": [0.5,1,0.5], "radius": 0.2, "light": {{ "radiance": [0,0,3] }} }} ],
      "camera": {{ "type": "perspective", "position": [0.5,0.4,3], "target": [0.5,0.3,0],
                   "fov_deg": 30, "resolution": [3, 2] }} }})",
                                         paint),
                             "blue.json")
                     .scene);
  };
  EXPECT_EQ(of("[1, 1, 0]").samples_with_light, 0u);
  EXPECT_GT(of("[0, 0, 0.01]").samples_with_light, 0u);
}

}  // namespace
}  // namespace wander

// Drawings of scenes: what they say is in the right place, whatever they are given.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "draw/figure/region.h"
#include "draw/figure/scene_drawing.h"
#include "draw/figure/scene_figure.h"
#include "draw/figure/scene_inset.h"
#include "tests/draw/figure/figure_checks.h"

namespace wander::figure {
namespace {

TEST(SceneFigure, IsWellFormedAndTheSameEveryTime) {
  d::Scene scene = room();
  scene.name = "a <b> & \"c\" \x01 <script>alert(1)</script>";
  const std::string svg = scene_figure(scene);
  EXPECT_TRUE(is_well_formed(svg));
  EXPECT_EQ(svg, scene_figure(scene));
  EXPECT_NE(svg.find("a &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
}

TEST(SceneFigure, NamesInItsLegendWhatOccursAndNothingElse) {
  const std::string all = scene_figure(room());
  for (const char* entry :
       {">light, 5 W/(m·rad)<", ">sensor, 20 bins from the dot<", ">diffuse, ρ 0.5<",
        ">mirror, ρ 0.9<", ">dielectric, n 1.5<", ">rough conductor, α 0.2, ρ 0.9<",
        ">rough dielectric, α 0.3, n 1.4<", ">black<"})
    EXPECT_EQ(count(all, entry), 1u) << entry;
  d::Scene bare = room();
  bare.shapes.erase(bare.shapes.begin() + 1, bare.shapes.begin() + 6);
  const std::string some = scene_figure(bare);
  for (const char* entry : {">mirror", ">dielectric", ">rough", ">black", ">camera"})
    EXPECT_EQ(count(some, entry), 0u) << entry;
}

// The marks of a light or sensor are lines "Mx yLx y" from the curve outwards.
std::vector<std::array<double, 4>> marks(const std::string& text) {
  const std::regex line(R"(stroke-width="0.7" d="M([-0-9.]+) ([-0-9.]+)L([-0-9.]+) ([-0-9.]+)\")");
  std::vector<std::array<double, 4>> result;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    result.push_back(
        {std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4])});
  return result;
}

TEST(SceneFigure, LightsAndSensorsHaveTheirMarksOnTheSideOfTheNormal) {
  const std::string svg = scene_figure(room());
  const auto rays = marks(group(svg, "light")), pins = marks(group(svg, "sensor"));
  ASSERT_FALSE(rays.empty());
  ASSERT_FALSE(pins.empty());
  for (const auto& ray : rays) EXPECT_GT(ray[3], ray[1] + 3) << "the light shines down";
  for (const auto& pin : pins) EXPECT_LT(pin[3], pin[1] - 3) << "the sensor listens up";
}

TEST(SceneFigure, CurvedLightsShineAwayFromTheirCentreUnlessFlipped) {
  for (const bool flip : {false, true}) {
    const std::vector<Curve> parts = curves(d::Arc{{1, 2}, 0.5, 300, 390, flip});
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_NEAR(length(parts[0]), 0.5 * std::numbers::pi / 2, 1e-12);
    for (const double u : {0., 0.3, 1.}) {
      const Spot s = spot(parts[0], u);
      EXPECT_NEAR(glm::distance(s.position, Vector(1, 2)), 0.5, 1e-12);
      EXPECT_NEAR(glm::dot(s.normal, s.position - Vector(1, 2)), flip ? -0.5 : 0.5, 1e-12);
    }
    EXPECT_NEAR(spot(parts[0], 0).position.y, 2 - 0.5 * std::sin(std::numbers::pi / 3), 1e-12);
  }
}

TEST(SceneFigure, CirclesStayExactCurves) {
  EXPECT_NE(group(scene_figure(room()), "scene").find('A'), std::string::npos);
  Extent extent;
  extent.include(curves(d::Arc{{0, 0}, 1, 45, 135})[0]);
  EXPECT_NEAR(extent.high.y, 1, 1e-12);
  EXPECT_NEAR(extent.low.y, std::sqrt(0.5), 1e-12);
}

TEST(SceneFigure, TwoArcsThatMeetAreARegionWhenTheirBacksAreWithin) {
  const d::Arc upper{{0, -std::sqrt(0.5)}, 1, 45, 135}, lower{{0, std::sqrt(0.5)}, 1, 225, 315};
  const PageMap map{{0, 0}, {0, 0}, 100};
  const Insides lens = find_insides({upper, lower}, map, 1);
  EXPECT_EQ(lens.regions.size(), 1u);
  EXPECT_TRUE(lens.open.empty());

  d::Arc flipped = upper;
  flipped.flip = true;
  EXPECT_EQ(find_insides({flipped, lower}, map, 1).open.size(), 2u);
  EXPECT_EQ(find_insides({upper}, map, 1).open.size(), 1u);

  // The left of a counter-clockwise polygon is its inside, so its back is the world around it.
  const d::Polyline outwards{{{0, 0}, {0, 1}, {1, 0}}, true},
      inwards{{{0, 0}, {1, 0}, {0, 1}}, true};
  EXPECT_EQ(find_insides({outwards}, map, 1).regions.size(), 1u);
  EXPECT_EQ(find_insides({inwards}, map, 1).regions.size(), 0u);
}

TEST(SceneFigure, SurvivesScenesOfAnySizeAndPlace) {
  for (const double scale : {1e-9, 1., 1e9, 1e60}) {
    for (const double offset : {0., 1e6}) {
      d::Scene scene;
      d::Shape light = segment({offset * scale, 0}, {(offset + 1) * scale, 0});
      light.light = d::Light{grey(1)};
      scene.shapes = {light};
      scene.camera = d::Camera{{offset * scale, scale}, {offset * scale, 0}, {}, 179, {10}, 0, {}};
      EXPECT_TRUE(is_well_formed(scene_figure(scene))) << scale << " " << offset;
    }
  }
}

TEST(SceneFigure, NamesTheFirstBinOfACameraAtItsLeft) {
  const d::Camera camera{{0, 0}, {1, 0}, {}, 90, {10}, 0, {}};
  const Wedge wedge = camera_wedge(camera, 1);
  EXPECT_GT(wedge.first.y, 0);
  EXPECT_LT(wedge.last.y, 0);
}

TEST(Inset, NamesLengthsWithPrefixes) {
  EXPECT_EQ(length_in_words(0.5), "0.5 m");
  EXPECT_EQ(length_in_words(2e-9), "2 nm");
  EXPECT_EQ(length_in_words(5e8), "500 Mm");
  EXPECT_EQ(length_in_words(1000), "1 km");
}

}  // namespace
}  // namespace wander::figure

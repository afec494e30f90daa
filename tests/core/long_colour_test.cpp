// The colour of long paths: their light neither overflows nor is lost, and Russian roulette makes no channel of it
// rare.  A sphere that emits 1 and reflects ρ has, of paths with k bounces, the light ρ^k in each channel.
#include <gtest/gtest.h>

#include <cmath>

#include "core/path_sampler.h"
#include "scenes/format/build_scene.h"
#include "scenes/format/scene_file.h"

namespace wander::test {
namespace long_colours {

using W = SpacelandColour;
using Colour = std::array<double, 3>;

Vertex<W> reflecting(const Colour& reflectance) {
  Vertex<W> v;
  v.value = luminance(reflectance);
  v.tint = W::Tint::of(reflectance);
  v.from_light = v.from_sensor = 1;
  v.geometry = 1;
  return v;
}

// A white light, `bounces` at surfaces and a sensor, all factors and densities but these 1.
Path<W> bounced(const Colour& reflectance, int bounces) {
  Path<W> x(bounces + 2);
  x.resize(bounces + 2);
  for (int i = 0; i < x.size(); ++i)
    x[i] = reflecting(i == 0 || i > bounces ? Colour{1, 1, 1} : reflectance);
  return x;
}

// Exact, to the rounding of 3000 products.  Of blue paint the tint has a channel of 1 / 0.0722, and 271 of them no
// number; of what is all but black a double has no number either, and `Scaled` has.
TEST(LongColours, AreNeitherLostNorWithoutANumber) {
  for (const Colour& reflectance :
       {Colour{0, 0, 0.999}, Colour{0.999, 0, 0}, Colour{0.9, 0.1, 0.1}, Colour{1, 1, 1}})
    for (const int bounces : {1, 100, 269, 600, 3000}) {
      const Path<W> x = bounced(reflectance, bounces);
      const Scaled f = contribution(x);
      ASSERT_TRUE(f.is_positive()) << bounces;
      const auto shown = colour(x);
      EXPECT_NEAR(luminance(shown), 1, 1e-14);
      for (int k = 0; k < 3; ++k) {
        const double each = reflectance[static_cast<std::size_t>(k)];
        const Scaled light = f * Scaled(shown[k]);
        if (each == 0) {
          EXPECT_TRUE(light.is_zero());
        } else if (each > 0.5) {
          EXPECT_NEAR(light.log(), bounces * std::log(each), 1e-11) << bounces;
        }
      }
    }
}

// The same of a sampler's product, in which densities by the largest channel cancel what is lost.
TEST(LongColours, AreTheSameFromBothSides) {
  for (const Colour& reflectance : {Colour{0, 0, 0.999}, Colour{0.9, 0.1, 0.1}}) {
    const double largest = std::max(reflectance[0], reflectance[2]);
    for (const int at : {0, 1, 300, 600}) {
      PathSides<W> sides;
      const auto add = [&](PathSide<W>& side) {
        side.add(reflecting(reflectance), 1, largest, largest, 1, Heuristic::balance);
      };
      for (int i = 0; i < at; ++i) add(sides.light);
      for (int i = at; i < 600; ++i) add(sides.sensor);
      const double light = sides.light.product * sides.sensor.product;
      EXPECT_NEAR(light * std::max(sides.tint()[0], sides.tint()[2]), 1, 1e-10) << at;
      EXPECT_TRUE(std::isfinite(sides.tint()[0]) && std::isfinite(sides.tint()[2]));
    }
  }
}

std::unique_ptr<const Scene<W>> closed_sphere(const std::string& material) {
  const std::string text = R"({
    "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 40,
    "materials": { "paint": )" +
                           material + R"( },
    "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1, "flip": true, "material": "paint",
                 "light": { "radiance": 1 } }],
    "camera": { "type": "perspective", "position": [0, 0, 0], "target": [1, 0, 0], "up": [0, 0, 1],
                "fov_deg": 60, "resolution": [1, 1] }
  })";
  return build_scene<W>(parse_scene(text, "sphere.json").scene);
}

// Walks from the sensor that meet light by chance: what survives weighs in no channel more than the light that it
// meets, and in the channel that is reflected most exactly as much, however often it bounced, but for what facets
// mask.  By luminance red would weigh 3.3 times as much after each bounce.
TEST(LongColours, SurviveByTheChannelThatIsReflectedMost) {
  const std::string diffuse = R"({"type": "diffuse", )", mirror = R"({"type": "mirror", )",
                    rough = R"({"type": "rough_conductor", "roughness": 0.3, )";
  for (const std::string& type : {diffuse, mirror, rough}) {
    const auto scene = closed_sphere(type + R"("reflectance": [0.9, 0.1, 0.1]})");
    PathSampler<Transport<W>> sampler(Transport<W>(*scene, Roulette::by_albedo), {.most_light = 0},
                                      Heuristic::balance);
    Rng rng(1, Purpose::test, 0);
    double first = 0;  // of what is seen directly
    int longest = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      rng.start(i);
      sampler.sample(rng, [&](const auto& x, int, double value) {
        const double red = value * x.colour()[0];
        if (x.size() == 2) first = red;
        EXPECT_LE(red, first * (1 + 1e-9)) << type << x.size();
        if (type != rough) {
          EXPECT_GE(red, first * (1 - 1e-9)) << type << x.size();
        }
        EXPECT_LE(value * x.colour()[2], first * (1 + 1e-9));
        longest = std::max(longest, x.size());
      });
    }
    EXPECT_GT(longest, 20) << type;
  }
}

}  // namespace long_colours
}  // namespace wander::test

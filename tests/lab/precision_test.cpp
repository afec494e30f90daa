// The same paths measured in float, in double and in extended precision, room by room
// (path_precision.h says what is compared; tests/precision sweeps what docs/precision.md shows).
// A float has 6e-8 of relative error in every factor of its own, whatever the angle: what angles
// are made of is double.  A double loses where facets are sharp, for the slope of a half vector is
// rounded to 1e-16.  Bounds are some four times what was found.
#include <gtest/gtest.h>

#include "lab/precision.h"
#include "tests/support/core_scenes.h"
#include "tests/support/extended_world.h"
#include "tests/support/path_precision.h"
#include "tests/support/space_maker.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

// Light and sensor face each other at a millionth of their length: cosines are as small.
description::Scene grazing() {
  SceneMaker maker(4);
  const std::size_t wall = maker.diffuse(0.7);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4}).segment({1, 1.1e-6}, {0, 1e-6}, {wall, 1});
  return maker.description();
}
// Roughness 1e-4, of metal and of glass.
description::Scene sharp() {
  SceneMaker maker(5);
  const std::size_t wall = maker.diffuse(0.6);
  maker.segment({0, 0}, {1, 0}, {wall, 0, 4}).segment({1, 0}, {1.1, 0.9}, {wall, 1});
  maker.segment({1.1, 0.9}, {0, 1}, {maker.rough_metal(1e-4, 0.9)});
  maker.segment({0, 1}, {0, 0}, {wall});
  maker.circle({0.5, 0.4}, 0.15, {maker.rough_glass(1e-4, 1.5)});
  return maker.description();
}
description::Scene long_paths() {
  description::Scene scene = diffuse_room();
  scene.max_vertices = 60;
  return scene;
}

// In space: a box with a wall of rough metal and a ball of rough glass, seen by its floor or through
// a thin lens.
SpaceMaker box_of_roughness(double roughness) {
  SpaceMaker maker(5);
  const std::size_t wall = maker.diffuse(SpaceMaker::grey(0.6));
  const std::size_t metal =
      maker.material(description::RoughConductor{roughness, SpaceMaker::grey(0.9)});
  const std::size_t glass = maker.material(description::RoughDielectric{roughness, 1.5, 1});
  maker.parallelogram({0, 0, 1}, {0, 1, 0.03}, {1, 0.04, 0}, {wall, SpaceMaker::grey(1)});
  maker.parallelogram({0, 0, 0}, {0, 1, 0.02}, {0.02, 0, 0.95}, {wall});
  maker.parallelogram({0, 1, 0.02}, {1, 0.05, 0}, {0.02, 0, 0.95}, {metal});
  maker.sphere({0.5, 0.5, 0.4}, 0.2, {glass});
  return maker;
}
description::Scene rough_box(double roughness) {
  SpaceMaker maker = box_of_roughness(roughness);
  const std::size_t wall = maker.diffuse(SpaceMaker::grey(0.6));
  maker.parallelogram({0, 0, 0}, {1, 0.05, 0}, {0, 1, 0.02}, {wall, {}, {2, 2}});
  return maker.description();
}
description::Scene blurred_box() { return rough_box(0.3); }
description::Scene sharp_box() { return rough_box(1e-4); }
description::Scene box_through_a_lens() {
  SpaceMaker maker = box_of_roughness(0.3);
  description::Camera camera{{0.8, 0.05, 0.5}, {0.3, 1, 0.4}, {0, 0, 1}, 60, {2, 2}, 0.02, 0.7};
  return maker.camera(camera).description();
}

struct Room {
  const char* name;
  description::Scene (*make)();
  double of_float, of_double;  // bounds of the differences from extended precision
  int samples = 400, fewest_vertices = 2;
};
const Room rooms_of_the_plane[] = {{"Diffuse", diffuse_room, 1e-6, 2e-14},
                                   {"Gap", room_with_gap, 1e-6, 1e-14},
                                   {"MirrorAndGlass", mirror_and_glass, 2e-6, 2e-14},
                                   {"Rough", rough_room, 3e-6, 5e-12},
                                   {"Pinhole", pinhole_room, 1e-6, 1e-14},
                                   {"ThinLens", thin_lens_room, 1e-6, 2e-14},
                                   {"Grazing", grazing, 1e-6, 1e-14},
                                   {"Sharp", sharp, 3e-6, 5e-11},
                                   {"SixtyVertices", long_paths, 5e-6, 3e-14, 2, 55}};
const Room rooms_of_space[] = {{"Rough", blurred_box, 3e-6, 5e-12},
                               {"Sharp", sharp_box, 3e-6, 5e-11},
                               {"ThinLens", box_through_a_lens, 3e-6, 5e-12}};

template <World Single, World Double, World Extended>
void expect_as_exact_as_numbers_allow(const Room& room) {
  PathComparison<Single, Extended> single(room.make());
  PathComparison<Double, Extended> twice(room.make());
  for_paths<Double>(room.make(), room.samples, room.fewest_vertices, [&](const Path<Double>& x) {
    single.add(x);
    twice.add(x);
  });
  const auto show = [](const PathDifferences& d) {
    return ::testing::Message() << "f " << largest(d.contribution) << ", density "
                                << largest(d.intensity) << ", weights " << largest(d.weights)
                                << ", ratio " << largest(d.ratio) << " of " << d.paths()
                                << " paths up to " << d.longest << " vertices";
  };
  const PathDifferences f = single.differences(), d = twice.differences();
  EXPECT_GE(d.paths(), 100U);
  EXPECT_GE(d.longest, room.fewest_vertices);
  EXPECT_LE(f.largest_of_all(), room.of_float) << show(f);
  EXPECT_LE(d.largest_of_all(), room.of_double) << show(d);
  EXPECT_GE(largest(f.contribution), 1e-8) << "that was no float: " << show(f);  // control
}

std::string room_name(const ::testing::TestParamInfo<Room>& test) { return test.param.name; }

class PathsOfARoom : public ::testing::TestWithParam<Room> {};
INSTANTIATE_TEST_SUITE_P(Rooms, PathsOfARoom, ::testing::ValuesIn(rooms_of_the_plane), room_name);
TEST_P(PathsOfARoom, AreMeasuredAsExactlyAsTheirNumbersAllow) {
  expect_as_exact_as_numbers_allow<FlatlandSingle, Flatland, FlatlandExtended>(GetParam());
}

class PathsInSpace : public ::testing::TestWithParam<Room> {};
INSTANTIATE_TEST_SUITE_P(Rooms, PathsInSpace, ::testing::ValuesIn(rooms_of_space), room_name);
TEST_P(PathsInSpace, AreMeasuredAsExactlyAsTheirNumbersAllow) {
  expect_as_exact_as_numbers_allow<SpacelandSingle, Spaceland, SpacelandExtended>(GetParam());
}

// A scene multiplied by a power of two: float has no other mantissas, either.
TEST(PathsInFloat, AreTheSameToTheLastBitInASceneMultipliedByAPowerOfTwo) {
  for (const auto make : {diffuse_room, rough_room, thin_lens_room}) {
    const description::Scene scene = make();
    for (const int n : {-40, 40}) {
      const double factor = std::ldexp(1.0, n);
      const auto small = build_flatland<FlatlandSingle>(scene),
                 large = build_flatland<FlatlandSingle>(scaled(scene, factor));
      Path<FlatlandSingle> a(scene.max_vertices), b(scene.max_vertices);
      Path<Flatland> y(scene.max_vertices);
      for_paths<Flatland>(scene, 50, 2, [&](const Path<Flatland>& x) {
        y = x;
        for (int i = 0; i < y.size(); ++i) y[i].place.position *= factor;
        transfer(Transport<FlatlandSingle>(*small, Roulette::off), x, a);
        transfer(Transport<FlatlandSingle>(*large, Roulette::off), y, b);
        ASSERT_EQ(a.contribution.mantissa(), b.contribution.mantissa());
        ASSERT_EQ(a.intensity.mantissa(), b.intensity.mantissa());
        ASSERT_EQ(a.weights(), b.weights());
      });
    }
  }
}

// ---- numbers of the unit interval

TEST(UnitNumbers, AreNeverOne) {
  const double last = std::nextafter(1.0, 0.0);
  EXPECT_EQ(static_cast<float>(last), 1);  // what would happen otherwise
  EXPECT_EQ(unit_number<float>(last), 1 - 0x1p-24f);
  EXPECT_EQ(unit_number<float>(1 - 0x1p-24), 1 - 0x1p-24f);
  EXPECT_EQ(unit_number<float>(0.5), 0.5f);
  EXPECT_EQ(unit_number<float>(1e-30), 1e-30f);
  EXPECT_EQ(unit_number<double>(last), last);
}

// ---- what fits into a float

TEST(FloatRange, IsToldOfScenesThatLeaveIt) {
  const auto why = [](const SceneMaker& maker) {
    EXPECT_EQ(why_beyond(Precision::of_double, maker.description()), "");
    return why_beyond(Precision::of_float, maker.description());
  };
  const auto room = [](double size, double radiance, double reflectance) {
    SceneMaker maker(3);
    maker.segment({0, 0}, {size, 0}, {maker.diffuse(reflectance), 0, 2});
    return maker.segment({size, size}, {0, size}, {.radiance = radiance});
  };
  EXPECT_EQ(why(room(1, 1, 0.5)), "");
  EXPECT_EQ(why(room(0x1p40, 1e30, 0.5)), "");
  EXPECT_EQ(why(room(0x1p-40, 1e-30, 0)), "");
  EXPECT_EQ(why(room(1e16, 1, 0.5)), "/shapes/0: length 1e+16: allowed is 1e-15 to 1e+15");
  EXPECT_EQ(why(room(1e-16, 1, 0.5)), "/shapes/0: length 1e-16: allowed is 1e-15 to 1e+15");
  EXPECT_EQ(why(room(1, 1, 1e-40)), "material 0: reflectance 1e-40: allowed is 1e-30 to 1");
}

}  // namespace
}  // namespace wander::test

// The same paths measured in float, in double and in extended precision: how far contributions,
// densities, weights and ratios of acceptance are apart, room by room.
//
//   f, Σ_s p_s, f/Σ p (y) : f/Σ p (x)   relative differences
//   w_s                                 absolute differences
// A float has 6e-8 of relative error in every factor of its own, whatever the angle: what angles
// are made of is double.  A double loses where facets are sharp, for the slope of a half vector is
// rounded to 1e-16.  Bounds are some four times what was found.
#include <gtest/gtest.h>

#include "core/path_sampler.h"
#include "lab/precision.h"
#include "tests/support/core_scenes.h"
#include "tests/support/extended_world.h"
#include "tests/support/test_scenes.h"

namespace wander::test {
namespace {

// A path of double precision at the same points in another world.
template <World W>
void transfer(const Transport<W>& space, const Path<Flatland>& x, Path<W>& y) {
  y.resize(x.size());
  for (int i = 0; i < x.size(); ++i) {
    y[i].place.position = typename W::Point(x[i].place.position);
    y[i].place.normal = typename W::Direction(x[i].place.normal);
    y[i].place.shape = x[i].place.shape;
    y[i].event = x[i].event;
  }
  for (int i = 0; i + 1 < x.size(); ++i) space.connect(y, i);
  for (int i = 0; i < x.size(); ++i) space.evaluate(y, i);
  weigh(space, y);
}

double relative_difference(Scaled a, Scaled b) { return std::abs((a / b).value() - 1); }

struct Differences {
  double contribution = 0, intensity = 0, weights = 0, ratio = 0;
  int paths = 0, longest = 0;

  double largest() const { return std::max({contribution, intensity, weights, ratio}); }
};

// Keeps the paths of a room in two worlds, and how far they are apart.
template <World A, World B>
class Comparison {
 public:
  explicit Comparison(const description::Scene& scene)
      : a_(build_flatland<A>(scene)),
        b_(build_flatland<B>(scene)),
        in_a_(scene.max_vertices),
        in_b_(scene.max_vertices) {}

  void add(const Path<Flatland>& x) {
    transfer(Transport<A>(*a_, Roulette::off), x, in_a_);
    transfer(Transport<B>(*b_, Roulette::off), x, in_b_);
    const auto raise = [](double& most, double found) {
      if (!(found <= most)) most = found;  // what is not a number stays
    };
    raise(d_.contribution, relative_difference(in_a_.contribution, in_b_.contribution));
    raise(d_.intensity, relative_difference(in_a_.intensity, in_b_.intensity));
    for (std::size_t s = 0; s < in_a_.weights().size(); ++s)
      raise(d_.weights, std::abs(in_a_.weights()[s] - in_b_.weights()[s]));
    const Scaled ratio_a = in_a_.contribution / in_a_.intensity;
    const Scaled ratio_b = in_b_.contribution / in_b_.intensity;
    if (d_.paths > 0) raise(d_.ratio, relative_difference(ratio_a / last_a_, ratio_b / last_b_));
    last_a_ = ratio_a;
    last_b_ = ratio_b;
    ++d_.paths;
    d_.longest = std::max(d_.longest, x.size());
  }
  const Differences& differences() const { return d_; }

 private:
  std::unique_ptr<const Scene<A>> a_;
  std::unique_ptr<const Scene<B>> b_;
  Path<A> in_a_;
  Path<B> in_b_;
  Scaled last_a_, last_b_;
  Differences d_;
};

// Calls f with the paths of bidirectional samples, of so many vertices or more.
template <class F>
void for_paths(const description::Scene& scene, int samples, int fewest_vertices, F&& f) {
  const FlatScene built = build(scene);
  PathSampler<Transport<Flatland>> sampler(Transport<Flatland>(*built, Roulette::off),
                                           all_techniques, Heuristic::balance);
  Rng random(1, Purpose::test, 70);
  for (int i = 0; i < samples; ++i) {
    random.start(static_cast<std::uint64_t>(i));
    sampler.sample(random, [&](const Path<Flatland>& x, int, double) {
      if (x.size() >= fewest_vertices) f(x);
    });
  }
}

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

struct Room {
  const char* name;
  description::Scene (*make)();
  double of_float, of_double;  // bounds of the differences from extended precision
  int samples = 400, fewest_vertices = 2;
};
const Room rooms[] = {{"Diffuse", diffuse_room, 1e-6, 2e-14},
                      {"Gap", room_with_gap, 1e-6, 1e-14},
                      {"MirrorAndGlass", mirror_and_glass, 2e-6, 2e-14},
                      {"Rough", rough_room, 3e-6, 5e-12},
                      {"Pinhole", pinhole_room, 1e-6, 1e-14},
                      {"ThinLens", thin_lens_room, 1e-6, 2e-14},
                      {"Grazing", grazing, 1e-6, 1e-14},
                      {"Sharp", sharp, 3e-6, 5e-11},
                      {"SixtyVertices", long_paths, 5e-6, 3e-14, 2, 55}};

class PathsOfARoom : public ::testing::TestWithParam<Room> {};
INSTANTIATE_TEST_SUITE_P(Rooms, PathsOfARoom, ::testing::ValuesIn(rooms),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(PathsOfARoom, AreMeasuredAsExactlyAsTheirNumbersAllow) {
  const Room& room = GetParam();
  Comparison<FlatlandSingle, FlatlandExtended> single(room.make());
  Comparison<Flatland, FlatlandExtended> twice(room.make());
  for_paths(room.make(), room.samples, room.fewest_vertices, [&](const Path<Flatland>& x) {
    single.add(x);
    twice.add(x);
  });
  const auto show = [](const Differences& d) {
    return ::testing::Message() << "f " << d.contribution << ", density " << d.intensity
                                << ", weights " << d.weights << ", ratio " << d.ratio << " of "
                                << d.paths << " paths up to " << d.longest << " vertices";
  };
  const Differences f = single.differences(), d = twice.differences();
  EXPECT_GE(d.paths, 100);
  EXPECT_GE(d.longest, room.fewest_vertices);
  EXPECT_LE(f.largest(), room.of_float) << show(f);
  EXPECT_LE(d.largest(), room.of_double) << show(d);
  EXPECT_GE(f.contribution, 1e-8) << "that was no float: " << show(f);  // control
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
      for_paths(scene, 50, 2, [&](const Path<Flatland>& x) {
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

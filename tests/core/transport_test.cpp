// The vocabulary of paths: first vertices, extension, connection, and the numbers that would have
// made a given vertex.
#include "core/transport.h"

#include <gtest/gtest.h>

#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/generator.h"

namespace wander::test {
namespace {

using Space = Transport<Flatland>;
using FlatPath = Path<Flatland>;
using Place2 = Place<Flatland>;

// ---- first vertices

TEST(FirstVertices, AreOnLightsInProportionToTheirPower) {
  SceneMaker maker(2);
  maker.segment({0, 0}, {1, 0}, {.bins = 1}).segment({1, 1}, {0, 1}, {.radiance = 2});  // power 2
  maker.segment({1, 2}, {0.5, 2}, {.radiance = 1});                                     // 0.5
  maker.circle({5, 5}, 0.5, {.radiance = 3});                                           // 3 π
  const auto scene = maker.build();
  const Space space(*scene, Roulette::off);
  FlatPath x(2);
  x.resize(2);
  Rng rng(1, Purpose::test, 0);
  std::vector<double> counts(3), expected;
  constexpr int draws = 100'000;
  for (int i = 0; i < draws; ++i) {
    space.begin_light(x, 0, rng);
    ++counts[static_cast<std::size_t>(x[0].place.shape) - 1];
  }
  const double total = 2.5 + 3 * std::numbers::pi;
  for (const double power : {2.0, 0.5, 3 * std::numbers::pi})
    expected.push_back(draws * power / total);
  EXPECT_TRUE(passes(chi_square_test(counts, expected, usual_false_alarm)));
  for (int k = 1; k <= 3; ++k)
    EXPECT_NEAR(scene->surface(k).light_density, scene->surface(k).radiance / total, 1e-15);
}

TEST(FirstVertices, ExistForTheEndsOfTheUnitInterval) {
  const auto scene = full_room(4).build();
  const Space space(*scene, Roulette::off);
  FlatPath x(4);
  x.resize(4);
  const double last = std::nextafter(1.0, 0.0);
  for (const double a : {0.0, last})
    for (const double b : {0.0, last}) {
      space.begin_light(x, 0, PointNumbers<Flatland>{a, {b}});
      EXPECT_TRUE(space.is_light(x[0]));
      space.begin_sensor(x, 3, PointNumbers<Flatland>{a, {b}});
      EXPECT_TRUE(space.is_sensor(x[3]));
      EXPECT_LT(scene->bin({b}), scene->bins());
    }
}

// Ten times a tenth is less than one in floating point: rounding must not lead past the last light.
TEST(FirstVertices, AreOnALightHoweverProbabilitiesAreRounded) {
  for (int lights = 2; lights < 40; ++lights) {
    SceneMaker maker(2);
    maker.segment({0, 0}, {1, 0}, {.bins = 1});
    for (int k = 0; k < lights; ++k) {
      const double y = 1 + 0.1 * k;
      maker.segment({1, y}, {0, y}, {.radiance = 1});
    }
    const auto scene = maker.build();
    FlatPath x(2);
    x.resize(2);
    Space(*scene, Roulette::off)
        .begin_light(x, 0, PointNumbers<Flatland>{std::nextafter(1.0, 0.0), {0.5}});
    EXPECT_TRUE(x[0].place.shape >= 1 && x[0].place.shape <= lights) << lights << " lights";
  }
}

// ---- connection

// Two points with normals, on no shape's inside.
FlatPath pair(const Place2& a, const Place2& b) {
  FlatPath x(2);
  x.resize(2);
  x[0].place = a;
  x[1].place = b;
  return x;
}

class Connections : public ::testing::Test {
 protected:
  void SetUp() override {
    SceneMaker maker(2);
    maker.segment({0, 0}, {4, 0}, {.bins = 1}).segment({4, 2}, {0, 2}, {.radiance = 1});
    maker.segment({1.5, 1}, {2, 1});
    scene_ = maker.build();
  }
  Connection connect(Place2 a, Place2 b) {
    x_ = pair(a, b);
    return Space(*scene_, Roulette::off).connect(x_, 0);
  }
  static Place2 below(double x) { return {{x, 0}, {0, 1}, {}, 0}; }
  static Place2 above(double x) { return {{x, 2}, {0, -1}, {}, 1}; }

  std::unique_ptr<const Scene<Flatland>> scene_;
  FlatPath x_{2};
};

TEST_F(Connections, HaveTheGeometryOfTheirEdge) {
  EXPECT_EQ(connect(above(0.5), below(1)), Connection::open);
  const double r = std::hypot(0.5, 2);
  EXPECT_NEAR(x_[0].geometry, (2 / r) * (2 / r) / r, 1e-15);
  EXPECT_NEAR(glm::length(x_[0].place.to_sensor - Flatland::Point(0.5, -2) / r), 0, 1e-15);
}

TEST_F(Connections, AreBlockedByWhatIsBetween) {
  EXPECT_EQ(connect(above(1.5), below(2)), Connection::occluded);
  EXPECT_EQ(connect(above(3), below(3)), Connection::open);
}

TEST_F(Connections, NeedTwoPointsThatFaceEachOther) {
  EXPECT_EQ(connect(below(1), below(2)), Connection::facing_away);  // along the wall
  EXPECT_EQ(connect(below(1), below(1)), Connection::facing_away);  // one and the same point
  const Place2 corner{{0, 0}, glm::normalize(Flatland::Point(1, 1)), {}, 2};
  EXPECT_EQ(connect(below(0), corner), Connection::facing_away);  // the same, on another shape
}

// The ends of a connection lie within rounding of their surfaces, on either side.
TEST_F(Connections, AreNotBlockedByTheSurfacesThatTheyEndOn) {
  SceneMaker maker(2);
  maker.segment({0, 0.1}, {4, 0.3}, {.bins = 1}).segment({3.7, 2.1}, {0, 1.7}, {.radiance = 1});
  maker.circle({7, 1.1}, 0.3, {});
  scene_ = maker.build();
  Rng random(1, Purpose::test, 1);
  const auto point_on = [&](ShapeId id) {
    const double u = random.uniform();
    const auto p = visit_shape([u](const auto& s) { return s.sample({u}); }, scene_->shape(id));
    return Place2{p.position, p.normal, {}, id};
  };
  for (int i = 0; i < 10'000; ++i) {
    const Place2 a = point_on(0), b = point_on(1), c = point_on(2);
    ASSERT_EQ(connect(a, b), Connection::open);
    ASSERT_EQ(connect(b, a), Connection::open);
    const bool seen = glm::dot(b.position - c.position, c.normal) > 0;
    ASSERT_TRUE(!seen || connect(b, c) == Connection::open);
  }
}

TEST_F(Connections, AreBlockedByWhatIsJustBeforeTheirEnd) {
  for (const double gap : {1e-3, 1e-6, 1e-9}) {
    SceneMaker maker(2);
    maker.segment({0, 0}, {4, 0}, {.bins = 1}).segment({4, 2}, {0, 2}, {.radiance = 1});
    maker.segment({0, gap}, {4, gap});
    scene_ = maker.build();
    EXPECT_EQ(connect(above(1), below(2)), Connection::occluded) << gap;
    EXPECT_EQ(connect(below(2), above(1)), Connection::occluded) << gap;
  }
}

// ---- values and densities

// Light, wall, sensor, with every number from its definition: ∫ cos θ dω = 2 in the plane.
class Vertices : public ::testing::TestWithParam<Roulette> {
 protected:
  void SetUp() override {
    SceneMaker maker(3);
    maker.segment({0, 0}, {4, 0}, {.bins = 1}).segment({4, 2}, {0, 2}, {.radiance = 3});
    maker.segment({0, 2}, {0, 0}, {maker.diffuse(0.6)});
    maker.segment({5, 0}, {5, 2}, {.radiance = 1});  // another light: 2 W beside 12
    scene_ = maker.build();
  }
  // The points (1, 2), (0, 1) and (2, 0), evaluated; `flipped` turns the normals of the ends.
  FlatPath path(bool flipped) {
    FlatPath x(3);
    x.resize(3);
    const double side = flipped ? -1 : 1;
    x[0].place = {{1, 2}, {0, -side}, {}, 1};
    x[1].place = {{0, 1}, {1, 0}, {}, 2};
    x[2].place = {{2, 0}, {0, side}, {}, 0};
    x[0].event = Event::emission;
    x[2].event = Event::detection;
    const Space space(*scene_, GetParam());
    for (const int i : {0, 1}) EXPECT_EQ(space.connect(x, i), Connection::open);
    for (const int i : {0, 1, 2}) space.evaluate(x, i);
    return x;
  }
  std::unique_ptr<const Scene<Flatland>> scene_;
};
INSTANTIATE_TEST_SUITE_P(Roulettes, Vertices,
                         ::testing::Values(Roulette::off, Roulette::by_albedo));

TEST_P(Vertices, HaveTheValuesAndDensitiesOfTheirDefinitions) {
  const FlatPath x = path(false);
  const double g0 = 0.5 / std::sqrt(2), g1 = 0.4 / std::sqrt(5);
  const double survival = GetParam() == Roulette::off ? 1 : 0.6;
  EXPECT_NEAR(x[0].value, 3, 1e-15);
  EXPECT_NEAR(x[1].value, 0.6 / 2, 1e-15);
  EXPECT_NEAR(x[2].value, 1.0 / 4, 1e-15);
  EXPECT_NEAR(x[0].from_light, 3.0 / 14, 1e-15);
  EXPECT_NEAR(x[1].from_light, g0 / 2, 1e-15);
  EXPECT_NEAR(x[2].from_light, survival * g1 / 2, 1e-15);
  EXPECT_NEAR(x[2].from_sensor, 1.0 / 4, 1e-15);
  EXPECT_NEAR(x[1].from_sensor, g1 / 2, 1e-15);
  EXPECT_NEAR(x[0].from_sensor, survival * g0 / 2, 1e-15);
}

TEST_P(Vertices, NeitherShineNorListenOnTheirBacks) {
  const FlatPath x = path(true);
  EXPECT_EQ(x[0].value, 0);
  EXPECT_EQ(x[1].from_light, 0);
  EXPECT_EQ(x[2].value, 0);
  EXPECT_EQ(x[1].from_sensor, 0);
}

// ---- inversion

struct Walk {
  const char* name;
  SceneMaker (*make)(int);
};

SceneMaker lens_before_glass(int max_vertices) {
  SceneMaker room(max_vertices);
  description::Camera camera;
  camera.position = {0.3, 0.2, 0};
  camera.target = {1.2, 0.6, 0};
  camera.fov_degrees = 70;
  camera.resolution = {4};
  camera.aperture_radius = 0.05;
  const std::size_t plaster = room.diffuse(0.7);
  room.camera(camera).room({{0, 0}, {2, 0}, {2, 1}, {0, 1.1}}, {plaster, 0.5});
  return room.circle({1.2, 0.6}, 0.2, {room.rough_glass(0.1, 1.5)});
}

class Inversion : public ::testing::TestWithParam<Walk> {};
INSTANTIATE_TEST_SUITE_P(Scenes, Inversion,
                         ::testing::Values(Walk{"full", &full_room},
                                           Walk{"lens", &lens_before_glass}),
                         [](const auto& info) { return std::string(info.param.name); });

// The way from the vertices of a walk to its numbers and back: the same place, by the same event.
TEST_P(Inversion, FindsNumbersThatMakeTheSameWalk) {
  const auto scene = GetParam().make(6).build();
  const Space space(*scene, Roulette::off);
  Rng random(1, Purpose::test, 0);
  FlatPath x(6), y(6);
  x.resize(6);
  int extended = 0;
  for (int k = 0; k < 5000; ++k)
    for (const Toward toward : {Toward::sensor, Toward::light}) {
      const bool up = toward == Toward::sensor;
      const int first = up ? 0 : 5, step = up ? 1 : -1;
      up ? space.begin_light(x, first, random) : space.begin_sensor(x, first, random);
      y = x;
      const auto begin = space.invert_begin(x, first, random);
      up ? space.begin_light(y, first, begin) : space.begin_sensor(y, first, begin);
      ASSERT_EQ(y[first].place.shape, x[first].place.shape);
      ASSERT_LT(glm::length(y[first].place.position - x[first].place.position), 1e-14);
      for (int i = first; i + step >= 0 && i + step < 6; i += step) {
        if (!space.extend(x, i, toward, random)) break;
        y = x;
        ASSERT_TRUE(space.extend(y, i, toward, space.invert_extend(x, i, toward, random)));
        ASSERT_EQ(y[i].event, x[i].event);
        // A direction has the digits of its number; a grazing hit spreads them.
        if (y[i + step].place.shape != x[i + step].place.shape) continue;
        ASSERT_LT(glm::length(y[i + step].place.position - x[i + step].place.position), 1e-5);
        ++extended;
      }
    }
  EXPECT_GT(extended, 20'000);
}

// ---- films

TEST(FilmBins, AreEqualPartsOfTheSensor) {
  const auto scene = full_room(4).build();
  ASSERT_EQ(scene->bins(), 6);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(scene->bin({(i + 0.001) / 6}), i);
    EXPECT_EQ(scene->bin({(i + 0.999) / 6}), i);
  }
}

// Rows from top to bottom, each from left to right: the first film coordinate runs along a row.
TEST(FilmBins, OfAnImageLieInRows) {
  SceneParts<Spaceland> parts;
  parts.materials = {Black<Spaceland>{}};
  parts.parts.push_back({Parallelogram<Spaceland>({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0, 0, true});
  parts.parts.push_back({Parallelogram<Spaceland>({0, 0, 1}, {0, 1, 0}, {1, 0, 0}), 0, 1, false});
  parts.resolution = {2, 3};  // height, width
  const Scene<Spaceland> scene(parts);
  EXPECT_EQ(scene.bins(), 6);
  EXPECT_EQ(scene.bin({0.1, 0.1}), 0);
  EXPECT_EQ(scene.bin({0.9, 0.1}), 2);
  EXPECT_EQ(scene.bin({0.1, 0.9}), 3);
  EXPECT_EQ(scene.bin({0.5, 0.9}), 4);
}

}  // namespace
}  // namespace wander::test

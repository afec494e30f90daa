// Furnaces: closed rooms in which the radiance is known whatever their form.
//   All walls emit Le and reflect ρ:    L from paths of k + 2 vertices is Le ρ^k, E = 2 L.
//   Kirchhoff: emission n (1 - albedo): L = n everywhere, n the index of refraction there.
// False-alarm rate 1e-9 per film.
#include <gtest/gtest.h>

#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

constexpr double radiance = 1.5, reflectance = 0.8;
constexpr int longest = 6;

SceneMaker concave_room() {
  SceneMaker maker(longest);
  const std::size_t wall = maker.diffuse(reflectance);
  const std::vector<PlanePoint> corners{{0, 0},   {2, 0},     {2, 1},     {1.1, 0.2},
                                        {1, 1.4}, {0.4, 0.5}, {-0.3, 0.9}};
  for (std::size_t i = 0; i < corners.size(); ++i)
    maker.segment(corners[i], corners[(i + 1) % corners.size()], {wall, radiance, i == 4 ? 3 : 0});
  return maker;
}
SceneMaker round_room() {
  SceneMaker maker(longest);
  return maker.circle({0.3, -1}, 2, {maker.diffuse(reflectance), radiance, 3},
                      SceneMaker::Normal::inward);
}
// Two walls that are arcs, and shade in the middle.
SceneMaker lens_shaped_room() {
  SceneMaker maker(longest);
  const std::size_t wall = maker.diffuse(reflectance);
  const description::Arc lower{{0, 1, 0}, std::sqrt(2), 225, 315, true},
      upper{{0, -1, 0}, std::sqrt(2), 45, 135, true};
  for (const auto& arc : {lower, upper})
    maker.shape(arc, {wall, radiance, arc.from_degrees == 45 ? 3 : 0});
  maker.circle({0.2, 0.1}, 0.1, {wall, radiance});
  return maker;
}

// Each length separately: n vertices carry 2 Le ρ^(n-2).
Decision truncated_furnace(const SampledFilm& film, double rho) {
  std::vector<Compared> all;
  double sum = 0;
  for (int n = 2; n <= longest; ++n) {
    const double exact = 2 * radiance * std::pow(rho, n - 2);
    for (const BinValue bin : film.by_vertices.at(n)) all.push_back(compared(bin, exact));
    sum += exact;
  }
  for (const BinValue bin : film.total) all.push_back(compared(bin, sum));
  return largest_z_test(all, usual_false_alarm);
}

class Furnace : public ::testing::TestWithParam<std::pair<const char*, SceneMaker (*)()>> {};

TEST_P(Furnace, IsFilledEvenlyByPathsOfEachLength) {
  const auto scene = GetParam().second().build();
  std::uint64_t seed = 0;
  for (const auto method : {"pt", "lt", "bdpt", "pt-naive", "lt-naive"}) {
    const auto film = sample_film(*scene, find_estimator(method), 60'000, ++seed);
    EXPECT_TRUE(passes(truncated_furnace(film, reflectance))) << method;
    EXPECT_TRUE(rejects(truncated_furnace(film, 0.85))) << method;
  }
}
INSTANTIATE_TEST_SUITE_P(Rooms, Furnace,
                         ::testing::Values(std::pair("concave", &concave_room),
                                           std::pair("round", &round_room),
                                           std::pair("lens_shaped", &lens_shaped_room)),
                         [](const auto& info) { return std::string(info.param.first); });

// A pool of glass under air; every wall emits what it does not reflect, times the index.
enum class Medium { air, glass };
constexpr double index_of(Medium medium) { return medium == Medium::glass ? 1.5 : 1; }

SceneMaker kirchhoff_room(Medium sensor, int max_vertices) {
  SceneMaker maker(max_vertices);
  const std::size_t wall = maker.diffuse(0.3), mirror = maker.mirror(0.9);
  const double in_glass = index_of(Medium::glass);
  maker.segment({0, 0}, {2, 0}, {wall, 0.7 * in_glass, sensor == Medium::glass ? 3 : 0});
  maker.segment({2, 0}, {2, 0.5}, {mirror, 0.1 * in_glass});
  maker.segment({2, 0.5}, {2, 1}, {mirror, 0.1});
  maker.segment({2, 1}, {0, 1.2}, {wall, 0.7, sensor == Medium::air ? 3 : 0});
  maker.segment({0, 1.2}, {0, 0.5}, {wall, 0.7});
  maker.segment({0, 0.5}, {0, 0}, {wall, 0.7 * in_glass});
  maker.segment({0, 0.5}, {2, 0.5}, {maker.glass(in_glass)});
  return maker;
}

TEST(KirchhoffFurnace, HasTheRadianceOfItsMedium) {
  std::uint64_t seed = 0;
  for (const Medium medium : {Medium::air, Medium::glass}) {
    const auto scene = kirchhoff_room(medium, 60).build();
    const double exact = 2 * index_of(medium);
    for (const auto method : {"pt", "lt", "bdpt", "pt-naive", "lt-naive"}) {
      const auto film = sample_film(*scene, find_estimator(method), 20'000, ++seed);
      EXPECT_TRUE(passes(matches(film.total, {exact, exact, exact})))
          << method << " in index " << index_of(medium);
    }
  }
}

TEST(KirchhoffFurnace, OfFewVerticesIsToldApart) {
  const auto scene = kirchhoff_room(Medium::glass, 3).build();
  const auto film = sample_film(*scene, find_estimator("pt"), 20'000, 1);
  EXPECT_TRUE(rejects(matches(film.total, {3, 3, 3})));
}

// A ball of glass in a black room at one temperature cannot be seen; inside it there is more light.
TEST(KirchhoffFurnace, HidesABallOfGlass) {
  std::uint64_t seed = 0;
  for (const Medium medium : {Medium::air, Medium::glass}) {
    SceneMaker maker(60);
    maker.segment({-1, -1}, {1, -1}, {{}, 1, medium == Medium::air ? 1 : 0});
    maker.segment({1, -1}, {1, 1}, {.radiance = 1}).segment({1, 1}, {-1, 1}, {.radiance = 1});
    maker.segment({-1, 1}, {-1, -1}, {.radiance = 1});
    maker.circle({0.1, 0}, 0.7, {maker.glass(1.5)});
    // So small that what its cold back takes out of the ball is below the noise.
    if (medium == Medium::glass) maker.segment({0.3, 0.1}, {0.301, 0.1}, {.bins = 1});
    const auto scene = maker.build();
    for (const auto method : {"pt", "pt-naive", "bdpt"}) {
      const auto film = sample_film(*scene, find_estimator(method), 20'000, ++seed);
      EXPECT_TRUE(passes(matches(film.total, {2 * index_of(medium)})))
          << method << " in index " << index_of(medium);
    }
  }
}

}  // namespace
}  // namespace wander::test

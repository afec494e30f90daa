// Scenes of Flatland whose films are known to ten digits or more, by every method that can find the
// light.  False-alarm rate 1e-9 per film.
#include <gtest/gtest.h>

#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/reference_values.h"

namespace wander::test {
namespace {

using Methods = std::vector<std::string_view>;
const Methods all_methods{"pt", "lt", "bdpt", "pt-naive", "lt-naive"};
constexpr int samples = 200'000;

template <std::size_t N>
std::vector<double> list(const std::array<double, N>& values) {
  return {values.begin(), values.end()};
}

void expect_film(const SceneMaker& maker, const Methods& methods,
                 const std::vector<double>& exact) {
  const auto scene = maker.build();
  std::uint64_t seed = 0;
  for (const auto method : methods) {
    const SampledFilm film = sample_film(*scene, find_estimator(method), samples, ++seed);
    EXPECT_TRUE(passes(matches(film.total, exact))) << method;
    std::vector<double> wrong = exact;  // control: an eighth too much
    for (double& value : wrong) value *= 1.125;
    EXPECT_TRUE(rejects(matches(film.total, wrong))) << method;
  }
}

TEST(Films, OfAParallelEmitterAreExact) {
  namespace scene = reference::parallel_emitter;
  SceneMaker maker(4);
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::sensor, {.bins = 4});
  expect_film(maker, all_methods, list(scene::film));
}

TEST(Films, BehindABlockerAreExact) {
  namespace scene = reference::blocker;
  SceneMaker maker(4);
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::obstacle);
  maker.line(scene::sensor, {.bins = 8});
  expect_film(maker, all_methods, list(scene::film));
}

TEST(Films, UnderAMirrorAreExact) {
  namespace scene = reference::mirror;
  SceneMaker maker(4);
  maker.line(scene::reflector, {maker.mirror(scene::reflectance)});
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::sensor, {.bins = 8});
  std::vector<double> exact = list(scene::film);
  std::ranges::reverse(exact);  // the sensor runs against x
  expect_film(maker, all_methods, exact);
}

// The sensor lies inside the glass: radiance there is larger by the index, and a walk from the
// light must not count that twice.
TEST(Films, InsideGlassAreExact) {
  namespace scene = reference::refraction;
  SceneMaker maker(6);
  maker.line(scene::interface, {maker.glass(1.5)});
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::sensor, {.bins = 4});
  expect_film(maker, all_methods, list(scene::film));
  const auto built = maker.build();
  for (const auto method : {"pt", "lt"}) {
    const SampledFilm film = sample_film(*built, find_estimator(method), samples, 1);
    EXPECT_TRUE(rejects(matches(film.total, list(scene::without_index_factor))));
  }
}

// Light inside the glass, sensor outside: by reciprocity the flux is the same as the other way.
TEST(Films, OutsideGlassHoldTheFluxOfTheReversePath) {
  namespace scene = reference::refraction;
  SceneMaker inward(6), outward(6);
  inward.line(scene::interface, {inward.glass(1.5)});
  inward.line(scene::emitter, {.radiance = 1}).segment({0, -1}, {2, -1}, {.bins = 1});
  outward.line(scene::interface, {outward.glass(1.5)});
  outward.line(scene::emitter, {.bins = 1}).segment({0, -1}, {2, -1}, {.radiance = 1});
  double flux = 0;
  for (const double irradiance : scene::film) flux += 0.5 * irradiance;
  const auto in = inward.build(), out = outward.build();
  for (const auto method : all_methods) {
    const auto film = sample_film(*in, find_estimator(method), samples, 1);
    EXPECT_TRUE(passes(matches(film.total, {flux / 2})));
    // Basic radiance L/n is what is reciprocal: the glass emits 1, which is 1/1.5 of it.
    const auto reverse = sample_film(*out, find_estimator(method), samples, 2);
    EXPECT_TRUE(passes(matches(reverse.total, {flux / 2 / 1.5}))) << method;
  }
}

TEST(Films, InACornerAreExact) {
  namespace scene = reference::corner;
  SceneMaker maker(4);
  maker.line(scene::emitter, {.radiance = scene::radiance}).segment({0, 0}, {1, 0}, {.bins = 8});
  std::vector<double> exact;  // 1 - (√(b²+1) - √(a²+1)) / (b - a), without cancellation
  for (int i = 0; i < 8; ++i) {
    const double a = i / 8.0, b = (i + 1) / 8.0;
    exact.push_back(1 - (b + a) / (std::sqrt(b * b + 1) + std::sqrt(a * a + 1)));
  }
  EXPECT_NEAR(exact[0], scene::floor_bins[1].mean_irradiance, scene::tolerance);
  EXPECT_NEAR(exact[1], scene::floor_bins[2].mean_irradiance, scene::tolerance);
  EXPECT_NEAR(exact[7], scene::floor_bins[3].mean_irradiance, scene::tolerance);
  expect_film(maker, all_methods, exact);
}

// G diverges as 1/r, the irradiance does not: E → Le.  The light walk seldom hits a millionth of
// the floor, and connections from there alone have no finite variance.
TEST(Films, WithinAMillionthOfACornerAreExact) {
  namespace scene = reference::corner;
  SceneMaker maker(4);
  maker.line(scene::emitter, {.radiance = scene::radiance}).segment({0, 0}, {1e-6, 0}, {.bins = 1});
  const auto built = maker.build();
  for (const auto method : {"pt", "bdpt", "pt-naive"}) {
    const auto film = sample_film(*built, find_estimator(method), samples, 1);
    EXPECT_TRUE(passes(matches(film.total, {scene::floor_bins[0].mean_irradiance}))) << method;
  }
}

struct CavityCase {
  const char* name;
  std::array<double, 4> reflectance;
  const std::array<reference::cavity::Row, 7>* rows;
};

class Cavity : public ::testing::TestWithParam<CavityCase> {
 public:
  static double of_wall(const reference::cavity::Row& row, std::size_t wall) {
    return wall == 0 ? row.floor : wall == 2 ? row.ceiling : row.side;
  }
  // Of paths with exactly 2, 3, 4 and 5 vertices, and of at most 9.
  static std::vector<double> by_vertices(const CavityCase& cavity, std::size_t wall) {
    std::vector<double> exact;
    double before = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double now = of_wall((*cavity.rows)[k], wall);
      exact.push_back(now - before);
      before = now;
    }
    return exact;
  }
};

TEST_P(Cavity, IsExactForEachLengthOnEachWall) {
  const CavityCase& cavity = GetParam();
  for (std::size_t sensor = 0; sensor < 3; ++sensor) {
    SceneMaker maker(9);
    for (std::size_t wall = 0; wall < 4; ++wall)
      maker.line(reference::cavity::walls[wall],
                 {maker.diffuse(cavity.reflectance[wall]), wall == 0 ? 1.0 : 0.0, wall == sensor});
    const auto scene = maker.build();
    const std::vector<double> exact = Cavity::by_vertices(cavity, sensor);
    for (const auto method : all_methods) {
      const auto film = sample_film(*scene, find_estimator(method), 50'000, sensor + 1);
      std::vector<Compared> all{
          compared(film.total[0], Cavity::of_wall((*cavity.rows)[4], sensor))};
      for (int n = 2; n <= 5; ++n)
        all.push_back(compared(film.by_vertices.at(n)[0], exact[static_cast<std::size_t>(n) - 2]));
      EXPECT_TRUE(passes(largest_z_test(all, usual_false_alarm))) << method << ", wall " << sensor;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Exact, Cavity,
                         ::testing::Values(CavityCase{"grey", reference::cavity::grey,
                                                      &reference::cavity::grey_irradiance},
                                           CavityCase{"mixed", reference::cavity::mixed,
                                                      &reference::cavity::mixed_irradiance}),
                         [](const auto& info) { return std::string(info.param.name); });

// The same numbers come from estimate(), which runs in parallel: as the program computes them.
TEST(Films, OfTheProgramItselfAreExact) {
  namespace scene = reference::blocker;
  SceneMaker maker(4);
  maker.line(scene::emitter, {.radiance = scene::radiance}).line(scene::obstacle);
  maker.line(scene::sensor, {.bins = 8});
  const auto built = maker.build();
  Session session;
  session.budget = SampleBudget{samples};
  session.threads = 1;
  for (const auto method : all_methods) {
    const Rendering one = estimate(*built, find_estimator(method), session);
    BinValues film;
    for (std::size_t i = 0; i < 8; ++i)
      film.push_back({one.film.value[i], one.film.standard_error[i]});
    EXPECT_TRUE(passes(matches(film, list(scene::film)))) << method;
    EXPECT_EQ(one.samples, samples);
    EXPECT_TRUE(one.complete);
    session.threads = 3;
    const Rendering three = estimate(*built, find_estimator(method), session);
    EXPECT_EQ(one.film.value, three.film.value);
    EXPECT_EQ(one.film.standard_error, three.film.standard_error);
    EXPECT_EQ(one.film.by_length, three.film.by_length);
    session.threads = 1;
  }
}

}  // namespace
}  // namespace wander::test

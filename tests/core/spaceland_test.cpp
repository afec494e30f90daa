// The same text in three dimensions: furnaces of spheres and boxes, a form factor in closed form,
// glass, and agreement of the estimators.  False-alarm rate 1e-9 per film.
#include <gtest/gtest.h>

#include "core/path_sides.h"
#include "tests/core/film_sampling.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

using W = Spaceland;
using Point = W::Point;
using Sheet = Parallelogram<W>;
using Ball = Sphere<W>;
constexpr double pi = std::numbers::pi;

// A box of six sheets whose normals look inwards, in the order floor, ceiling, x low, x high, y
// low, y high; from `low` to `high`.
std::array<Sheet, 6> box(Point low, Point high) {
  const Point x(high.x - low.x, 0, 0), y(0, high.y - low.y, 0), z(0, 0, high.z - low.z);
  return {Sheet(low, x, y),     Sheet(low + z, y, x), Sheet(low, y, z),
          Sheet(low + x, z, y), Sheet(low, z, x),     Sheet(low + y, x, z)};
}

void expect_all(const Scene<W>& scene, const std::vector<double>& exact, int samples,
                const std::vector<std::string_view>& methods) {
  std::uint64_t seed = 0;
  for (const auto method : methods) {
    const auto film = sample_film(scene, find_estimator(method), samples, ++seed);
    EXPECT_TRUE(passes(matches(film.total, exact))) << method;
  }
}

// E = π Le Σ ρ^k, each length on its own; a flat ρ^(D-1) or a 2 for the π would show at once.
void expect_furnace(const Scene<W>& scene, double radiance, double reflectance,
                    const std::vector<std::string_view>& methods) {
  std::uint64_t seed = 0;
  for (const auto method : methods) {
    const auto film = sample_film(scene, find_estimator(method), 40'000, ++seed);
    std::vector<Compared> all, wrong;
    for (const auto& [n, bins] : film.by_vertices)
      for (const BinValue bin : bins) {
        all.push_back(compared(bin, pi * radiance * std::pow(reflectance, n - 2)));
        wrong.push_back(compared(bin, 2 * radiance * std::pow(reflectance, n - 2)));
      }
    EXPECT_TRUE(passes(largest_z_test(all, usual_false_alarm))) << method;
    EXPECT_TRUE(rejects(largest_z_test(wrong, usual_false_alarm))) << method;
  }
}

// The sensor is black, but too small to be missed in the furnace.
TEST(Space, HasEvenLightInASphere) {
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.6}, Black<W>{}};
  parts.parts.push_back({Ball({0.2, 0, 0}, 1.5, Ball::Facing::inward), 0, 2, false});
  parts.parts.push_back({Sheet({0, 0, 0.3}, {1e-3, 0, 1e-4}, {0, 1e-3, 0}), 1, 0, true});
  parts.resolution = {2, 2};
  parts.max_vertices = 5;
  const Scene<W> scene(parts);
  expect_furnace(scene, 2, 0.6, {"pt", "bdpt", "pt-naive"});
}

TEST(Space, HasEvenLightInABox) {
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.5}};
  for (const Sheet& sheet : box({0, 0, 0}, {1, 2, 1.5}))
    parts.parts.push_back({sheet, 0, 1, false});
  parts.parts[3].is_sensor = true;
  parts.resolution = {2, 3};
  parts.max_vertices = 4;
  const Scene<W> scene(parts);
  expect_furnace(scene, 1, 0.5, {"pt", "lt", "bdpt", "pt-naive", "lt-naive"});
}

// Two unit squares at distance 1: F = 0.19982489569838..., E = π Le F [Howell, C-11].
TEST(Space, HasTheFormFactorOfParallelSquares) {
  const double root = std::sqrt(2.0);
  const double f =
      2 / pi * (0.5 * std::log(4.0 / 3) + 2 * root * std::atan(1 / root) - 2 * std::atan(1.0));
  EXPECT_NEAR(f, 0.1998248957, 1e-9);
  SceneParts<W> parts;
  parts.materials = {Black<W>{}};
  parts.parts.push_back({Sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 0, 0, true});
  parts.parts.push_back({Sheet({0, 0, 1}, {0, 1, 0}, {1, 0, 0}), 0, 3, false});
  parts.resolution = {1, 1};
  parts.max_vertices = 3;
  const Scene<W> scene(parts);
  expect_all(scene, {3 * pi * f}, 200'000, {"pt", "lt", "bdpt", "pt-naive", "lt-naive"});
  for (int s = 0; s <= 2; ++s) {
    const Estimator family{"", TechniqueSet{s, s, 2 - s, 2 - s}, Roulette::off, Heuristic::balance};
    const auto film = sample_film(scene, family, 200'000, 7);
    EXPECT_TRUE(passes(matches(film.total, {3 * pi * f}))) << "s = " << s;
    EXPECT_TRUE(rejects(matches(film.total, {3.1 * pi * f}))) << "s = " << s;
  }
}

// Kirchhoff: walls emit n² (1 - albedo), so the radiance is n² everywhere; a pool of glass and air.
TEST(Space, HasTheRadianceOfItsMedium) {
  constexpr double n = 1.5, floor = 0, surface = 0.5, top = 1;
  for (const bool in_glass : {false, true}) {
    SceneParts<W> parts;
    parts.materials = {Diffuse<W>{0.3}, Mirror<W>{0.8}, Dielectric<W>{n, 1}};
    const auto wet = box({0, 0, floor}, {1, 1, surface}), dry = box({0, 0, surface}, {1, 1, top});
    for (std::size_t i = 0; i < 6; ++i) {
      const std::size_t material = i == 3 ? 1 : 0;  // one wall is a mirror
      const double emits = material == 1 ? 0.2 : 0.7;
      // The two boxes meet in the interface, which is neither's wall.
      if (i != 1) parts.parts.push_back({wet[i], material, emits * n * n, in_glass && i == 0});
      if (i != 0) parts.parts.push_back({dry[i], material, emits, !in_glass && i == 1});
    }
    parts.parts.push_back({dry[0], 2, 0, false});  // normal upwards: glass below
    parts.resolution = {1, 2};
    parts.max_vertices = 40;
    const Scene<W> scene(parts);
    const double exact = pi * (in_glass ? n * n : 1);
    expect_all(scene, {exact, exact}, 20'000, {"pt", "lt", "bdpt", "pt-naive", "lt-naive"});
  }
}

SceneParts<W> furnished_box() {
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.6},
                     Mirror<W>{0.9},
                     Dielectric<W>{1.5, 1},
                     RoughConductor<W>{0.2, 0.9},
                     RoughDielectric<W>{0.3, 1.5, 1},
                     Black<W>{}};
  const auto walls = box({0, 0, 0}, {1, 1, 1});
  for (std::size_t i = 0; i < 6; ++i)
    parts.parts.push_back({walls[i],
                           i == 2   ? std::size_t{1}
                           : i == 4 ? std::size_t{3}
                                    : std::size_t{0},
                           0, false});
  parts.parts.push_back({Sheet({0.3, 0.3, 0.95}, {0, 0.4, 0}, {0.4, 0, 0}), 5, 4, false});
  parts.parts.push_back({Ball({0.3, 0.3, 0.25}, 0.2, Ball::Facing::outward), 2, 0, false});
  parts.parts.push_back({Ball({0.7, 0.6, 0.2}, 0.15, Ball::Facing::outward), 4, 0, false});
  parts.resolution = {2, 2};
  parts.max_vertices = 6;
  return parts;
}

TEST(Space, HasEstimatorsThatAgreeAmongAllMaterials) {
  SceneParts<W> parts = furnished_box();
  parts.parts[0].is_sensor = true;
  const Scene<W> scene(parts);
  const auto reference = sample_film(scene, find_estimator("bdpt"), 90'000, 1);
  for (const auto method : {"pt", "lt", "pt-naive", "lt-naive"})
    EXPECT_TRUE(passes(agree(sample_film(scene, find_estimator(method), 90'000, 2), reference)))
        << method;
}

// What a camera sees in a mirror no light walk can connect to it, so nothing here is specular.
TEST(Space, HasCamerasThatLightFindsAsItFindsSensors) {
  for (const double radius : {0.0, 0.05}) {
    SceneParts<W> parts = furnished_box();
    parts.materials[1] = RoughConductor<W>{0.4, 0.9};
    parts.materials[2] = RoughDielectric<W>{0.2, 1.5, 1};
    const Point axis = glm::normalize(Point(0.1, 1, 0));
    parts.camera = Camera<W>{.position = {0.5, 0.05, 0.5},
                             .axis = axis,
                             .across = {Point(axis.y, -axis.x, 0), Point(0, 0, -1)},
                             .extent = {1.2, 0.9},
                             .lens_radius = radius,
                             .focus_distance = 0.6};
    const Scene<W> scene(parts);
    const auto reference = sample_film(scene, find_estimator("bdpt"), 60'000, 1);
    for (const auto method : {"pt", "lt", "pt-naive"})
      EXPECT_TRUE(passes(agree(sample_film(scene, find_estimator(method), 60'000, 3), reference)))
          << method << ", lens " << radius;
  }
}

// Surfaces that do not touch, so that no edge of a path is short and every technique has a finite
// variance; lamp and sensor scatter, too.
SceneParts<W> disjoint_surfaces() {
  SceneParts<W> parts;
  parts.materials = {Diffuse<W>{0.8}, RoughConductor<W>{0.5, 0.9}};
  parts.parts.push_back({Sheet({0.1, 0.1, 0}, {0.8, 0, 0.05}, {0, 0.8, 0}), 0, 0, true});
  parts.parts.push_back({Sheet({0.2, 0.1, 1}, {0, 0.7, 0}, {0.6, 0, 0.1}), 0, 2, false});
  parts.parts.push_back({Sheet({-0.1, 0, 0.1}, {0, 1, 0}, {0, 0, 0.8}), 1, 0, false});
  parts.parts.push_back({Triangle<W>({1.1, 0, 0.1}, {1.1, 0, 1}, {1, 1.1, 0.3}), 0, 0, false});
  parts.parts.push_back({Ball({0.5, 1.2, 0.5}, 0.25, Ball::Facing::outward), 0, 0.7, false});
  parts.resolution = {2, 1};
  parts.max_vertices = 4;
  return parts;
}

// Every technique (s, t) by itself finds all light of paths of s + t vertices.
TEST(Space, HasTechniquesOfWhichEachFindsAllLight) {
  const Scene<W> scene(disjoint_surfaces());
  const auto reference = sample_film(scene, find_estimator("bdpt"), 300'000, 1);
  for (int n = 2; n <= 4; ++n)
    for (int s = 0; s <= n; ++s) {
      const Estimator family{"", TechniqueSet{s, s, n - s, n - s}, Roulette::off,
                             Heuristic::balance};
      const auto film = sample_film(scene, family, 100'000, static_cast<std::uint64_t>(10 * n + s));
      std::vector<Compared> all, wrong;
      BinValues half = reference.by_vertices.at(n);
      append_differences(all, film.by_vertices.at(n), half);
      for (BinValue& bin : half) bin.value /= 2;
      append_differences(wrong, film.by_vertices.at(n), half);
      EXPECT_TRUE(passes(largest_z_test(all, usual_false_alarm))) << s << " of " << n;
      EXPECT_TRUE(rejects(largest_z_test(wrong, usual_false_alarm))) << s << " of " << n;
    }
}

TEST(Space, WeighsTechniquesSoThatTheySumToOne) {
  SceneParts<W> parts = furnished_box();
  parts.parts[0].is_sensor = true;
  const Scene<W> scene(parts);
  const Transport<W> space(scene, Roulette::by_albedo);
  PathSampler<Transport<W>> sampler(space, all_techniques, Heuristic::power);
  Rng rng(3, Purpose::test, 0);
  for (int i = 0; i < 3000; ++i) {
    rng.start(static_cast<std::uint64_t>(i));
    sampler.sample(rng, [&](const Path<W>& x, int, double) {
      double sum = 0;
      for (int s = 0; s <= x.size(); ++s)
        if (can_sample(space, x, s, all_techniques))
          sum += sides_of(space, x, s, {all_techniques, Heuristic::power}).mis_weight();
      ASSERT_NEAR(sum, 1, 1e-12);
    });
  }
}

TEST(Space, IsEstimatedByTheProgramAsSampleBySample) {
  SceneParts<W> parts = furnished_box();
  parts.parts[0].is_sensor = true;
  const Scene<W> scene(parts);
  Session session;
  session.budget = SampleBudget{50'000};
  session.threads = 2;
  const Rendering rendering = estimate(scene, find_estimator("bdpt"), session);
  const auto reference = sample_film(scene, find_estimator("bdpt"), 50'000, 4);
  std::vector<Compared> all;
  for (std::size_t i = 0; i < 4; ++i) {
    const double error = std::hypot(rendering.film.standard_error[i], reference.total[i].error);
    all.push_back({(rendering.film.value[i] - reference.total[i].value) / error, error,
                   reference.total[i].value});
  }
  EXPECT_TRUE(passes(largest_z_test(all, usual_false_alarm)));
  EXPECT_EQ(rendering.film.shape, (std::vector<int>{2, 2}));
}

}  // namespace
}  // namespace wander::test

// The exact film of a scene file: against closed forms, against methods that draw random numbers,
// and against what it says of its own error where fixed meshes fail.
#include "core/exact/diffuse_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/exact/radiosity_refinement.h"
#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/reference_values.h"

namespace wander::test {
namespace {

using exact::diffuse_film;
using exact::DiffuseFilm;

template <std::size_t N>
void expect_within_error(const DiffuseFilm& film, const std::array<double, N>& value) {
  ASSERT_EQ(film.value.size(), N);
  for (std::size_t b = 0; b < N; ++b) {
    EXPECT_NEAR(film.value[b], value[b], film.error[b] + 1e-9 * value[b]) << b;
    EXPECT_LE(film.error[b], 1e-5 * value[b]) << b;
  }
}

TEST(DiffuseFilm, IsTheClosedFormOfDirectLight) {
  namespace parallel = reference::parallel_emitter;
  SceneMaker open(2);
  open.line(parallel::emitter, {.radiance = parallel::radiance})
      .line(parallel::sensor, {.bins = 4});
  expect_within_error(diffuse_film(open.description()), parallel::film);
  namespace shaded = reference::blocker;
  SceneMaker maker(4);
  maker.line(shaded::emitter, {.radiance = shaded::radiance}).line(shaded::obstacle);
  maker.line(shaded::sensor, {.bins = 8});
  expect_within_error(diffuse_film(maker.description()), shaded::film);
}

// Every wall emits and reflects: E = 2 Le Σ ρ^k everywhere.
TEST(DiffuseFilm, OfAFurnaceIsAGeometricSeries) {
  const std::vector<PlanePoint> room{{0, 0}, {2, 0}, {2, 0.7}, {0.9, 0.8}, {1, 2}, {0, 2}};
  SceneMaker maker(5);
  const std::size_t grey = maker.diffuse(0.8);
  for (std::size_t i = 0; i < room.size(); ++i)
    maker.line({room[i], room[(i + 1) % room.size()]}, {grey, 1, i == 3 ? 4 : 0});
  expect_within_error(diffuse_film(maker.description()),
                      std::array<double, 4>{5.904, 5.904, 5.904, 5.904});
}

// Lamp and sensor in black shafts whose mouths are 12 cm from ceiling and floor.  The lit strip of
// the ceiling throws a penumbra of 6 mm on the floor, which is in no mesh of shadow edges.
SceneMaker shafts() {
  SceneMaker maker(4);
  const std::size_t plaster = maker.diffuse(0.6);
  maker.segment({0, 0}, {4, 0}, {plaster}).segment({4, 3}, {0, 3}, {plaster});
  maker.segment({0.9, 2.25}, {0.9, 2.88}).segment({0.6, 2.88}, {0.6, 2.25});
  maker.segment({0.6, 2.25}, {0.9, 2.25}).segment({3.1, 0.12}, {3.1, 0.75});
  maker.segment({3.4, 0.75}, {3.4, 0.12}).segment({3.4, 0.75}, {3.1, 0.75});
  maker.segment({0.65, 2.26}, {0.85, 2.26}, {.radiance = 1});
  maker.segment({3.35, 0.74}, {3.15, 0.74}, {.bins = 10});
  return maker;
}

// A camera obscura: a lamp in a box with a slit lights a spot of the ceiling, which shines through a second slit of
// 2 mm onto a spot of the floor that is narrower than the way from one point of a wide bin to the next.  The second
// lamp keeps the bin from being dark.
SceneMaker camera_obscura(int bins) {
  SceneMaker maker(3);
  const std::size_t bright = maker.diffuse(0.8);
  maker.segment({0, 0}, {1, 0}, {.bins = bins});
  maker.segment({0, 0.5}, {0.53, 0.5}).segment({0.532, 0.5}, {1, 0.5});
  maker.segment({0, 0}, {0, 1}).segment({1, 0}, {1, 1}).segment({1, 1}, {0, 1}, {bright});
  maker.segment({0.72225, 0.52}, {0.72275, 0.52}, {.radiance = 1e6});
  maker.segment({0.6725, 0.5}, {0.6725, 0.6}).segment({0.7725, 0.5}, {0.7725, 0.6});
  maker.segment({0.6725, 0.6}, {0.72225, 0.6}).segment({0.72275, 0.6}, {0.7725, 0.6});
  return maker.segment({0.95, 0.3}, {0.9, 0.3}, {.radiance = 0.001});
}

// The mean of a film does not depend on its bins.
TEST(AdaptiveRadiosity, MissesNoSpotThatIsNarrowerThanABin) {
  const auto mean = [](int bins) {
    const DiffuseFilm film = diffuse_film(camera_obscura(bins).description());
    double sum = 0, error = 0;
    for (std::size_t b = 0; b < film.value.size(); ++b) {
      sum += film.value[b] / bins;
      error += film.error[b] / bins;
    }
    EXPECT_LE(error, 1e-4 * sum) << bins;
    return sum;
  };
  const double truth = mean(50);
  EXPECT_GT(truth, 4e-3);
  for (const int bins : {1, 2, 7}) EXPECT_NEAR(mean(bins), truth, 2e-4 * truth) << bins;
}

// A wall stands 9e-8 beside the edge of two bins; turned around, on the other side.
TEST(DiffuseFilm, HasItsBinsWhereTheyAre) {
  const auto film_with_wall_at = [](double x) {
    SceneMaker maker(2);
    maker.segment({0, 0}, {1, 0}, {.bins = 10'000}).segment({x, 0.1}, {x, 0.3});
    return diffuse_film(maker.segment({1, 1}, {0, 1}, {.radiance = 1}).description());
  };
  const DiffuseFilm left = film_with_wall_at(0.5 - 9e-8), right = film_with_wall_at(0.5 + 9e-8);
  for (std::size_t b = 0; b < left.value.size(); ++b)
    ASSERT_NEAR(left.value[b], right.value[left.value.size() - 1 - b], 1e-10) << b;
}

// Largest error of a film in units of what it says of its error.
double largest_excess(const SensorFilm& film, const SensorFilm& truth,
                      const std::vector<double>& claim) {
  double largest = 0;
  for (std::size_t b = 0; b < claim.size(); ++b)
    largest =
        std::max(largest, std::abs(film.mean_irradiance[b] - truth.mean_irradiance[b]) / claim[b]);
  return largest;
}

TEST(AdaptiveRadiosity, KnowsItsErrorWhereReflectedLightHasNarrowPenumbras) {
  const RadiosityScene scene = radiosity_scene(shafts().description());
  const SensorFilm truth = exact::solve_radiosity_adaptively(scene, {.tolerance = 1e-9}).film();
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const SensorFilm film =
        exact::solve_radiosity_adaptively(scene, {.tolerance = tolerance}).film();
    EXPECT_LE(largest_excess(film, truth, film.error), 1) << tolerance;
  }
  // Control: a fixed mesh of more unknowns, with the accuracy that it has in smoother rooms.
  const SensorFilm fixed = solve_radiosity(scene).film();
  std::vector<double> claim;
  for (const double value : truth.mean_irradiance) claim.push_back(1e-5 * value);
  EXPECT_GT(largest_excess(fixed, truth, claim), 100);
}

// Where no mesh is good enough the last one that is small enough stands, and says what it lacks.
TEST(AdaptiveRadiosity, EndsWhereUnknownsRunOut) {
  const RadiosityScene scene = radiosity_scene(shafts().description());
  const auto coarse = exact::solve_radiosity_adaptively(scene, {.tolerance = 1});
  const std::size_t most = 2 * coarse.unknowns;
  const auto finest =
      exact::solve_radiosity_adaptively(scene, {.tolerance = 0, .most_unknowns = most});
  EXPECT_GT(finest.unknowns, coarse.unknowns);
  EXPECT_LE(finest.unknowns, most);
}

TEST(DiffuseFilm, IsWhatRandomPathsFind) {
  const SceneMaker maker = shafts();
  const DiffuseFilm exact = diffuse_film(maker.description());
  const auto film = sample_film(*maker.build(), find_estimator("bdpt"), 400'000, 1);
  EXPECT_TRUE(passes(matches(film.total, exact.value)));
  double mean = 0;
  for (const double value : exact.value) mean += value / 10;
  EXPECT_TRUE(passes(matches({film.mean}, {mean})));
  std::vector<double> wrong = exact.value;  // control: half as much again
  for (double& value : wrong) value *= 1.5;
  EXPECT_TRUE(rejects(matches(film.total, wrong)));
}

TEST(DiffuseFilm, OfADarkSceneIsZero) {
  SceneMaker maker(6);
  const std::size_t grey = maker.diffuse(0.5);
  maker.segment({0, 1}, {1, 1}, {.radiance = 1});  // looks away
  maker.segment({1, 0}, {0, 0}, {grey, 0, 4});
  const DiffuseFilm film = diffuse_film(maker.description());
  for (const double value : film.value) EXPECT_EQ(value, 0);
  for (const double error : film.error) EXPECT_EQ(error, 0);
}

std::string refusal(const description::Scene& scene) {
  try {
    diffuse_film(scene);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

TEST(DiffuseFilm, SaysWhyThereIsNone) {
  SceneMaker glossy(4);
  glossy.segment({0, 0}, {1, 0}, {glossy.mirror(1)});
  glossy.segment({0, 1}, {1, 1}, {.bins = 1});
  EXPECT_NE(refusal(glossy.description()).find("neither diffuse nor black"), std::string::npos);
  EXPECT_EQ(refusal(shafts().description()), "");
  description::Scene long_paths = shafts().description();
  long_paths.max_vertices = 101;
  EXPECT_NE(refusal(long_paths).find("100 vertices"), std::string::npos);
  SceneMaker crowded(3);
  for (int i = 0; i < 201; ++i) crowded.segment({0, 2.0 + i}, {1, 2.0 + i});
  crowded.segment({0, 0}, {1, 0}, {.bins = 1});
  EXPECT_NE(refusal(crowded.description()).find("200 walls"), std::string::npos);
}

}  // namespace
}  // namespace wander::test

// The camera of Flatland: a flat film at distance 1 whose bins hold mean radiance, leftmost first.
#include "core/camera.h"

#include <gtest/gtest.h>

#include "tests/core/directions.h"
#include "tests/core/film_sampling.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

// Looks along +y from the origin, 90 degrees wide: the film reaches from x = -1 to 1 at y = 1.
description::Camera ahead(int bins, double aperture = 0) {
  description::Camera camera;
  camera.target = {0, 2, 0};
  camera.fov_degrees = 90;
  camera.resolution = {bins};
  camera.aperture_radius = aperture;
  return camera;
}

TEST(Cameras, PutWhatIsLeftIntoTheFirstBin) {
  SceneMaker maker(2);
  maker.camera(ahead(4)).segment({-1.2, 2}, {-1.8, 2}, {.radiance = 1});  // x/y from -0.9 to -0.6
  const auto scene = maker.build();
  const auto film = sample_film(*scene, find_estimator("pt"), 100'000, 1);
  EXPECT_TRUE(passes(matches(film.total, {0.6, 0, 0, 0})));
}

// Equal bins on a line: a lamp at a fixed height covers as many of them as it is wide.
TEST(Cameras, HaveAFlatFilm) {
  SceneMaker maker(2);
  maker.camera(ahead(8)).segment({2, 2}, {-0.25, 2}, {.radiance = 3});
  const auto scene = maker.build();
  for (const auto method : {"pt", "lt", "bdpt", "pt-naive"}) {
    const auto film = sample_film(*scene, find_estimator(method), 100'000, 2);
    EXPECT_TRUE(passes(matches(film.total, {0, 0, 0, 1.5, 3, 3, 3, 3}))) << method;
    EXPECT_TRUE(rejects(matches(film.total, {0, 0, 0, 1.8, 3, 3, 3, 3}))) << method;
  }
}

TEST(Cameras, TurnWithTheirTarget) {
  SceneMaker maker(2);
  description::Camera camera = ahead(2);
  camera.position = {3, 1, 0};
  camera.target = {0, 1, 0};  // looks along -x: left is -y
  maker.camera(camera).segment({1, 0}, {1, 0.9}, {.radiance = 1}).segment({1, -1}, {1, 0});
  const auto scene = maker.build();
  const auto film = sample_film(*scene, find_estimator("pt"), 50'000, 3);
  EXPECT_EQ(film.total[0].value, 0);  // the lamp faces away: left of (0, 1) is -x
  SceneMaker facing(2);
  facing.camera(camera).segment({1, 1}, {1, 0}, {.radiance = 1});
  const auto seen = sample_film(*facing.build(), find_estimator("pt"), 50'000, 3);
  EXPECT_TRUE(passes(matches(seen.total, {0.5, 0})));
}

// Mean radiance, whatever the lens: an even furnace looks the same everywhere.
TEST(Cameras, SeeTheRadianceOfAFurnace) {
  for (const double aperture : {0.0, 0.3}) {
    SceneMaker maker(5);
    description::Camera camera = ahead(5, aperture);
    camera.focus_distance = 0.8;
    maker.camera(camera);
    maker.room({{-2, -1}, {2, -1}, {2.5, 3}, {-2, 2}}, {maker.diffuse(0.5), 2});
    const auto scene = maker.build();
    const double exact = 2 * (1 + 0.5 + 0.25 + 0.125);
    for (const auto method : {"pt", "lt", "bdpt", "pt-naive"}) {
      const auto film = sample_film(*scene, find_estimator(method), 100'000, 4);
      EXPECT_TRUE(passes(matches(film.total, std::vector<double>(5, exact))))
          << method << ", aperture " << aperture;
    }
  }
}

TEST(Cameras, AgreeByPathAndLightTracing) {
  for (const double aperture : {0.0, 0.1}) {
    SceneMaker maker(5);
    description::Camera camera = ahead(6, aperture);
    camera.position = {1, 0.1, 0};
    camera.target = {1.1, 1, 0};
    maker.camera(camera);
    const std::size_t plaster = maker.diffuse(0.7);
    maker.segment({0, 1}, {2, 1.2}, {maker.rough_metal(0.3, 0.9)})
        .segment({2, 0.5}, {2, 1}, {plaster});
    maker.segment({0.1, 0.9}, {0.3, 0.3}, {plaster, 2}).circle({1.3, 0.8}, 0.1, {plaster});
    maker.segment({2, 0}, {1.2, 0}, {plaster, 1});
    const auto scene = maker.build();
    const auto reference = sample_film(*scene, find_estimator("bdpt"), 100'000, 5);
    for (const auto method : {"pt", "lt", "pt-naive"})
      EXPECT_TRUE(passes(agree(sample_film(*scene, find_estimator(method), 100'000, 6), reference)))
          << method << ", aperture " << aperture;
  }
}

Camera<Flatland> lens(double radius) {
  return {.position = {0.2, 0.1},
          .axis = {0.6, 0.8},
          .across = {Flatland::Direction(0.8, -0.6)},
          .extent = {1.4},
          .lens_radius = radius,
          .focus_distance = 1.7};
}

TEST(Cameras, HaveDirectionsOfTotalProbabilityOne) {
  for (const double radius : {0.0, 0.25})
    for (const double across : {-1.0, 0.3, 1.0}) {
      const auto camera = lens(radius);
      const auto point = camera.position + radius * across * camera.across[0];
      const auto angle = [&](double film) {
        const auto w = camera.sample_direction(point, {film});
        return std::atan2(wander::cross(camera.axis, w), glm::dot(camera.axis, w));
      };
      // Per unit of projected angle: times the cosine at the lens it is per unit of angle.
      const auto density = [&](double theta) {
        const auto w = std::cos(theta) * camera.axis + std::sin(theta) * left_of(camera.axis);
        return camera.direction_density(point, w) * std::cos(theta);
      };
      EXPECT_NEAR(integral(density, angle(1), angle(0)), 1, 1e-10);
      EXPECT_EQ(density(angle(1) - 1e-9), 0);
      EXPECT_EQ(density(angle(0) + 1e-9), 0);
    }
}

// A pinhole's directions have nothing to do with where it is, nor with what is sharp.
TEST(Cameras, ArePinholesBlindToWhereTheyFocus) {
  auto camera = lens(0);
  const auto ahead = camera.sample_direction(camera.position, {0.3});
  for (const double focus : {1e-300, 1e-17, 1.0, 1e17, 1e300}) {
    camera.focus_distance = focus;
    camera.position = {focus * 0.2, 100};
    const auto w = camera.sample_direction(camera.position, {0.3});
    EXPECT_EQ(w, ahead) << focus;
    const auto film = camera.film_coordinate(camera.position, w);
    ASSERT_TRUE(film) << focus;
    EXPECT_NEAR((*film)[0], 0.3, 1e-14) << focus;
  }
}

// What is at the distance of focus is sharp: rays from all points of the lens to one of the film meet there.
TEST(Cameras, KeepSharpWhatIsAtTheDistanceOfFocus) {
  const auto camera = lens(0.25);
  for (const double film : {0.0, 0.3, 0.9}) {
    const auto focus =
        camera.position +
        camera.focus_distance * (camera.axis + camera.extent[0] * (film - 0.5) * camera.across[0]);
    for (const double u : {0.1, 0.5, 0.8}) {
      const auto point = camera.sample_lens({u});
      const auto w = camera.sample_direction(point, {film});
      EXPECT_NEAR(glm::dot(w, glm::normalize(focus - point)), 1, 1e-15);
      EXPECT_NEAR(wander::cross(w, focus - point), 0, 1e-14);
    }
  }
}

// A lens whose density no number holds is a pinhole.
TEST(Cameras, WithATinyLensArePinholes) {
  for (const double radius : {0.0, 1e-310, 1e-200, 1e-100}) {
    const auto camera = lens(radius);
    EXPECT_EQ(camera.is_pinhole(), radius < 1e-300);
    EXPECT_TRUE(std::isfinite(camera.lens_density()));
  }
  const auto is_pinhole = [](double radius) {
    const Camera<Spaceland> camera{.position = {},
                                   .axis = {0, 0, 1},
                                   .across = {Spaceland::Direction(1, 0, 0), {0, 1, 0}},
                                   .extent = {1, 1},
                                   .lens_radius = radius};
    EXPECT_TRUE(std::isfinite(1e6 * camera.lens_density())) << radius;
    return camera.is_pinhole();
  };
  EXPECT_TRUE(is_pinhole(1e-200));
  EXPECT_TRUE(is_pinhole(1e-154));
  EXPECT_FALSE(is_pinhole(1e-100));
}

TEST(Cameras, SampleDirectionsWithTheirDensity) {
  Generator g(1);
  const auto camera = lens(0.25);
  const auto point = camera.sample_lens({0.8});
  const auto sample = [&] {
    return std::optional(cube_of<2>(camera.sample_direction(point, {g.uniform()})));
  };
  const auto density = [&](const CubePoint<1>& u) {
    const auto w = direction_of<2>(u);
    return all_directions<2> * camera.direction_density(point, w) *
           std::max(0.0, glm::dot(w, camera.axis));
  };
  EXPECT_TRUE(passes((sampler_matches_density<1>(sample, density))));
}

TEST(Cameras, KnowTheNumbersOfALensPointAndADirection) {
  Generator g(2);
  const auto camera = lens(0.25);
  for (int i = 0; i < 1000; ++i) {
    const double u = g.uniform(), film = g.uniform();
    const auto point = camera.sample_lens({u});
    EXPECT_NEAR(camera.invert_lens(point)[0], u, 1e-14);
    const auto coordinate = camera.film_coordinate(point, camera.sample_direction(point, {film}));
    ASSERT_TRUE(coordinate);
    EXPECT_NEAR((*coordinate)[0], film, 1e-14);
  }
  EXPECT_FALSE(camera.film_coordinate(camera.position, -camera.axis));
  EXPECT_FALSE(camera.film_coordinate(camera.position, camera.across[0]));
  EXPECT_DOUBLE_EQ(lens(0.25).lens_density(), 2);
}

TEST(Cameras, KeepThePlaneOfFocusSharp) {
  Generator g(3);
  const auto camera = lens(0.25);
  const auto focus = camera.position + 1.7 * (camera.axis + 0.2 * camera.across[0]);
  for (int i = 0; i < 100; ++i) {
    const auto point = camera.sample_lens({g.uniform()});
    EXPECT_NEAR((*camera.film_coordinate(point, glm::normalize(focus - point)))[0], 0.5 + 0.2 / 1.4,
                1e-14);
  }
}

}  // namespace
}  // namespace wander::test

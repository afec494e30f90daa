// The camera of Spaceland: its lens is covered evenly, its directions have the density that it
// claims, and numbers, points and directions are known from one another.  False-alarm rate 1e-9 per
// χ² test.
#include <gtest/gtest.h>

#include <optional>

#include "core/camera.h"
#include "tests/core/directions.h"
#include "tests/support/expect.h"

namespace wander::test::space_camera_test {
namespace {

using SpaceCamera = Camera<Spaceland>;
using Direction = Spaceland::Direction;

// Looks along no axis; the film is wider than it is high.
SpaceCamera lens(double radius) {
  const Direction axis = glm::normalize(Direction(0.3, -0.5, 0.8)),
                  right = glm::normalize(glm::cross(axis, Direction(0.1, 1, 0))),
                  down = glm::cross(axis, right);
  return {.position = {0.2, 0.1, -0.4},
          .axis = axis,
          .across = {right, down},
          .extent = {1.9, 1.3},
          .lens_radius = radius,
          .focus_distance = 1.7};
}

// `power` of the cosine: 4, as one has to divide a unit of the film by; with another it is a twin.
Decision directions_match(double radius, double power) {
  Generator g(1);
  const SpaceCamera camera = lens(radius);
  const auto point = camera.sample_lens({0.8, 0.3});
  const auto sample = [&] {
    return std::optional(cube_of<3>(camera.sample_direction(point, {g.uniform(), g.uniform()})));
  };
  const auto density = [&](const CubePoint<2>& u) {
    const Direction w = direction_of<3>(u);
    const double cosine = glm::dot(w, camera.axis);
    if (!(cosine > 0)) return 0.0;
    return all_directions<3> * camera.direction_density(point, w) * cosine *
           std::pow(cosine, 4 - power);
  };
  return sampler_matches_density<2>(sample, density, direction_options<3>());
}

TEST(SpaceCameras, SampleDirectionsWithTheirDensity) {
  EXPECT_TRUE(passes(directions_match(0, 4)));
  EXPECT_TRUE(passes(directions_match(0.25, 4)));
  EXPECT_TRUE(rejects(directions_match(0.25, 3)));
}

TEST(SpaceCameras, CoverTheirLensEvenly) {
  Generator g(2);
  const SpaceCamera camera = lens(0.25);
  const auto matches = [&](double exponent) {
    const auto sample = [&] {
      const Direction off =
          camera.sample_lens({g.uniform(), std::pow(g.uniform(), exponent)}) - camera.position;
      return std::optional(CubePoint<2>{glm::dot(off, camera.across[0]) / 0.5 + 0.5,
                                        glm::dot(off, camera.across[1]) / 0.5 + 0.5});
    };
    const auto density = [&](const CubePoint<2>& u) {
      const double inside = std::hypot(u[0] - 0.5, u[1] - 0.5);
      return inside < 0.5 ? 0.25 * camera.lens_density() : 0.0;
    };
    return sampler_matches_density<2>(sample, density, direction_options<3>());
  };
  EXPECT_TRUE(passes(matches(1)));
  EXPECT_TRUE(rejects(matches(1.1)));
}

TEST(SpaceCameras, KnowTheNumbersOfALensPointAndADirection) {
  Generator g(3);
  const SpaceCamera camera = lens(0.25);
  for (int i = 0; i < 1000; ++i) {
    const Spaceland::Square u{g.uniform(), g.uniform()}, film{g.uniform(), g.uniform()};
    const auto point = camera.sample_lens(u);
    EXPECT_LE(glm::length(point - camera.position), 0.25 * (1 + 1e-14));
    EXPECT_NEAR(glm::dot(point - camera.position, camera.axis), 0, 1e-15);
    const auto again = camera.sample_lens(camera.invert_lens(point));
    EXPECT_NEAR(glm::length(again - point), 0, 1e-14);
    const auto found = camera.film_coordinate(point, camera.sample_direction(point, film));
    ASSERT_TRUE(found);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR((*found)[k], film[k], 1e-14);
      EXPECT_NEAR(camera.invert_lens(point)[k], u[k], 1e-8);
    }
  }
  EXPECT_FALSE(camera.film_coordinate(camera.position, -camera.axis));
  EXPECT_FALSE(camera.film_coordinate(camera.position, camera.across[1]));
  EXPECT_NEAR(camera.lens_density(), 16 / std::numbers::pi, 1e-13);
  EXPECT_EQ(lens(0).lens_density(), 1);
}

TEST(SpaceCameras, KeepThePlaneOfFocusSharp) {
  Generator g(4);
  const SpaceCamera camera = lens(0.25);
  const auto focus =
      camera.position + 1.7 * (camera.axis + 0.2 * camera.across[0] - 0.3 * camera.across[1]);
  for (int i = 0; i < 100; ++i) {
    const auto point = camera.sample_lens({g.uniform(), g.uniform()});
    const auto film = camera.film_coordinate(point, glm::normalize(focus - point));
    ASSERT_TRUE(film);
    EXPECT_NEAR((*film)[0], 0.5 + 0.2 / 1.9, 1e-14);
    EXPECT_NEAR((*film)[1], 0.5 - 0.3 / 1.3, 1e-14);
  }
}

}  // namespace
}  // namespace wander::test::space_camera_test

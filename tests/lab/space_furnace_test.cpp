// A closed mesh that shines and scatters, of skewed triangles: whatever is seen in it has the
// radiance Le (1 + ρ + ρ² + …), of as many terms as the paths are long, in each channel; here through
// a lens.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include <cmath>

#include "lab/engine.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/space_maker.h"

namespace wander::test::space_furnace_test {
namespace {

using Colour = std::array<double, 3>;
constexpr int max_vertices = 5;
constexpr Colour radiance{2, 1, 3}, reflectance{0.5, 0.25, 0.75};

// An octahedron with unequal corners, whose outside is where the camera is: within.
description::Mesh shell() {
  Triangles triangles;
  triangles.points = {{1.5, 0, 0.1},  {-1, 0.2, 0}, {0, 2, 0},
                      {0.3, -1, 0.2}, {0, 0, 1.8},  {0.1, 0, -1}};
  for (const auto& [x, y, z] : std::initializer_list<std::array<std::int32_t, 3>>{
           {0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})
    triangles.corners.push_back({x, z, y});
  description::Mesh mesh;
  mesh.triangles = std::make_shared<const Triangles>(std::move(triangles));
  return mesh;
}

description::Scene furnace() {
  SpaceMaker maker(max_vertices);
  const auto quantity = [](Colour c) { return SpaceMaker::colour(c[0], c[1], c[2]); };
  const std::size_t wall = maker.diffuse(quantity(reflectance));
  maker.shape(shell(), {.material = wall, .radiance = quantity(radiance)});
  description::Camera camera;
  camera.target = {0.3, 1, 0.2};
  camera.up = {0, 0, 1};
  camera.fov_degrees = 80;
  camera.resolution = {3, 2};
  camera.aperture_radius = 0.1;
  maker.camera(camera);
  return maker.description();
}

FilmEstimate exact_film(const std::vector<int>& shape, int terms) {
  FilmEstimate film{.shape = shape, .degrees_of_freedom = 1};
  for (std::size_t i = 0; i < 3 * 6; ++i) {
    const double rho = reflectance[i % 3];
    film.value.push_back(radiance[i % 3] * (1 - std::pow(rho, terms)) / (1 - rho));
  }
  film.standard_error.assign(film.value.size(), 0);
  film.reliable.assign(film.value.size(), true);
  return film;
}

class FurnaceOfAMesh : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Methods, FurnaceOfAMesh,
                         ::testing::Values("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(FurnaceOfAMesh, HasTheRadianceThatIsKnown) {
  Session session;
  session.budget = SampleBudget{60'000};
  session.threads = 2;
  const FilmEstimate film = render(Job(furnace(), find_method(GetParam())), session).film;
  const Decision decision =
      films_agree(film, exact_film(film.shape, max_vertices - 1), usual_false_alarm);
  EXPECT_TRUE(passes(decision));
  EXPECT_GE(decision.comparisons, film.value.size() / 2);
  EXPECT_TRUE(rejects(films_agree(film, exact_film(film.shape, 1), usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test::space_furnace_test

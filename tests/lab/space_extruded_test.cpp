// A room of the plane, drawn out along z between two mirrors that reflect everything, is as long as
// one likes, and light in it does not depend on z.  Of a strip of infinite length and exitance B,
// at the distance ρ in the plane,
//   E = B/π ∫ cos θ cos θ' / (ρ² + z²) dA = B/π  c c' ρ² ∫ dz/(ρ² + z²)² ds = B/2  c c'/ρ ds,
// with c, c' the cosines in the plane: what the plane has for the exitance B.  So radiances of
// L in the plane and 2L/π in space give the same film, of which the plane's is known exactly.
// The mirrors lengthen paths; as far from each other as here, that keeps less than 0.2 % of the light
// from paths of so many vertices.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include <numbers>

#include "core/exact/diffuse_film.h"
#include "lab/engine.h"
#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/space_maker.h"

namespace wander::test::space_extruded_test {
namespace {

constexpr int bins = 4, max_vertices = 12;

// Two rooms and the gap between them; wall, ceiling and floor reflect unequally.
description::Scene plane_room() {
  SceneMaker maker(max_vertices);
  const std::size_t dark = maker.diffuse(0.25), bright = maker.diffuse(0.5);
  maker.segment({0, 0}, {2, 0.1}, {bright, 0, bins});
  maker.segment({2, 0.1}, {1.9, 1}, {dark});
  maker.segment({1.9, 1}, {0, 1.1}, {bright});
  maker.segment({0, 1.1}, {0, 0}, {dark});
  maker.segment({1.1, 0.45}, {0.9, 0.8}, {bright});
  maker.segment({1.7, 0.9}, {1.3, 0.95}, {bright, 3});
  return maker.description();
}

description::Scene drawn_out(const description::Scene& plane, double length, double brightness) {
  SpaceMaker maker(max_vertices);
  for (const description::Material& material : plane.materials) maker.material(material.kind);
  for (const description::Shape& shape : plane.shapes) {
    const auto& [from, to] = std::get<description::Segment>(shape.kind);
    SpaceMaker::Role role{.material = shape.material};
    if (shape.light)
      role.radiance = SpaceMaker::grey(brightness * luminance(shape.light->radiance));
    if (shape.sensor) role.resolution = {bins, 1};
    maker.parallelogram({from[0], from[1], length}, {to[0] - from[0], to[1] - from[1], 0},
                        {0, 0, -length}, role);
  }
  const std::size_t mirror = maker.mirror(SpaceMaker::grey(1));
  for (const double z : {0.0, length})
    maker.parallelogram({-1, -1, z}, {4, 0, 0}, {0, 4, 0}, {.material = mirror});
  return maker.description();
}

FilmEstimate exact_film(const description::Scene& plane) {
  FilmEstimate film{.value = exact::diffuse_film(plane).value, .degrees_of_freedom = 1};
  film.standard_error.assign(film.value.size(), 0);
  film.reliable.assign(film.value.size(), true);
  return film;
}

struct Contender {
  const char* method;
  std::uint64_t samples;
};
class DrawnOutRoom : public ::testing::TestWithParam<Contender> {};

TEST_P(DrawnOutRoom, HasTheLightOfThePlane) {
  Session session;
  session.budget = SampleBudget{GetParam().samples};
  session.threads = 2;
  const description::Scene plane = plane_room();
  const description::Scene space = drawn_out(plane, 6, 2 / std::numbers::pi);
  const FilmEstimate film = render(Job(space, find_method(GetParam().method)), session).film;
  const FilmEstimate exact = exact_film(plane);
  const Decision decision = films_agree(film, exact, usual_false_alarm);
  EXPECT_TRUE(passes(decision));
  EXPECT_GE(decision.comparisons, 2u);
  FilmEstimate of_equal_radiance = exact;  // the wrong twin
  for (double& value : of_equal_radiance.value) value *= std::numbers::pi / 2;
  EXPECT_TRUE(rejects(films_agree(film, of_equal_radiance, usual_false_alarm)));
}

// The bin behind the wall between the rooms is dark, and not always reliable.
INSTANTIATE_TEST_SUITE_P(Methods, DrawnOutRoom,
                         ::testing::Values(Contender{"pt", 60'000}, Contender{"lt", 60'000},
                                           Contender{"bdpt", 40'000}, Contender{"mlt", 80'000},
                                           Contender{"pssmlt", 30'000}, Contender{"mmlt", 80'000}),
                         [](const auto& info) { return std::string(info.param.method); });

}  // namespace
}  // namespace wander::test::space_extruded_test

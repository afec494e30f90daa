// Films in space against closed forms, by every method and in each channel: light of a polygon, a
// triangle and a ball on a parallelogram and on a triangle, point by point; light in a mirror, which is that of the
// mirror image; light through a slab of glass and back from it, with all its inner reflections.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/engine.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"
#include "tests/support/form_factors.h"
#include "tests/support/mirror_image.h"
#include "tests/support/space_maker.h"

namespace wander::test {
namespace {

using Maker = SpaceMaker;
using Colour = std::array<double, 3>;
constexpr int columns = 3, rows = 2;

Maker::Quantity quantity(Colour c) { return Maker::colour(c[0], c[1], c[2]); }
Maker::Coordinates coordinates(SpacePoint p) { return {p.x, p.y, p.z}; }

// Irradiance or radiance per pixel, times a colour.
struct Share {
  std::vector<double> pixels;
  Colour colour;
};
FilmEstimate exact_film(const std::vector<Share>& shares) {
  FilmEstimate film{.shape = {rows, columns, 3}, .degrees_of_freedom = 1};
  film.value.resize(3 * rows * columns);
  for (const Share& share : shares)
    for (std::size_t i = 0; i < film.value.size(); ++i)
      film.value[i] += share.pixels.at(i / 3) * share.colour[i % 3];
  film.standard_error.assign(film.value.size(), 0);
  film.reliable.assign(film.value.size(), true);
  return film;
}
FilmEstimate upside_down(FilmEstimate film) {
  std::rotate(film.value.begin(), film.value.begin() + 3 * columns, film.value.end());
  return film;
}

// Chains have wide intervals after few samples.
FilmEstimate film_of(const Maker& maker, std::string_view method) {
  Session session;
  session.budget = SampleBudget{method == "mmlt"          ? 300'000u
                                : method.ends_with("mlt") ? 150'000u
                                                          : 75'000u};
  session.threads = 2;
  return render(Job(maker.description(), find_method(method)), session).film;
}
void expect_exact(const FilmEstimate& film, const FilmEstimate& exact, const FilmEstimate& wrong) {
  const Decision decision = films_agree(film, exact, usual_false_alarm);
  EXPECT_TRUE(passes(decision));
  EXPECT_GE(decision.comparisons, film.value.size() / 2);
  EXPECT_TRUE(rejects(films_agree(film, wrong, usual_false_alarm)));
}

class DirectLight : public ::testing::TestWithParam<const char*> {};
class SpecularLight : public ::testing::TestWithParam<const char*> {};
const auto by_name = [](const auto& info) { return std::string(info.param); };
INSTANTIATE_TEST_SUITE_P(Methods, DirectLight,
                         ::testing::Values("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt"), by_name);
// What a pinhole sees in glass no light path can connect to it.
INSTANTIATE_TEST_SUITE_P(Methods, SpecularLight,
                         ::testing::Values("pt", "bdpt", "mlt", "pssmlt", "mmlt"), by_name);

const SpacePoint origin(0, 0, 0), edge(1, 0, 0.2), other(0.1, 0, -1), up(0, 1, 0);
// The points of a sensor, by its film coordinates.
SpacePoint on_sheet(double u, double v) { return origin + u * edge + v * other; }
SpacePoint on_triangle(double u, double v) {
  return origin + std::sqrt(u) * ((1 - v) * edge + v * other);
}

// Three lamps over a sensor; adds the sensor that `point` describes.
void expect_form_factors(SpaceMaker maker, SpacePoint (*point)(double, double),
                         const char* method) {
  const SpacePoint corner(-0.5, 0.8, -0.8), along(0.6, 0.1, 0), across(0, 0.15, 0.5);
  const std::vector<SpacePoint> sheet{corner, corner + along, corner + along + across,
                                      corner + across};
  const std::vector<SpacePoint> triangle{{1.4, 0.2, -0.8}, {1.4, 0.3, 0.1}, {1.3, 0.9, -0.3}};
  const SpacePoint center(-0.5, 0.4, 0.3);
  const double radius = 0.15;
  const Colour of_sheet{2, 0.5, 1}, of_triangle{1, 3, 0.2}, of_ball{4, 1, 6};

  maker.parallelogram(coordinates(corner), coordinates(along), coordinates(across),
                      {.radiance = quantity(of_sheet)});
  maker.triangle({coordinates(triangle[0]), coordinates(triangle[1]), coordinates(triangle[2])},
                 {.radiance = quantity(of_triangle)});
  maker.sphere(coordinates(center), radius, {.radiance = quantity(of_ball)});

  const auto means = [&](const auto& irradiance) {
    return pixel_means(columns, rows, [&](double u, double v) { return irradiance(point(u, v)); });
  };
  const FilmEstimate exact = exact_film(
      {{means([&](SpacePoint x) { return polygon_irradiance(x, up, sheet); }), of_sheet},
       {means([&](SpacePoint x) { return polygon_irradiance(x, up, triangle); }), of_triangle},
       {means([&](SpacePoint x) { return ball_irradiance(x, up, center, radius); }), of_ball}});
  expect_exact(film_of(maker, method), exact, upside_down(exact));
}

TEST_P(DirectLight, OnAParallelogramIsThatOfTheFormFactors) {
  Maker maker(2);
  maker.parallelogram(coordinates(origin), coordinates(edge), coordinates(other),
                      {.resolution = {columns, rows}});
  expect_form_factors(maker, on_sheet, GetParam());
}
TEST_P(DirectLight, OnATriangleIsThatOfTheFormFactors) {
  Maker maker(2);
  maker.triangle({coordinates(origin), coordinates(edge), coordinates(other)},
                 {.resolution = {columns, rows}});
  expect_form_factors(maker, on_triangle, GetParam());
}

// A lamp that shines up at a mirror; the image shines down.
TEST_P(DirectLight, InAMirrorIsThatOfTheMirrorImage) {
  const SpacePoint corner(-1.7, 0.5, -0.7), along(0, 0.02, 2.4), across(1.09, 0, 0);
  const Colour radiance{3, 2, 4}, reflectance{0.9, 0.5, 0.25};
  Maker maker(3);
  maker.parallelogram({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {.resolution = {columns, rows}});
  maker.parallelogram(coordinates(corner), coordinates(along), coordinates(across),
                      {.radiance = quantity(radiance)});
  maker.parallelogram({-4, 1, -4}, {8, 0, 0}, {0, 0, 8},
                      {.material = maker.mirror(quantity(reflectance))});

  const auto image = [](SpacePoint p) { return SpacePoint(p.x, 2 - p.y, p.z); };
  const std::vector<SpacePoint> lamp{image(corner), image(corner + along),
                                     image(corner + along + across), image(corner + across)};
  const Share share{pixel_means(columns, rows,
                                [&](double u, double v) {
                                  return polygon_irradiance({v, 0, u}, up, lamp);
                                }),
                    {3 * 0.9, 2 * 0.5, 4 * 0.25}};
  Share grey = share;
  grey.colour = {3 * 0.5, 2 * 0.5, 4 * 0.5};
  expect_exact(film_of(maker, GetParam()), exact_film({share}), exact_film({grey}));
}

// A slab of index 4 between two large lamps; the camera is on its one side, with the second lamp
// behind it.  With R the reflectance of an interface, paths of at most 8 vertices carry
//   (1-R)² (1 + R² + R⁴)   of the lamp that is seen through the slab
//   R + (1-R)² (R + R³)    of that which is seen in it
TEST_P(SpecularLight, OfASlabOfGlassHasAllItsReflections) {
  const Colour beyond{2, 1, 1}, behind{1, 1, 3};
  const double index = 4, half_width = std::tan(50 * std::numbers::pi / 180);
  Maker maker(8);
  const std::size_t glass = maker.glass(index);
  maker.parallelogram({-30, -30, -1}, {60, 0, 0}, {0, 60, 0}, {.material = glass});
  maker.parallelogram({-30, -30, -1.2}, {0, 60, 0}, {60, 0, 0}, {.material = glass});
  maker.parallelogram({-30, -30, -2}, {60, 0, 0}, {0, 60, 0}, {.radiance = quantity(beyond)});
  maker.parallelogram({-30, -30, 1}, {0, 60, 0}, {60, 0, 0}, {.radiance = quantity(behind)});
  description::Camera camera;
  camera.target = {0, 0, -1};
  camera.up = {0, 1, 0};
  camera.fov_degrees = 100;
  camera.resolution = {columns, rows};
  maker.camera(camera);

  const double half_height = half_width * rows / columns;
  const auto means = [&](const auto& of_reflectance) {
    return pixel_means(columns, rows, [&](double u, double v) {
      const double cosine = 1 / std::hypot(half_width * (2 * u - 1), half_height * (1 - 2 * v), 1);
      return of_reflectance(fresnel_reflectance(cosine, index));
    });
  };
  const auto passed = [](double r) { return (1 - r) * (1 - r); };
  const FilmEstimate exact = exact_film(
      {{means([&](double r) { return passed(r) * (1 + r * r + r * r * r * r); }), beyond},
       {means([&](double r) { return r + passed(r) * (r + r * r * r); }), behind}});
  const FilmEstimate without_inner_reflections =
      exact_film({{means(passed), beyond}, {means([](double r) { return r; }), behind}});
  expect_exact(film_of(maker, GetParam()), exact, without_inner_reflections);
}

}  // namespace
}  // namespace wander::test

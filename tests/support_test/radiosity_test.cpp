// The radiosity solver against every exact answer that is known, and against conservation laws that
// hold in any scene.
#include "core/exact/radiosity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/description.h"
#include "tests/support/reference_values.h"

namespace wander::test::radiosity_test {

using namespace exact;
namespace {

Wall black(const PlaneSegment& s) { return {.from = s.from, .to = s.to}; }
Wall emitter(const PlaneSegment& s, double radiance) {
  return {.from = s.from, .to = s.to, .radiance = radiance};
}
Wall sensor(const PlaneSegment& s, std::size_t bins) {
  return {.from = s.from, .to = s.to, .bins = bins};
}

// The square cavity, each wall a sensor of one bin.
RadiosityScene cavity(const std::array<double, 4>& reflectance, int max_edges) {
  RadiosityScene scene{.walls = {}, .max_vertices = max_edges + 1};
  for (std::size_t w = 0; w < 4; ++w) {
    const PlaneSegment& line = reference::cavity::walls[w];
    scene.walls.push_back(
        {line.from, line.to, reflectance[w], w == 0 ? reference::cavity::floor_radiance : 0, 1});
  }
  return scene;
}

// A mixed reflectance of 0.8 at most leaves less than 1e-12 beyond so many edges.
constexpr int practically_unlimited = 120;

// The rows are partial sums over the number of edges, vertices - 1, of one solution.
void expect_cavity(const std::array<double, 4>& reflectance,
                   const std::array<reference::cavity::Row, 7>& rows) {
  const RadiositySolution s = solve_radiosity_once(cavity(reflectance, practically_unlimited), {});
  for (const auto& row : rows) {
    const int edges = std::min(row.max_edges, practically_unlimited);
    const std::array<double, 4> exact{row.floor, row.side, row.ceiling, row.side};
    for (std::size_t w = 0; w < 4; ++w) {
      double sum = 0;
      for (int k = 0; k < edges; ++k)
        sum += s.sensors[w].by_vertices[static_cast<std::size_t>(k)][0];
      EXPECT_NEAR(sum, exact[w], reference::cavity::tolerance) << edges << " edges, wall " << w;
    }
  }
  const RadiositySolution short_paths = solve_radiosity_once(cavity(reflectance, 3), {});
  EXPECT_EQ(short_paths.film().by_vertices.size(), 3u);
  EXPECT_NEAR(short_paths.film().mean_irradiance[0], rows[2].floor, reference::cavity::tolerance);
}

TEST(Radiosity, DirectLightOfAParallelEmitterIsReproduced) {
  namespace a = reference::parallel_emitter;
  const RadiositySolution s =
      solve_radiosity({{emitter(a::emitter, a::radiance), sensor(a::sensor, 4)}, 2});
  for (std::size_t b = 0; b < a::film.size(); ++b) {
    EXPECT_NEAR(s.film().mean_irradiance[b], a::film[b], a::tolerance);
    EXPECT_LT(s.film().error[b], 1e-10);
  }
}

TEST(Radiosity, TheBlockerIsReproduced) {
  namespace b = reference::blocker;
  const RadiosityScene scene{
      {emitter(b::emitter, b::radiance), black(b::obstacle), sensor(b::sensor, 8)}, 2};
  const RadiositySolution s = solve_radiosity(scene);
  for (std::size_t i = 0; i < b::film.size(); ++i)
    EXPECT_NEAR(s.film().mean_irradiance[i], b::film[i], b::tolerance);
}

TEST(Radiosity, TheSharedCornerIsReproduced) {
  namespace f = reference::corner;
  for (const f::Bin& bin : f::floor_bins) {
    const PlaneSegment floor{{bin.from, 0}, {bin.to, 0}};
    const RadiositySolution s =
        solve_radiosity({{emitter(f::emitter, f::radiance), sensor(floor, 1)}, 2});
    EXPECT_NEAR(s.film().mean_irradiance[0], bin.mean_irradiance, 1e-11);
  }
}

TEST(Radiosity, TheGreyCavityIsReproducedForEveryLength) {
  expect_cavity(reference::cavity::grey, reference::cavity::grey_irradiance);
}

TEST(Radiosity, TheMixedCavityIsReproducedForEveryLength) {
  expect_cavity(reference::cavity::mixed, reference::cavity::mixed_irradiance);
}

TEST(Radiosity, TheFurnaceOfANonConvexRoomIsAGeometricSeries) {
  const std::vector<PlanePoint> room{{0, 0}, {2, 0}, {2, 0.7}, {0.9, 0.8}, {1, 2}, {0, 2}};
  RadiosityScene scene{.walls = {}, .max_vertices = 6};
  for (std::size_t i = 0; i < room.size(); ++i)
    scene.walls.push_back({room[i], room[(i + 1) % room.size()], 0.8, 1, 4});
  const RadiositySolution s = solve_radiosity_once(scene, {});
  for (const SensorFilm& film : s.sensors)
    for (std::size_t k = 0; k < film.by_vertices.size(); ++k)
      for (const double e : film.by_vertices[k])
        EXPECT_NEAR(e, 2 * std::pow(0.8, static_cast<double>(k)), 1e-9);
}

// Inside a circle the kernel sin(φ/2)/4 is a convolution with eigenvalues λ_n = 1/(1 - 4n²):
// emission cos nφ makes the irradiance 2 λ_n Σ_j (ρ λ_n)^j cos nφ.  Returns the largest deviation
// of a polygon.
double deviation_from_circle(int corners) {
  const auto on_circle = [&](double i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    return PlanePoint{std::cos(angle), std::sin(angle)};
  };
  RadiosityScene scene{.walls = {}, .max_vertices = 6};
  for (int i = 0; i < corners; ++i) {
    const double wave = std::cos(4 * std::numbers::pi * (i + 0.5) / corners);
    scene.walls.push_back({on_circle(i), on_circle(i + 1), 0.5, 1 + wave, 1});
  }
  const RadiositySolution s = solve_radiosity_once(scene, {4, 1, 0x1p-5});
  double largest = 0;
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const double wave = scene.walls[w].radiance - 1, eigenvalue = 1 / (1 - 4.0 * 2 * 2);
    double circle = 0;
    for (int j = 0; j < 5; ++j)
      circle += 2 * (std::pow(0.5, j) + wave * eigenvalue * std::pow(0.5 * eigenvalue, j));
    largest = std::max(largest, std::abs(s.sensors[w].mean_irradiance[0] - circle));
  }
  return largest;
}

TEST(Radiosity, PolygonsConvergeToTheCircleWithTheSquareOfTheirCorners) {
  const double coarse = deviation_from_circle(12), fine = deviation_from_circle(24);
  EXPECT_LT(fine, 3e-3);
  EXPECT_NEAR(coarse / fine, 4, 0.3);
}

// A closed room, in it two free walls that cross and one that stands on another: what is emitted,
// 2 Le per metre, is absorbed.
TEST(Radiosity, EnergyIsConservedAroundFreeWallsThatCrossAndTouch) {
  const auto wall = [](PlanePoint from, PlanePoint to, double rho, double radiance) {
    return Wall{from, to, rho, radiance, 1};
  };
  RadiosityScene scene{
      .walls = {wall({0, 0}, {1.5, 0}, 0.5, 0), wall({1.5, 0}, {1.5, 1}, 0.3, 1),
                wall({1.5, 1}, {0, 1.2}, 0.6, 0), wall({0, 1.2}, {0, 0}, 0.4, 0),
                wall({0.4, 0.3}, {0.9, 0.8}, 0.7, 2), wall({0.9, 0.5}, {0.5, 0.9}, 0.5, 0),
                wall({1.1, 0.0}, {1.2, 0.4}, 0.6, 0)},
      .max_vertices = 100};
  const RadiositySolution s = solve_radiosity_once(scene, {});
  double emitted = 0, absorbed = 0;
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const Wall& x = scene.walls[w];
    const double size = length(x.to - x.from);
    emitted += 2 * x.radiance * size;
    absorbed += (1 - x.reflectance) * size * (s.wall_irradiance[w][0] + s.wall_irradiance[w][1]);
  }
  EXPECT_NEAR(absorbed / emitted, 1, 1e-8);
}

TEST(Radiosity, SensorAndBinsFollowTheDirectionOfTheWall) {
  const PlaneSegment lamp{{0.5, 1}, {0, 1}}, floor{{0, 0}, {2, 0}}, upside_down{{2, 0}, {0, 0}};
  const auto forward = solve_radiosity({{emitter(lamp, 1), sensor(floor, 4)}, 2}).film();
  EXPECT_GT(forward.mean_irradiance[0], 2 * forward.mean_irradiance[3]);
  const auto behind = solve_radiosity({{emitter(lamp, 1), sensor(upside_down, 4)}, 2}).film();
  for (const double e : behind.mean_irradiance) EXPECT_EQ(e, 0);
}

description::Scene described() {
  using namespace description;
  using description::Segment, description::Shape;
  Scene scene;
  scene.max_vertices = 5;
  scene.materials = {Material{"plaster", Diffuse{Quantity{{0.5, 0.5, 0.5}, false}}},
                     Material{"silver", Mirror{Quantity{{1, 1, 1}, false}}}};
  Shape room;
  room.kind = Polyline{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true};
  room.material = 0;
  Shape lamp;
  lamp.kind = description::Segment{{0.6, 0.9}, {0.4, 0.9}};
  lamp.light = Light{Quantity{{5, 5, 5}, false}};
  Shape film;
  film.kind = description::Segment{{0.2, 0.1}, {0.8, 0.1}};
  film.sensor = Sensor{{6}};
  scene.shapes = {room, lamp, film};
  return scene;
}

TEST(Radiosity, ASceneDescriptionBecomesWalls) {
  const RadiosityScene scene = radiosity_scene(described());
  ASSERT_EQ(scene.walls.size(), 6u);
  EXPECT_EQ(scene.max_vertices, 5);
  EXPECT_EQ(scene.walls[3].to.x, 0);  // the polyline closes
  EXPECT_EQ(scene.walls[3].to.y, 0);
  EXPECT_EQ(scene.walls[3].reflectance, 0.5);
  EXPECT_EQ(scene.walls[4].radiance, 5);
  EXPECT_EQ(scene.walls[4].reflectance, 0);
  EXPECT_EQ(scene.walls[5].bins, 6u);
  const SensorFilm film = solve_radiosity(scene).film();
  EXPECT_EQ(film.by_vertices.size(), 4u);
  EXPECT_NEAR(film.mean_irradiance[0] / film.mean_irradiance[5], 1, 1e-7);  // symmetric
}

TEST(Radiosity, WhatItCannotSolveIsRefused) {
  description::Scene mirror = described(), circle = described(), camera = described(),
                     space = described(), coloured = described();
  mirror.shapes[0].material = 1;
  circle.shapes[1].kind = description::Circle{{0.5, 0.5}, 0.1};
  camera.camera = description::Camera{};
  space.dimension = 3;
  coloured.shapes[1].light->radiance.coloured = true;
  for (const auto& scene : {mirror, circle, camera, space, coloured})
    EXPECT_THROW(radiosity_scene(scene), std::invalid_argument);
  const PlaneSegment line{{0, 0}, {1, 0}};
  EXPECT_THROW(solve_radiosity({{black(line)}, 2}), std::invalid_argument);
  EXPECT_THROW(solve_radiosity({{sensor(line, 1)}, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace wander::test::radiosity_test

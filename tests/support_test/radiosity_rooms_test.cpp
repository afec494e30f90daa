// The radiosity solver under occlusion: two rooms joined by a slit.  Its claims about its own
// error, reciprocity, and an independent brute-force solver, whose wrong twins must disagree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/exact/radiosity.h"

namespace wander::test::radiosity_rooms_test {

using namespace exact;
namespace {

// Two rooms of 1 × 1, a lamp in the left one, a sensor in the right one.
RadiosityScene rooms(double slit) {
  const double lower = 0.5, upper = lower + slit;
  const auto wall = [](PlanePoint from, PlanePoint to) { return Wall{from, to, 0.75, 0, 0}; };
  RadiosityScene scene{
      .walls = {wall({0, 0}, {2, 0}), wall({2, 0}, {2, 1}), wall({2, 1}, {0, 1}),
                wall({0, 1}, {0, 0}), wall({1, 0}, {1, lower}), wall({1, upper}, {1, 1})},
      .max_vertices = 8};
  scene.walls.push_back({{0.5, 0.98}, {0.3, 0.98}, 0, 5, 0});
  scene.walls.push_back({{1.2, 0.01}, {1.9, 0.01}, 0, 0, 100});
  return scene;
}

TEST(RadiosityRooms, TheFilmBehindASlitIsExactTo1e6AndTheErrorIsBounded) {
  for (const double slit : {0.05, 0.002}) {
    const SensorFilm film = solve_radiosity(rooms(slit)).film();
    const RadiosityMesh finer{.nodes = 6, .grading = 0.25, .smallest = 0x1p-14};
    const SensorFilm exact = solve_radiosity_once(rooms(slit), finer).film();
    for (std::size_t b = 0; b < 100; ++b) {
      const double value = exact.mean_irradiance[b];
      EXPECT_GT(value, 0);
      EXPECT_NEAR(film.mean_irradiance[b] / value, 1, 1e-6) << slit << ' ' << b;
      EXPECT_LT(film.error[b], 1e-5 * value) << slit << ' ' << b;
      // Two meshes may agree by accident below their common accuracy, hence the second term.
      EXPECT_LE(std::abs(film.mean_irradiance[b] - value), film.error[b] + 1e-7 * value) << b;
    }
  }
}

// Light and sensor exchanged: ∫∫ over both is the same, for every number of vertices.
TEST(RadiosityRooms, LightAndSensorMayBeExchanged) {
  RadiosityScene there = rooms(0.05), back = rooms(0.05);
  there.walls[6].radiance = 1;
  there.walls[7].bins = 1;
  std::swap(back.walls[6], back.walls[7]);
  back.walls[6] = {back.walls[6].from, back.walls[6].to, 0, 1, 0};
  back.walls[7] = {back.walls[7].from, back.walls[7].to, 0, 0, 1};
  const SensorFilm a = solve_radiosity(there).film(), b = solve_radiosity(back).film();
  const double sensor = 0.7, lamp = 0.2;  // lengths
  for (std::size_t k = 0; k < a.by_vertices.size(); ++k) {
    const double one = a.by_vertices[k][0] * sensor, other = b.by_vertices[k][0] * lamp;
    EXPECT_NEAR(one, other, 1e-6 * one) << k + 2;
  }
}

// --- An independent solver: midpoint patches on both sides, shadow rays, one matrix per kernel.
// ---

struct Patch {
  PlanePoint position, normal;
  double size, reflectance, radiance;
  std::size_t wall;
};

enum class Kernel { right, square_of_distance, one_cosine, no_occlusion };

bool hides(const Wall& wall, PlanePoint a, PlanePoint b) {
  const PlanePoint d = b - a, e = wall.to - wall.from, o = wall.from - a;
  const double t = cross(o, e) / cross(d, e), s = cross(o, d) / cross(d, e);
  return t > 1e-9 && t < 1 - 1e-9 && s >= 0 && s <= 1;
}

double kernel(const RadiosityScene& scene, const Patch& x, const Patch& y, Kernel kind) {
  const PlanePoint d = y.position - x.position;
  const double r = length(d), cos_x = dot(x.normal, d) / r, cos_y = -dot(y.normal, d) / r;
  if (!(cos_x > 0 && cos_y > 0)) return 0;
  if (kind != Kernel::no_occlusion)
    for (const Wall& wall : scene.walls)
      if (hides(wall, x.position, y.position)) return 0;
  if (kind == Kernel::square_of_distance) return cos_x * cos_y / (r * r);
  return kind == Kernel::one_cosine ? cos_y / r : cos_x * cos_y / r;
}

std::vector<Patch> patches_of(const RadiosityScene& scene, double size) {
  std::vector<Patch> patches;
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const Wall& wall = scene.walls[w];
    const PlaneSegment line{wall.from, wall.to};
    const int n = static_cast<int>(std::ceil(length(line) / size));
    for (const Side side : {Side::front, Side::back})
      for (int i = 0; i < n; ++i)
        patches.push_back({line.at((i + 0.5) / n), sign_of(side) * normal(line), length(line) / n,
                           wall.reflectance, side == Side::front ? wall.radiance : 0, w});
  }
  return patches;
}

// The mean irradiance on the front of the last wall, from paths of each number of vertices.
std::vector<double> brute_force(const RadiosityScene& scene, double size, Kernel kind) {
  const std::vector<Patch> patches = patches_of(scene, size);
  const std::size_t n = patches.size();
  std::vector<double> matrix(n * n), radiance(n);
  for (std::size_t i = 0; i < n; ++i) {
    radiance[i] = patches[i].radiance;
    for (std::size_t j = 0; j < n; ++j)
      matrix[i * n + j] = kernel(scene, patches[i], patches[j], kind) * patches[j].size;
  }
  const Wall& last = scene.walls.back();
  std::vector<double> means;
  for (int vertices = 2; vertices <= scene.max_vertices; ++vertices) {
    std::vector<double> next(n);
    double flux = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double irradiance = 0;
      for (std::size_t j = 0; j < n; ++j) irradiance += matrix[i * n + j] * radiance[j];
      next[i] = 0.5 * patches[i].reflectance * irradiance;
      const bool on_film = patches[i].wall + 1 == scene.walls.size() &&
                           dot(patches[i].normal, normal({last.from, last.to})) > 0;
      if (on_film) flux += irradiance * patches[i].size;
    }
    means.push_back(flux / length(last.to - last.from));
    radiance = next;
  }
  return means;
}

// No walls meet, so that midpoints do well; two reflectors and a blocker, direct light in part.
RadiosityScene open_scene() {
  return {.walls = {{{1.1, 0.1}, {1.2, 1}, 0.8, 0, 0},
                    {{-1, 1}, {-1.1, 0}, 0.6, 0.3, 0},
                    {{-0.5, 0.6}, {0.2, 0.5}, 0.7, 0, 0},
                    {{0.3, 1.3}, {-0.6, 1.2}, 0, 1, 0},
                    {{-0.7, -0.1}, {0.7, -0.1}, 0, 0, 1}},
          .max_vertices = 5};
}

double largest_deviation(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] / b[i] - 1));
  return largest;
}

TEST(RadiosityRooms, BruteForceAgreesAndItsWrongTwinsDoNot) {
  const RadiosityScene scene = open_scene();
  std::vector<double> exact;
  for (const auto& order : solve_radiosity(scene).film().by_vertices) exact.push_back(order[0]);
  constexpr double size = 0.012, agreement = 0.01;
  EXPECT_LT(largest_deviation(brute_force(scene, size, Kernel::right), exact), agreement);
  for (const Kernel wrong : {Kernel::square_of_distance, Kernel::one_cosine, Kernel::no_occlusion})
    EXPECT_GT(largest_deviation(brute_force(scene, size, wrong), exact), 5 * agreement);
}

TEST(RadiosityRooms, AMissingOccluderIsSeen) {
  RadiosityScene without = open_scene();
  without.walls.erase(without.walls.begin() + 2);
  const double with = solve_radiosity(open_scene()).film().mean_irradiance[0];
  EXPECT_GT(solve_radiosity(without).film().mean_irradiance[0], 1.05 * with);
}

}  // namespace
}  // namespace wander::test::radiosity_rooms_test

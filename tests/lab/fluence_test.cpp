// The fluence rate of a scene: exact where it is known, in rooms at equilibrium and in the open.
// False-alarm rate 1e-9 per picture.
#include "lab/fluence.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "tests/support/core_scenes.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"

namespace wander::test {
namespace {

constexpr double radiance = 1.5, pi = std::numbers::pi;

Rendering fluence(const SceneMaker& maker, const PlaneGrid& grid, std::uint64_t samples,
                  int threads = 1) {
  Session session;
  session.budget = SampleBudget{samples};
  session.seed = 7;
  session.threads = threads;
  return estimate_fluence(maker.description(), grid, session);
}

using Exact = std::function<std::optional<double>(std::size_t cell)>;

// What is Student's t becomes normal.
double as_z(double t, double degrees_of_freedom) {
  const double tail = boost::math::cdf(boost::math::students_t(degrees_of_freedom), -std::abs(t));
  return tail > 0 ? -boost::math::quantile(boost::math::normal(), tail) : INFINITY;
}

// Cells whose exact mean is known; errors are the spread of batches.
Decision cells_test(const Rendering& picture, const PlaneGrid& grid, const Exact& exact) {
  std::vector<Compared> all;
  for (std::size_t cell = 0; cell < grid.size(); ++cell)
    if (const auto expected = exact(cell)) {
      const double error = picture.film.standard_error[cell];
      all.push_back(
          {as_z((picture.film.value[cell] - *expected) / error, picture.film.degrees_of_freedom),
           error, *expected});
    }
  return largest_z_test(all, usual_false_alarm);
}

const std::vector<PlanePoint> corners{{0, 0}, {2, 0}, {2, 1}, {0, 1}};

// One wall is the sensor, too.
void emitting_room(SceneMaker& maker, Role wall) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    maker.segment(corners[i], corners[(i + 1) % corners.size()],
                  {wall.material, wall.radiance, i == 0 ? 3 : 0});
}

// All walls emit L and reflect ρ: light of each length has a radiance of its own, everywhere.
TEST(Fluence, OfEachLengthInAFurnaceIsTwoPiTimesItsRadiance) {
  constexpr double rho = 0.7;
  constexpr int longest = 5;
  SceneMaker maker(longest);
  emitting_room(maker, {maker.diffuse(rho), radiance});
  const PlaneGrid grid({0, 0}, {2, 1}, 10);
  const Rendering picture = fluence(maker, grid, 200000);

  double sum = 0;
  for (int n = 2; n <= longest; ++n) sum += 2 * pi * radiance * std::pow(rho, n - 2);
  EXPECT_TRUE(passes(cells_test(picture, grid, [&](std::size_t) { return sum; })));
  EXPECT_TRUE(rejects(cells_test(picture, grid, [&](std::size_t) { return sum * 1.02; })));
  for (int n = 2; n <= longest; ++n) {
    double mean = 0;
    for (const double value : picture.film.by_length.at(n))
      mean += value / static_cast<double>(grid.size());
    // Without an error bar of its own: within half a percent, which 2·10⁵ walks hold by far.
    const double exact = 2 * pi * radiance * std::pow(rho, n - 2);
    EXPECT_NEAR(mean, exact, 0.005 * exact * n) << n;
  }
}

// Black walls that emit L: equilibrium, also in glass, where the radiance is n times as large.
// Beyond radius / n from the middle total reflection keeps some directions dark.
TEST(Fluence, InGlassAtEquilibriumIsGreaterByTheIndex) {
  constexpr double index = 1.5, radius = 0.4;
  const PlanePoint middle{1, 0.5};
  SceneMaker maker(40);
  emitting_room(maker, {{}, radiance});
  maker.circle(middle, radius, {maker.glass(index)});
  const PlaneGrid grid({0, 0}, {2, 1}, 32);
  const Rendering picture = fluence(maker, grid, 200000);

  const auto expected = [&](double inside) {
    return [&, inside](std::size_t cell) -> std::optional<double> {
      const double distance = glm::distance(grid.center(cell), Vec<2, double>(1, 0.5));
      if (distance < radius / index - glm::length(grid.cell())) return 2 * pi * radiance * inside;
      if (distance > radius + glm::length(grid.cell())) return 2 * pi * radiance;
      return std::nullopt;
    };
  };
  EXPECT_TRUE(passes(cells_test(picture, grid, expected(index))));
  EXPECT_TRUE(rejects(cells_test(picture, grid, expected(1))));
  EXPECT_TRUE(rejects(cells_test(picture, grid, expected(index * index))));
}

// L times the angle under which a light is seen; the light escapes through the edge of the picture.
TEST(Fluence, InTheOpenIsRadianceTimesTheAngleOfTheLight) {
  SceneMaker maker(2);
  maker.segment({-0.5, 0}, {0.5, 0}, {{}, radiance});
  maker.segment({3, 3}, {3.1, 3}, {{}, 0, 1});
  const PlaneGrid grid({-1, 0.1}, {1, 1.1}, 8);
  const Rendering picture = fluence(maker, grid, 200000);

  const auto cell_mean = [&](std::size_t cell, const auto& at) {
    const PlaneGrid::Point c = grid.center(cell), half = grid.cell() / 2.;
    const Box<2> box{{c.x - half.x, c.y - half.y}, {c.x + half.x, c.y + half.y}};
    return gauss_integral(at, box, gauss_rule(12)) / box.measure();
  };
  const auto sine_left = [](const auto& p) { return (p[0] + 0.5) / std::hypot(p[0] + 0.5, p[1]); };
  const auto sine_right = [](const auto& p) { return (p[0] - 0.5) / std::hypot(p[0] - 0.5, p[1]); };
  const auto angle = [&](std::size_t cell) {
    return cell_mean(cell, [&](const std::array<double, 2>& p) {
      return radiance * (std::asin(sine_left(p)) - std::asin(sine_right(p)));
    });
  };
  // The irradiance on a line across is what fluence is not.
  const auto irradiance = [&](std::size_t cell) {
    return cell_mean(cell, [&](const std::array<double, 2>& p) {
      return radiance * (sine_left(p) - sine_right(p));
    });
  };
  EXPECT_TRUE(passes(cells_test(picture, grid, angle)));
  EXPECT_TRUE(rejects(cells_test(picture, grid, irradiance)));
}

// Independent walks to the light from a small lamp would leave 1 / √(walks in a cell) in each.
TEST(Fluence, OfALampHasNoStreaks) {
  SceneMaker maker(2);
  maker.segment({0.001, 1}, {-0.001, 1}, {{}, radiance});
  maker.segment({3, 3}, {3.1, 3}, {{}, 0, 1});
  const PlaneGrid grid({-1, 0}, {1, 0.5}, 64);
  constexpr std::uint64_t walks = 200000;
  const Rendering picture = fluence(maker, grid, walks);
  double error = 0, independent = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const PlaneGrid::Point to = grid.center(cell) - PlaneGrid::Point(0, 1);
    const double distance = glm::length(to), cosine = -to.y / distance;
    const double exact = radiance * 0.002 * cosine / distance;  // of a lamp that is a point
    error += std::pow(picture.film.value[cell] / exact - 1, 2);
    // A share cos/2 dθ of the walks, through a cell that is seen under its width over distance.
    independent += 1 / (static_cast<double>(walks) * cosine / 2 * grid.cell().x / distance);
  }
  EXPECT_LT(std::sqrt(error), 0.25 * std::sqrt(independent));
}

TEST(Fluence, IsTheSameForAnyNumberOfThreads) {
  SceneMaker maker(6);
  maker.room(corners, {maker.diffuse(0.5), radiance});
  maker.circle({1, 0.5}, 0.2, {maker.mirror(0.9), 0, 1});
  const PlaneGrid grid({0, 0}, {2, 1}, 16);
  const Rendering one = fluence(maker, grid, 20000, 1), four = fluence(maker, grid, 20000, 4);
  EXPECT_EQ(one.film.value, four.film.value);
  EXPECT_EQ(one.film.standard_error, four.film.standard_error);
  EXPECT_EQ(one.samples, 20000u);
  EXPECT_TRUE(one.complete);
  EXPECT_EQ(one.film.shape, (std::vector<int>{8, 16}));
}

}  // namespace
}  // namespace wander::test

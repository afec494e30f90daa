// The density that the large step claims, against the histogram of what it proposes: χ² over cells
// of the new vertices.  In the plane a path of a few diffuse vertices is a few numbers, so the
// claimed density can be integrated over a cell.
//
// Proposals that fail are one more cell, with what is missing to one: a probability that was left
// out shows, and so does what would cancel in an acceptance ratio.  False alarms: 1e-9 per χ².
#include <gtest/gtest.h>

#include "mutations/primary_large.h"
#include "tests/support/expect.h"
#include "tests/support/quadrature.h"
#include "tests/support/smooth_room.h"

namespace wander::test {
namespace {

using W = Flatland;
using Flat = Transport<W>;

// As claimed by the large step, wherever it comes from: it is read off the way back.
double large_density(const Flat& space, const PrimaryLarge& large, const Path<W>& z) {
  Rng random(1, Purpose::test, 20);
  Path<W> y(space.max_vertices());
  for (;;) {
    const Proposed proposed = large.propose(space, z, y, random);
    if (const Proposal* p = std::get_if<Proposal>(&proposed)) return p->reverse.value();
  }
}

TEST_F(SmoothRoom, TheLargeStepProposesTwoVerticesWithTheDensityThatItClaims) {
  constexpr std::size_t cells = 8;
  const PrimaryLarge large(space_.max_vertices());
  const double area = length(light_wall) * length(sensor_wall);
  std::vector<double> observed(cells * cells + 1), expected(observed.size());
  const auto cell = [](double u) { return static_cast<std::size_t>(u * cells); };

  const Path<W> x = path({{light_wall, 0.4}, {sensor_wall, 0.3}});
  Path<W> y(space_.max_vertices());
  Rng random(2, Purpose::test, 21);
  constexpr int proposals = 300'000;
  for (int i = 0; i < proposals; ++i) {
    const Proposed proposed = large.propose(space_, x, y, random);
    const bool counts = std::holds_alternative<Proposal>(proposed) && y.size() == 2;
    ++observed[counts ? cell(position(y[0])) * cells + cell(position(y[1])) : cells * cells];
  }
  Path<W> z = x;
  const auto density = [&](const std::array<double, 2>& u) {
    put(z, 0, light_wall, u[0]);
    put(z, 1, sensor_wall, u[1]);
    if (!complete(z)) return 0.0;
    weigh(space_, z);
    return area * large_density(space_, large, z);
  };
  double total = 0;
  for (std::size_t i = 0; i < cells * cells; ++i) {
    const double a = static_cast<double>(i / cells) / cells,
                 b = static_cast<double>(i % cells) / cells;
    const Box<2> box{{a, b}, {a + 1.0 / cells, b + 1.0 / cells}};
    total += expected[i] = proposals * gauss_integral<2>(density, box, gauss_rule(5));
  }
  expected.back() = proposals - total;
  EXPECT_TRUE(passes(chi_square_test(observed, expected, usual_false_alarm)));
}

TEST_F(SmoothRoom, TheLargeStepProposesThreeVerticesWithTheDensityThatItClaims) {
  constexpr std::size_t cells = 3;  // of light, wall and sensor
  constexpr std::size_t per_wall = cells * cells * cells, count = per_wall * wall_count;
  const PrimaryLarge large(space_.max_vertices());
  std::vector<double> observed(count + 1), expected(observed.size());
  const auto cell = [](double u) { return static_cast<std::size_t>(u * cells); };

  const Path<W> x = path({{light_wall, 0.4}, {sensor_wall, 0.3}});
  Path<W> y(space_.max_vertices());
  Rng random(3, Purpose::test, 22);
  constexpr int proposals = 300'000;
  for (int i = 0; i < proposals; ++i) {
    const Proposed proposed = large.propose(space_, x, y, random);
    const bool counts = std::holds_alternative<Proposal>(proposed) && y.size() == 3;
    const auto wall = static_cast<std::size_t>(counts ? y[1].place.shape : 0);
    ++observed[counts ? wall * per_wall +
                            (cell(position(y[0])) * cells + cell(position(y[1]))) * cells +
                            cell(position(y[2]))
                      : count];
  }
  Path<W> z(space_.max_vertices());
  z.resize(3);
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto wall = static_cast<ShapeId>(i / per_wall);
    const double area = length(light_wall) * length(wall) * length(sensor_wall);
    const auto density = [&](const std::array<double, 3>& u) {
      put(z, 0, light_wall, u[0]);
      put(z, 1, wall, u[1]);
      put(z, 2, sensor_wall, u[2]);
      if (!complete(z)) return 0.0;
      weigh(space_, z);
      return area * large_density(space_, large, z);
    };
    Box<3> box;
    for (const auto& [axis, k] : {std::pair{0, i / 9 % 3}, {1, i / 3 % 3}, {2, i % 3}}) {
      const auto d = static_cast<std::size_t>(axis);
      box.low[d] = static_cast<double>(k) / cells;
      box.high[d] = static_cast<double>(k + 1) / cells;
    }
    total += expected[i] = proposals * gauss_integral<3>(density, box, gauss_rule(4));
  }
  expected.back() = proposals - total;
  EXPECT_TRUE(passes(chi_square_test(observed, expected, usual_false_alarm)));
}

}  // namespace
}  // namespace wander::test

// Lines through the cells of a grid.
#include "core/geometry/plane_grid.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/rng.h"

namespace wander::test::plane_grid_test {
namespace {

using Point = PlaneGrid::Point;

TEST(PlaneGrid, HasNearlySquareCellsNumberedFromTheTopLeft) {
  const PlaneGrid grid({1, 2}, {4, 3}, 6);
  EXPECT_EQ(grid.columns(), 6);
  EXPECT_EQ(grid.rows(), 2);
  EXPECT_EQ(grid.center(0), Point(1.25, 2.75));
  EXPECT_EQ(grid.center(grid.size() - 1), Point(3.75, 2.25));
  EXPECT_EQ(PlaneGrid({0, 0}, {1, 0.001}, 10).rows(), 1);
}

// The length within each cell against the midpoints of many short pieces of the line.
TEST(PlaneGrid, SharesALineAmongTheCellsThatItCrosses) {
  const PlaneGrid grid({-1, -0.5}, {2, 1}, 7);
  Rng rng(1, Purpose::test, 0);
  const auto coordinate = [&] { return -2 + 5 * rng.uniform(); };
  constexpr int pieces = 4000;
  for (int trial = 0; trial < 200; ++trial) {
    Point a, b;
    a.x = coordinate();
    a.y = coordinate();
    b.x = trial % 10 == 0 ? a.x : coordinate();
    b.y = trial % 10 == 1 ? a.y : coordinate();
    std::vector<double> crossed(grid.size()), expected(grid.size());
    grid.cross(a, b, [&](std::size_t cell, double length) {
      EXPECT_GT(length, 0);
      crossed.at(cell) += length;
    });
    for (int k = 0; k < pieces; ++k) {
      const Point p = a + (b - a) * ((k + 0.5) / pieces);
      const Point in_cells = (p - grid.low()) / grid.cell();
      if (!(in_cells.x >= 0 && in_cells.x < grid.columns() && in_cells.y >= 0 &&
            in_cells.y < grid.rows()))
        continue;
      const int row = grid.rows() - 1 - static_cast<int>(in_cells.y);
      expected.at(static_cast<std::size_t>(row * grid.columns() + static_cast<int>(in_cells.x))) +=
          glm::distance(a, b) / pieces;
    }
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
      EXPECT_NEAR(crossed[cell], expected[cell], 2.01 * glm::distance(a, b) / pieces);
  }
}

TEST(PlaneGrid, ALineOutsideOrOfNoLengthCrossesNothing) {
  const PlaneGrid grid({0, 0}, {1, 1}, 4);
  int visits = 0;
  const auto count = [&](std::size_t, double) { ++visits; };
  grid.cross({-1, -1}, {-1, 2}, count);
  grid.cross({1.5, -1}, {3, 2}, count);
  grid.cross({0.5, 0.5}, {0.5, 0.5}, count);
  EXPECT_EQ(visits, 0);
}

}  // namespace
}  // namespace wander::test::plane_grid_test

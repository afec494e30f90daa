// The shape of docs/extending.md: rays meet it where its equation says, points on it are spread by
// arc length, and it does what a parabola is for.
#include "docs/examples/parabola.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/shape.h"
#include "tests/support/generator.h"
#include "tests/support/quadrature.h"

namespace wander::test {
namespace {

using Curve = Parabola<Flatland>;
using Point = Flatland::Point;
constexpr double none = std::numeric_limits<double>::infinity();

// y = x²/4 from x = -3 to 3, as it is, and turned and moved.
const Curve upright({0, 0}, {0, 1}, 6), oblique({1, -2}, {1.6, -1.2}, 2.5);

// Of a curve with its vertex and focus.
double off_by(Point vertex, Point focus, Point p) {
  const Point axis = glm::normalize(focus - vertex);
  const double from_directrix = glm::dot(p - vertex, axis) + glm::length(focus - vertex);
  return std::abs(glm::length(p - focus) - from_directrix);
}

TEST(OwnShape, HasPointsAsFarFromTheFocusAsFromTheDirectrix) {
  for (double u = 0; u < 1; u += 1.0 / 64) {
    EXPECT_LT(off_by({0, 0}, {0, 1}, upright.sample({u}).position), 1e-14);
    EXPECT_LT(off_by({1, -2}, {1.6, -1.2}, oblique.sample({u}).position), 1e-14);
  }
}

TEST(OwnShape, RunsFromLeftToRightWithItsNormalOnTheLeft) {
  EXPECT_NEAR(upright.sample({0}).position.x, -3, 1e-14);
  EXPECT_NEAR(upright.sample({0.5}).position.x, 0, 1e-14);
  EXPECT_EQ(upright.sample({0.5}).normal, Point(0, 1));
  for (const double u : {0.1, 0.4, 0.9}) {
    const Point along = oblique.sample({u + 1e-6}).position - oblique.sample({u}).position;
    EXPECT_LT(glm::distance(left_of(glm::normalize(along)), oblique.sample({u}).normal), 1e-5);
  }
}

TEST(OwnShape, SpreadsItsPointsByArcLength) {
  // Of y = x²/4.
  const auto from_vertex = [](double x) {
    return integral([](double at) { return std::sqrt(1 + at * at / 4); }, 0., x);
  };
  const double length = 2 * from_vertex(3);
  EXPECT_NEAR(upright.measure(), length, 1e-12);
  for (const double u : {0.5, 0.55, 0.7, 0.9, 0.999})
    EXPECT_NEAR(from_vertex(upright.sample({u}).position.x), (u - 0.5) * length, 1e-12) << u;
  // Points spread evenly across the axis would not be.
  EXPECT_GT(std::abs(from_vertex(6 * 0.9 - 3) - (0.9 - 0.5) * length), 0.1);
}

TEST(OwnShape, FindsTheParameterOfItsPoints) {
  Generator g(1);
  for (const Curve& curve :
       {upright, oblique, Curve({0, 0}, {0, 1e-4}, 6), Curve({0, 0}, {0, 1e4}, 6)})
    for (int i = 0; i < 1000; ++i) {
      const double u = g.uniform();
      EXPECT_NEAR(curve.parameter(curve.sample({u}).position)[0], u, 1e-12);
    }
}

TEST(OwnShape, IsMetWhereItIsAndNowhereElse) {
  EXPECT_NEAR(upright.intersect({{1, 5}, {0, -1}}, 0), 4.75, 1e-14);  // along the axis
  EXPECT_NEAR(upright.intersect({{-3, 1}, {1, 0}}, 0), 1, 1e-14);     // from outside: the near root
  EXPECT_NEAR(upright.intersect({{0, 1}, {2, 0}}, 0), 1, 1e-14);      // from inside
  EXPECT_EQ(upright.intersect({{3.001, 5}, {0, -1}}, 0), none);       // beside its end
  EXPECT_EQ(upright.intersect({{0, 1}, {0, 1}}, 0), none);            // out of the open side
  EXPECT_EQ(upright.intersect({{-1, -1}, {1, 0}}, 0), none);          // below
  EXPECT_EQ(upright.intersect({{1, 5}, {0, -1}, -1, -1, 4.7}, 0), none);  // beyond the limit
}

// From any point to a point on it, and on from there: one root is known, and no ray meets the curve
// where it touches it.
TEST(OwnShape, IsNotMetWhereARayTouchesIt) {
  Generator g(2);
  for (const Curve& curve : {upright, oblique})
    for (int i = 0; i < 10'000; ++i) {
      const Point on = curve.sample({g.uniform()}).position;
      const Point other = curve.sample({g.uniform()}).position;
      EXPECT_EQ(curve.intersect({on, other - on, 0, 0}, 0), none);
      // To another point of the curve, which is not told to lie on it.
      const Ray<Flatland> chord{on, other - on, 0};
      ASSERT_NEAR(curve.intersect(chord, 0), 1, 1e-6);
      // From beyond it, through it: the other crossing is found, and no other.
      const Point origin = on + 0.5 * (on - other);
      ASSERT_NEAR(curve.intersect({origin, other - origin, no_shape, 0}, 0), 1. / 3, 1e-6);
    }
}

TEST(OwnShape, LiesWithinItsBounds) {
  for (const Curve& curve : {upright, oblique}) {
    const auto box = curve.bounds();
    for (double u = 0; u < 1; u += 1.0 / 256) {
      const Point p = curve.sample({u}).position;
      EXPECT_TRUE(p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y);
    }
  }
}

TEST(OwnShape, GathersInItsFocusWhatArrivesAlongItsAxis) {
  const Point axis(0.6, 0.8), focus(1.6, -1.2);
  for (const double u : {0.05, 0.3, 0.5, 0.8}) {
    const auto hit = oblique.sample({u});
    const Point reflected = -axis + 2 * glm::dot(axis, hit.normal) * hit.normal;
    EXPECT_LT(std::abs(cross(reflected, focus - hit.position)), 1e-14);
  }
}

TEST(OwnShape, DescribesItself) {
  const description::Parabola described{{0, 0, 0}, {0, 1, 0}, 6};
  EXPECT_EQ(described.length(), upright.measure());
  EXPECT_TRUE(described.flaws().empty());
  EXPECT_STREQ(description::Parabola{.width = 1}.flaws().at(0).key, "focus");
  const description::Outline outline = described.outline();
  double length = 0;
  for (const auto& stroke : outline) length += std::get<description::Segment>(stroke).length();
  EXPECT_NEAR(length, described.length(), 1e-3);
  int added = 0;
  add_curves<FlatlandSingle>(described, [&](const Parabola<FlatlandSingle>& curve) {
    EXPECT_EQ(curve.measure(), upright.measure());
    ++added;
  });
  EXPECT_EQ(added, 1);
}

}  // namespace
}  // namespace wander::test

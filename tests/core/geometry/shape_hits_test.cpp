// Where rays meet the shapes of both worlds: at their ends, along them, from a point on them, and
// grazing.  None of it needs an epsilon.
#include "core/geometry/shape.h"

#include <gtest/gtest.h>

#include "tests/core/directions.h"

namespace wander::test {
namespace {

using Line = Segment<Flatland>;
using Curve = Arc<Flatland>;
using Ball = Sphere<Spaceland>;
using Sheet = Parallelogram<Spaceland>;
using Point2 = Flatland::Point;
using Point3 = Spaceland::Point;
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double turn = 2 * std::numbers::pi;

Curve circle(Point2 center, double radius) {
  return {center, radius, 0, turn, Curve::Facing::outward};
}

TEST(Segments, HaveTheNormalOnTheLeftOfTheirDirection) {
  const Line line({1, 1}, {3, 1});
  EXPECT_EQ(line.sample({0.25}).normal, Point2(0, 1));
  EXPECT_EQ(line.sample({0.25}).position, Point2(1.5, 1));
  EXPECT_EQ(line.measure(), 2);
}

TEST(Segments, AreHitFromBothSidesBetweenTheirEnds) {
  const Line line({-1, 2}, {1, 2});
  EXPECT_EQ(line.intersect({{0, 0}, {0, 1}}, 0), 2);
  EXPECT_EQ(line.intersect({{0, 3}, {0, -0.5}}, 0), 2);
  EXPECT_EQ(line.intersect({{0, 3}, {0, 1}}, 0), none);      // behind
  EXPECT_EQ(line.intersect({{1.001, 0}, {0, 1}}, 0), none);  // beside
  EXPECT_EQ(line.intersect({{0, 2}, {1, 0}}, 0), none);      // along
}

TEST(Segments, AreNotHitWhereARayLeavesOrEnds) {
  const Line line({-1, 2}, {1, 2});
  EXPECT_EQ(line.intersect({{0, 2}, {0, 1}, 5}, 5), none);
  EXPECT_EQ(line.intersect({{0, 0}, {0, 2}, no_shape, 5}, 5), none);
  EXPECT_EQ(line.intersect({{0, 0}, {0, 2}, no_shape, no_shape, 1}, 5), none);  // the limit is open
  EXPECT_EQ(line.intersect({{0, 0}, {0, 2.1}, 7, 8, 1}, 5), 2 / 2.1);
}

// Two segments that share an end: a ray through it meets exactly one of them.
TEST(Segments, ShareAnEndWithoutGapOrOverlap) {
  Generator g(1);
  for (int i = 0; i < 100'000; ++i) {
    const Point2 left(-1, g.normal()), shared(0.1 * g.normal(), g.normal()), right(1, g.normal());
    const Line a(left, shared), b(shared, right);
    const Point2 origin(0.1 * g.normal(), -10);
    const Ray<Flatland> ray{origin, shared - origin};
    ASSERT_EQ((a.intersect(ray, 0) < none) + (b.intersect(ray, 1) < none), 1);
  }
}

TEST(Segments, HaveTheirEndsInTheFirstAndTheLastBin) {
  const Point2 from(0.1, 0.2), to(0.7, 1.3);
  const Segment<Flatland> segment(from, to);
  EXPECT_EQ(segment.parameter(from)[0], 0);
  EXPECT_EQ(segment.parameter(from - (to - from))[0], 0);
  for (const Point2& end : {to, 2.0 * to - from}) {
    EXPECT_LT(segment.parameter(end)[0], 1);
    EXPECT_GT(segment.parameter(end)[0], 1 - 1e-15);
  }
}

TEST(Segments, BehaveTheSameTurnedByAQuarter) {
  Generator g(2);
  for (int i = 0; i < 10'000; ++i) {
    const Point2 from(g.normal(), g.normal()), to(g.normal(), g.normal()),
        origin(g.normal(), g.normal()), direction(g.normal(), g.normal());
    const Line line(from, to), turned(left_of(from), left_of(to));
    const Ray<Flatland> ray{origin, direction}, turned_ray{left_of(origin), left_of(direction)};
    const double distance = line.intersect(ray, 0);
    ASSERT_EQ(distance, turned.intersect(turned_ray, 0));
    if (distance == none) continue;
    ASSERT_EQ(left_of(line.surface(ray, {0, distance}).position),
              turned.surface(turned_ray, {0, distance}).position);
  }
}

TEST(Arcs, RunCounterClockwiseFromTheirStart) {
  const Curve arc({1, 1}, 2, turn / 4, turn / 4, Curve::Facing::outward);
  EXPECT_NEAR(arc.measure(), turn / 2, 1e-15);
  EXPECT_NEAR(glm::length(arc.sample({0}).position - Point2(1, 3)), 0, 1e-15);
  EXPECT_NEAR(glm::length(arc.sample({0.5}).normal - Point2(-std::sqrt(0.5), std::sqrt(0.5))), 0,
              1e-15);
  const Curve flipped({1, 1}, 2, turn / 4, turn / 4, Curve::Facing::inward);
  EXPECT_NEAR(glm::length(flipped.sample({0.5}).normal - Point2(std::sqrt(0.5), -std::sqrt(0.5))),
              0, 1e-15);
}

TEST(Arcs, AreHitOnlyWhereTheyAre) {
  const Curve upper({0, 0}, 1, 0, turn / 2, Curve::Facing::outward);
  EXPECT_EQ(upper.intersect({{0, -3}, {0, 1}}, 0), 4);  // through the open lower half
  EXPECT_EQ(upper.intersect({{0, 3}, {0, -1}}, 0), 2);
  EXPECT_EQ(upper.intersect({{-3, -0.5}, {1, 0}}, 0), none);
  const Curve most({0, 0}, 1, 0.1, turn - 0.2, Curve::Facing::outward);  // open around angle zero
  EXPECT_EQ(most.intersect({{3, 0}, {-1, 0}}, 0), 4);
  EXPECT_EQ(most.intersect({{-3, 0}, {1, 0}}, 0), 2);
}

// From a point on the curve the known root is divided out: neither a second hit at distance zero
// nor a step off the surface, however short the way.
TEST(Arcs, AreLeftAndMetAgainAtTheEndOfTheChord) {
  Generator g(3);
  const Curve round = circle({0.3, -0.2}, 1.7);
  for (int i = 0; i < 20'000; ++i) {
    const auto point = round.sample({g.uniform()});
    const double angle = std::pow(10, -12 * g.uniform());  // from the tangent
    const Point2 inward = -point.normal, tangent(inward.y, -inward.x);
    const Point2 in = std::sin(angle) * inward + std::cos(angle) * tangent;
    const double chord = 2 * 1.7 * std::sin(angle);
    ASSERT_NEAR(round.intersect({point.position, in, 4}, 4) / chord, 1, 1e-15 / angle + 1e-14);
    const Point2 out = -std::sin(angle + 1e-9) * inward + std::cos(angle + 1e-9) * tangent;
    ASSERT_EQ(round.intersect({point.position, out, 4}, 4), none);
  }
}

TEST(Arcs, DoNotBlockWhatArrivesFromTheirSide) {
  Generator g(4);
  const Curve round = circle({0, 0}, 1);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = round.sample({g.uniform()}), b = round.sample({g.uniform()});
    // Both ends on the circle, inside it.
    ASSERT_EQ(round.intersect({a.position, b.position - a.position, 4, 4, 1}, 4), none);
    // From outside: blocked exactly when the circle's far side is meant.
    const Point2 far(3, 5 * (g.uniform() - 0.5));
    const double facing = glm::dot(far - a.position, a.normal);
    if (std::abs(facing) < 1e-9) continue;
    const double distance = round.intersect({far, a.position - far, no_shape, 4, 1}, 4);
    ASSERT_EQ(distance < none, facing < 0);
    ASSERT_EQ(round.intersect({a.position, far - a.position, 4, no_shape, 1}, 4) < none,
              facing < 0);
  }
}

TEST(Arcs, AreMissedByRaysThatPassAndMetByRaysThatGraze) {
  const Curve round = circle({0, 0}, 1);
  EXPECT_EQ(round.intersect({{-2, 1.0000001}, {1, 0}}, 0), none);
  EXPECT_NEAR(round.intersect({{-2, 0.9999999}, {1, 0}}, 0), 2, 1e-3);
  EXPECT_NEAR(round.intersect({{-2, 1}, {1, 0}}, 0), 2, 1e-7);  // touches
  EXPECT_EQ(round.intersect({{0, 0}, {1, 0}}, 0), 1);           // from the centre
}

TEST(Spheres, AreLeftAndMetAgainAtTheEndOfTheChord) {
  Generator g(5);
  const Element<Spaceland> self(4);
  const Ball ball({0.3, -0.2, 4}, 1.7, Ball::Facing::outward);
  for (int i = 0; i < 20'000; ++i) {
    const auto point = ball.sample(random_square<3>(g));
    const double angle = std::pow(10, -12 * g.uniform());
    const Frame<3, double> frame{-point.normal};
    const Point3 in = frame.to_world(local_at<3>(std::numbers::pi / 2 - angle, 6 * g.uniform()));
    const double chord = 2 * 1.7 * std::sin(angle);
    ASSERT_NEAR(ball.intersect({point.position, in, self}, self) / chord, 1, 2e-15 / angle + 1e-14);
    const Point3 out =
        frame.to_world(local_at<3>(std::numbers::pi / 2 + angle + 1e-9, 6 * g.uniform()));
    ASSERT_EQ(ball.intersect({point.position, out, self}, self), none);
    const auto other = ball.sample(random_square<3>(g));
    ASSERT_EQ(
        ball.intersect({point.position, other.position - point.position, self, self, 1}, self),
        none);
  }
}

TEST(Arcs, HaveTheirEndsInTheFirstAndTheLastBin) {
  const Point2 center(1, 2);
  const Arc<Flatland> arc(center, 3, 0.4, 1.5, Arc<Flatland>::Facing::outward);
  const auto parameter_at = [&](double angle) {
    return arc.parameter(center + 3.0 * Point2(std::cos(angle), std::sin(angle)))[0];
  };
  EXPECT_NEAR(parameter_at(0.4 - 1e-12), 0, 1e-11);
  EXPECT_NEAR(parameter_at(0.4 + 1.5 + 1e-12), 1, 1e-11);
  EXPECT_LT(parameter_at(0.4 + 1.5 + 1e-12), 1);
}

// Points in the gap of an arc that is open by ten degrees belong to the end that is nearer.
TEST(Arcs, AreContinuedFromTheEndThatIsNearer) {
  const double degree = turn / 360;
  const Arc<Flatland> arc({0, 0}, 1, 0.4, 350 * degree, Arc<Flatland>::Facing::outward);
  const auto parameter_at = [&](double beyond) {
    const double angle = 0.4 - beyond * degree;
    return arc.parameter({std::cos(angle), std::sin(angle)})[0];
  };
  EXPECT_EQ(parameter_at(3), 0);
  EXPECT_GT(parameter_at(7), 0.999);
  EXPECT_LT(parameter_at(7), 1);
}

TEST(Spheres, HaveTheAreaOfTheirDiametersCylinder) {
  const Sphere<Spaceland> sphere({1, 2, 3}, 0.5, Sphere<Spaceland>::Facing::outward);
  EXPECT_DOUBLE_EQ(sphere.measure(), std::numbers::pi);
}

using SpaceRay = Ray<Spaceland>;
const Element<Spaceland> self(0);

TEST(Parallelograms, AreNotHitBehindARay) {
  const Parallelogram<Spaceland> square({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Point3 above(0.5, 0.5, 1);
  EXPECT_EQ(square.intersect(SpaceRay{above, {0, 0, -1}}, self), 1);
  EXPECT_TRUE(std::isinf(square.intersect(SpaceRay{above, {0, 0, 1}}, self)));
}

TEST(Parallelograms, HaveTheNormalOfTheirEdgesAndEndAtThem) {
  const Sheet sheet({0, 0, 1}, {2, 0, 0}, {1, 3, 0});
  EXPECT_EQ(sheet.measure(), 6);
  EXPECT_EQ(sheet.sample({0.5, 0.5}).normal, Point3(0, 0, 1));
  EXPECT_EQ(sheet.intersect(SpaceRay{{1.5, 1.5, 0}, {0, 0, 1}}, self), 1);
  EXPECT_EQ(sheet.intersect(SpaceRay{{1.5, 1.5, 3}, {0, 0, -2}}, self), 1);
  EXPECT_EQ(sheet.intersect(SpaceRay{{0.4, 1.5, 0}, {0, 0, 1}}, self),
            none);  // beside the slanted edge
  EXPECT_EQ(sheet.intersect(SpaceRay{{0.6, 1.5, 0}, {0, 0, 1}}, self), 1);
  EXPECT_EQ(sheet.intersect(SpaceRay{{1, 1, 1}, {1, 0, 0}}, self), none);  // within its plane
  EXPECT_EQ(sheet.intersect(SpaceRay{{1.5, 1.5, 1}, {0, 0, 1}, self}, self), none);
}

}  // namespace
}  // namespace wander::test

// What every shape offers: parameters, even sampling, bounds, and the same bits at every scale.
#include "core/geometry/shape.h"

#include <glm/common.hpp>

#include <gtest/gtest.h>

#include "tests/core/directions.h"
#include "tests/support/expect.h"

namespace wander::test::shapes_test {
namespace {

using Line = Segment<Flatland>;
using Curve = Arc<Flatland>;
using Ball = Sphere<Spaceland>;
using Sheet = Parallelogram<Spaceland>;
using Point2 = Flatland::Point;
using Point3 = Spaceland::Point;
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double turn = 2 * std::numbers::pi;

template <class W>
class Shapes : public ::testing::Test {
 public:
  static constexpr int D = W::dimension;

  static std::vector<Shape<W>> examples(double unit = 1) {
    if constexpr (D == 2)
      return {Line(unit * Point2(0.3, 0.7), unit * Point2(-1.1, 0.2)),
              Curve(unit * Point2(1, 2), unit * 0.4, 0, turn, Curve::Facing::outward),
              Curve(unit * Point2(-0.3, 0.1), unit * 2, 0.3, 1.1, Curve::Facing::inward),
              Curve(unit * Point2(0, 0.1), unit * 0.7, -2, 5, Curve::Facing::outward)};
    else
      return {Sheet(unit * Point3(0.1, 0.2, 0.3), unit * Point3(1, 0.2, -0.3),
                    unit * Point3(-0.4, 2, 0.5)),
              Triangle<W>(unit * Point3(0.1, 0.2, 0.3), unit * Point3(1.1, 0.4, 0),
                          unit * Point3(-0.3, 2.2, 0.8)),
              Ball(unit * Point3(1, -2, 0.5), unit * 0.8, Ball::Facing::inward)};
  }
  static auto sample(const Shape<W>& shape, std::array<double, D - 1> u) {
    return visit_shape([&](const auto& s) { return s.sample(u); }, shape);
  }
  static auto parameter(const Shape<W>& shape, typename W::Point p) {
    return visit_shape([&](const auto& s) { return s.parameter(p); }, shape);
  }
};
using Worlds = ::testing::Types<Flatland, Spaceland>;
TYPED_TEST_SUITE(Shapes, Worlds);

// Of a lamp 1e10 m away and of what stands 1 mm before the sensor: the ray meets it, and does not meet what stands
// 1 mm behind.  What decides is one part in 1e13 of the way.
TEST(Segments, AreMetAtTheEndOfTheLongestRay) {
  Generator g(7);
  for (int i = 0; i < 20'000; ++i) {
    const double far = std::pow(10, 10 * g.uniform()), angle = 0.2 + 2.7 * g.uniform();
    const Point2 end{g.uniform(), 0}, origin = far * Point2(std::cos(angle), std::sin(angle));
    for (const double height : {1e-3, -1e-3}) {
      const double meets = end.x + height * (origin.x - end.x) / origin.y;
      const double size = 0.02 + g.uniform(), at = 0.1 + 0.8 * g.uniform();
      const Line slat({meets - at * size, height}, {meets + (1 - at) * size, height});
      const double found = slat.intersect({.origin = origin, .direction = end - origin, .limit = 1},
                                          Element<Flatland>(0));
      const bool stands_before = height > 0;
      ASSERT_EQ(std::isfinite(found), stands_before) << far << " " << angle;
    }
  }
}

TYPED_TEST(Shapes, KnowTheParameterOfEachOfTheirPoints) {
  constexpr int D = TestFixture::D;
  Generator g(6);
  for (const auto& shape : TestFixture::examples())
    for (int i = 0; i < 10'000; ++i) {
      const auto u = random_square<D>(g);
      const auto v = TestFixture::parameter(shape, TestFixture::sample(shape, u).position);
      for (std::size_t k = 0; k < u.size(); ++k) ASSERT_NEAR(v[k], u[k], 1e-13);
    }
}

TYPED_TEST(Shapes, HaveParametersBelowOne) {
  constexpr int D = TestFixture::D;
  const double last = std::nextafter(1.0, 0.0);
  for (const auto& shape : TestFixture::examples())
    for (const double end : {0.0, last}) {
      std::array<double, D - 1> u;
      u.fill(end);
      for (const double v : TestFixture::parameter(shape, TestFixture::sample(shape, u).position)) {
        EXPECT_GE(v, 0);
        EXPECT_LT(v, 1);
      }
    }
}

// Rays cast evenly at a shape from afar tell its measure: a point x with normal n is met by
// parallel rays of direction d as densely as |n·d|.  So samples weighted by |n·d| fill the shadow
// evenly.
TYPED_TEST(Shapes, AreSampledEvenlyAsTheirShadowsShow) {
  constexpr int D = TestFixture::D;
  Generator g(7);
  const auto direction = local_at<D>(0.5);
  const Frame<D, double> frame{direction};
  for (const auto& shape : TestFixture::examples()) {
    const double measure = visit_shape([](const auto& s) { return s.measure(); }, shape);
    Moments inside, cast;  // of the shadow within a box, by samples and by rays
    constexpr double box = 1.3;
    for (int i = 0; i < 100'000; ++i) {
      const auto point = TestFixture::sample(shape, random_square<D>(g));
      const auto shadow = frame.to_local(point.position);
      bool holds = true;
      for (int axis = 0; axis + 1 < D; ++axis) holds &= std::abs(shadow[axis]) < box;
      inside.add(holds ? measure * std::abs(glm::dot(point.normal, direction)) : 0);

      auto origin = Vec<D, double>(0);
      for (int axis = 0; axis + 1 < D; ++axis) origin[axis] = box * (2 * g.uniform() - 1);
      Ray<TypeParam> ray{frame.to_world(origin) - 100.0 * direction, direction};
      int crossings = 0;
      while (crossings < 3) {  // each crossing is found by leaving the one before
        const double d = visit_shape(
            [&](const auto& s) { return s.intersect(ray, Element<TypeParam>(0)); }, shape);
        if (d == none) break;
        ray = {ray.origin + d * direction, direction, Element<TypeParam>(0)};
        ++crossings;
      }
      cast.add(std::pow(2 * box, D - 1) * crossings);
    }
    EXPECT_TRUE(passes(welch_test(inside, cast, usual_false_alarm)));
  }
}

// Control: a sphere sampled by its polar angle, not its height, is crowded at the
// poles.
TEST(ShapeVisits, ReachEveryAlternativeHoweverManyThereAre) {
  using Three = std::variant<char, int, double>;
  const auto size = [](const auto& value) { return sizeof(value); };
  EXPECT_EQ(visit_shape(size, Three('a')), sizeof(char));
  EXPECT_EQ(visit_shape(size, Three(1)), sizeof(int));
  EXPECT_EQ(visit_shape(size, Three(1.0)), sizeof(double));
}

TEST(Spheres, SampledByAngleWouldNotBeEven) {
  Generator g(11);
  std::vector<double> even, crowded;
  const Ball ball({0, 0, 0}, 1, Ball::Facing::outward);
  for (int i = 0; i < 10'000; ++i) {
    even.push_back((1 + ball.sample(random_square<3>(g)).position.z) / 2);
    crowded.push_back((1 + std::cos(std::numbers::pi * g.uniform())) / 2);
  }
  EXPECT_TRUE(passes(uniformity_test(even, usual_false_alarm)));
  EXPECT_TRUE(rejects(uniformity_test(crowded, usual_false_alarm)));
}

TYPED_TEST(Shapes, LieWithinTheirBoundsAndFillThem) {
  constexpr int D = TestFixture::D;
  Generator g(8);
  for (const auto& shape : TestFixture::examples()) {
    const auto bounds = visit_shape([](const auto& s) { return s.bounds(); }, shape);
    auto low = bounds.high, high = bounds.low;
    for (int i = 0; i < 100'000; ++i) {
      const auto p = TestFixture::sample(shape, random_square<D>(g)).position;
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    for (int axis = 0; axis < D; ++axis) {
      EXPECT_GE(low[axis], bounds.low[axis] - 1e-14);
      EXPECT_LE(high[axis], bounds.high[axis] + 1e-14);
      EXPECT_NEAR(low[axis], bounds.low[axis], 0.03);
      EXPECT_NEAR(high[axis], bounds.high[axis], 0.03);
    }
  }
}

TYPED_TEST(Shapes, PutHitsOnThemselves) {
  constexpr int D = TestFixture::D;
  Generator g(9);
  for (const auto& shape : TestFixture::examples()) {
    int hits = 0;
    for (int i = 0; i < 20'000; ++i) {
      const auto target = TestFixture::sample(shape, random_square<D>(g));
      const auto origin = 5.0 * random_direction<D>(g);
      const Ray<TypeParam> ray{origin, glm::normalize(target.position - origin)};
      const double d = visit_shape(
          [&](const auto& s) { return s.intersect(ray, Element<TypeParam>(0)); }, shape);
      if (d == none) continue;  // the rim
      ++hits;
      const auto hit = visit_shape([&](const auto& s) { return s.surface(ray, {0, d}); }, shape);
      ASSERT_NEAR(glm::length(hit.normal), 1, 1e-15);
      // A grazing ray spreads the last bit of its distance.
      const double grazing = std::abs(glm::dot(hit.normal, ray.direction));
      ASSERT_LE(glm::length(hit.position - (origin + d * ray.direction)), 1e-13 / grazing);
      const auto again = TestFixture::sample(shape, TestFixture::parameter(shape, hit.position));
      ASSERT_NEAR(glm::length(again.position - hit.position), 0, 1e-12);
      ASSERT_LE(d, glm::length(target.position - origin) + 1e-7);
    }
    EXPECT_GT(hits, 19'000);
  }
}

TYPED_TEST(Shapes, AreBlindToPowersOfTwo) {
  constexpr int D = TestFixture::D;
  for (const int power : {-100, 3, 100}) {
    const double unit = std::ldexp(1.0, power);
    const auto plain = TestFixture::examples(), scaled = TestFixture::examples(unit);
    Generator g(10);
    for (std::size_t i = 0; i < plain.size(); ++i)
      for (int k = 0; k < 2000; ++k) {
        const auto u = random_square<D>(g);
        const auto point = TestFixture::sample(plain[i], u),
                   scaled_point = TestFixture::sample(scaled[i], u);
        ASSERT_EQ(unit * point.position, scaled_point.position);
        ASSERT_EQ(point.normal, scaled_point.normal);
        ASSERT_EQ(TestFixture::parameter(plain[i], point.position),
                  TestFixture::parameter(scaled[i], scaled_point.position));
        const auto direction = random_direction<D>(g);
        const auto origin = g.uniform() < 0.5 ? point.position : 2.0 * random_direction<D>(g);
        const Ray<TypeParam> ray{origin, direction,
                                 Element<TypeParam>(g.uniform() < 0.5 ? 0 : no_shape)};
        const Ray<TypeParam> scaled_ray{unit * ray.origin, direction, ray.from};
        const auto meet = [](const Shape<TypeParam>& shape, const Ray<TypeParam>& r) {
          return visit_shape([&](const auto& s) { return s.intersect(r, Element<TypeParam>(0)); },
                             shape);
        };
        ASSERT_EQ(unit * meet(plain[i], ray), meet(scaled[i], scaled_ray));
      }
  }
}

}  // namespace
}  // namespace wander::test::shapes_test

// Each hierarchy, and the list of few curves, finds what a search through all shapes finds, bit for bit.
#include "core/geometry/accelerator.h"

#include <gtest/gtest.h>

#include "tests/core/directions.h"

namespace wander::test {
namespace {

template <class A>
class Hierarchy : public ::testing::Test {
 public:
  using W = typename A::Universe;
  static_assert(Accelerator<A, W>);
  static constexpr int D = W::dimension;
  using Point = typename W::Point;
  using Shapes = std::vector<Shape<W>>;

  static Point random_point(Generator& g) {
    Point p;
    for (int axis = 0; axis < D; ++axis) p[axis] = 2 * g.uniform() - 1;
    return p;
  }

  // A flat or a round shape, of a size between 1e-4 and 1, or along an axis; `unit` multiplies all.
  static Shape<W> random_shape(Generator& g, double unit) {
    const double size = std::pow(10, -4 * g.uniform());
    const Point center = unit * random_point(g), edge = unit * size * random_direction<D>(g);
    const bool flat = g.uniform() < 0.6, inward = g.uniform() < 0.5;
    const bool level = g.uniform() < 0.2;
    const double start = 6 * g.uniform(), extent = g.uniform() < 0.3 ? 7 : 0.1 + 6 * g.uniform();
    if constexpr (D == 2) {
      const Point along = level ? Point(edge.x, 0) : edge;
      if (flat) return Segment<W>(center, center + along);
      return Arc<W>(center, unit * size, start, std::min(extent, 2 * std::numbers::pi),
                    inward ? Arc<W>::Facing::inward : Arc<W>::Facing::outward);
    } else {
      const Point other = unit * size * random_direction<D>(g);
      if (flat && inward) return Triangle<W>(center, center + edge, center + other);
      if (flat && level) return Parallelogram<W>(center, Point(edge.x, 0, 0), Point(0, other.y, 0));
      if (flat) return Parallelogram<W>(center, edge, other);
      return Sphere<W>(center, unit * size,
                       inward ? Sphere<W>::Facing::inward : Sphere<W>::Facing::outward);
    }
  }
  // Some of many primitives.
  static Shapes random_shapes(Generator& g, int count, double unit = 1) {
    Shapes shapes;
    for (int i = 0; i < count; ++i) {
      shapes.push_back(random_shape(g, unit));
      if constexpr (D == 3)
        if (g.uniform() < 0.1) shapes.push_back(random_mesh(g, unit));
    }
    return shapes;
  }
  static Shape<W> random_mesh(Generator& g, double unit) requires(D == 3) {
    auto triangles = std::make_shared<Triangles>();
    const int count = 3 + static_cast<int>(30 * g.uniform());
    const double size = std::pow(10, -2 * g.uniform());
    const Point center = random_point(g);
    for (int i = 0; i < count; ++i) {
      const Point p = unit * (center + size * random_point(g));
      triangles->points.push_back({p.x, p.y, p.z});
      if (i >= 2) triangles->corners.push_back({i - 2, i - 1, i});
    }
    return Mesh<W>(triangles, Mesh<W>::Role::emitter);
  }

  // From the open or from a surface; anywhere, along an axis, or as a connection.
  static Ray<W> random_ray(Generator& g, const Shapes& shapes, double unit = 1) {
    const auto point_on_any = [&](Element<W>& element) {
      const auto id = static_cast<std::size_t>(g.uniform() * static_cast<double>(shapes.size()));
      const auto u = random_square<D>(g);
      const auto point = visit_shape([&](const auto& s) { return s.sample(u); }, shapes[id]);
      element = Element<W>(static_cast<ShapeId>(id), point.primitive);
      return point.position;
    };
    Ray<W> ray{.origin = 1.5 * unit * random_point(g), .direction = random_direction<D>(g)};
    if (g.uniform() < 0.5 && !shapes.empty()) ray.origin = point_on_any(ray.from);
    if (g.uniform() < 0.1) {
      ray.direction = Point(0);
      ray.direction[static_cast<int>(D * g.uniform())] = g.uniform() < 0.5 ? -1 : 1;
    }
    if (g.uniform() < 0.3 && !shapes.empty()) {
      ray.direction = point_on_any(ray.to) - ray.origin;
      ray.limit = 1;
    }
    return ray;
  }

  static PrimitiveId<W> primitive(std::int32_t k) {
    if constexpr (D == 2)
      return {};
    else
      return k;
  }
  static Hit<W> search(const Shapes& shapes, const Ray<W>& ray) {
    Hit<W> hit{no_shape, ray.limit};
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (std::int32_t k = 0; k < primitives<W>(shapes[i]); ++k) {
        const Element<W> element(static_cast<ShapeId>(i), primitive(k));
        const double d =
            visit_shape([&](const auto& s) { return s.intersect(ray, element); }, shapes[i]);
        if (d < hit.distance) hit = {element.shape, d, element.primitive};
      }
    return hit;
  }
};
using Hierarchies =
    ::testing::Types<Bvh<Flatland>, Bvh<Spaceland>, WideBvh<Spaceland>, FewCurves<Flatland>>;
TYPED_TEST_SUITE(Hierarchy, Hierarchies);

TYPED_TEST(Hierarchy, FindsTheClosestHit) {
  Generator g(1);
  int hits = 0, rays = 0;
  for (int scene = 0; scene < 300; ++scene) {
    const auto shapes =
        TestFixture::random_shapes(g, static_cast<int>(std::pow(10, 3 * g.uniform())));
    const TypeParam bvh(shapes);
    for (int i = 0; i < 200; ++i) {
      const auto ray = TestFixture::random_ray(g, shapes);
      const auto expected = TestFixture::search(shapes, ray);
      const auto hit = bvh.closest(ray);
      ASSERT_EQ(bool(hit), bool(expected));
      ASSERT_EQ(bvh.any(ray), bool(expected));
      ++rays;
      if (!hit) continue;
      ++hits;
      ASSERT_EQ(hit.distance, expected.distance);
      ASSERT_EQ(hit.shape, expected.shape);
      ASSERT_EQ(hit.primitive, expected.primitive);
    }
  }
  EXPECT_GT(hits, rays / 4);  // the scenes were worth looking at
}

TYPED_TEST(Hierarchy, OfNothingIsHitByNothing) {
  const TypeParam bvh(std::span<const Shape<typename TestFixture::W>>{});
  Generator g(2);
  const auto ray = TestFixture::random_ray(g, {});
  EXPECT_FALSE(bvh.closest(ray));
  EXPECT_FALSE(bvh.any(ray));
}

TYPED_TEST(Hierarchy, IsBlindToPowersOfTwo) {
  for (const int power : {-190, -100, -7, 100, 190}) {
    const double unit = std::ldexp(1.0, power);
    Generator g(3), scaled_g(3);
    const auto shapes = TestFixture::random_shapes(g, 400);
    const auto scaled = TestFixture::random_shapes(scaled_g, 400, unit);
    const TypeParam bvh(shapes), scaled_bvh(scaled);
    for (int i = 0; i < 2000; ++i) {
      const auto ray = TestFixture::random_ray(g, shapes);
      const auto scaled_ray = TestFixture::random_ray(scaled_g, scaled, unit);
      const auto hit = bvh.closest(ray), scaled_hit = scaled_bvh.closest(scaled_ray);
      ASSERT_EQ(hit.shape, scaled_hit.shape);
      // Connections measure distances in their own length.
      const double length = ray.to.shape == no_shape ? unit : 1;
      ASSERT_EQ(length * hit.distance, scaled_hit.distance);
      ASSERT_EQ(bvh.any(ray), scaled_bvh.any(scaled_ray));
    }
  }
}

// From 1e25 to 1e150 of its extents, farther than single precision has numbers for: along an axis a scene is met as
// a search meets it, and in other directions, which round to anything, nothing goes wrong.
TYPED_TEST(Hierarchy, IsMetFromHoweverFar) {
  constexpr int D = TestFixture::D;
  Generator g(5);
  const auto shapes = TestFixture::random_shapes(g, 7);  // fewer than the children of two levels
  const TypeParam bvh(shapes);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    auto ray = TestFixture::random_ray(g, {});
    const double far = std::pow(10, 25 + 125 * g.uniform());
    const bool is_along_an_axis = i % 2 == 0;
    if (is_along_an_axis) {
      ray.direction = typename TestFixture::Point(0);
      ray.direction[i / 2 % D] = 1;
    }
    ray.origin -= far * ray.direction;
    const auto expected = TestFixture::search(shapes, ray), hit = bvh.closest(ray);
    const bool any = bvh.any(ray);
    if (!is_along_an_axis) continue;
    ASSERT_EQ(hit.distance, expected.distance);
    ASSERT_EQ(any, bool(expected));
    hits += bool(hit);
  }
  EXPECT_GT(hits, 15);
}

// Many shapes in one place cannot be told apart by any plane; the tree ends all the same.
TYPED_TEST(Hierarchy, HoldsShapesThatCoincide) {
  Generator g(4);
  const typename TestFixture::Shapes shapes(1000, TestFixture::random_shape(g, 1));
  const TypeParam bvh(shapes);
  for (int i = 0; i < 100; ++i) {
    const auto ray = TestFixture::random_ray(g, shapes);
    const auto expected = TestFixture::search(shapes, ray), hit = bvh.closest(ray);
    ASSERT_EQ(bool(hit), bool(expected));
    if (!hit) continue;
    ASSERT_EQ(hit.distance, expected.distance);
  }
}

// Where rounding decides: rays at the ends of segments, from far away, or far from the origin of
// the coordinates.  What a search finds there lies beyond the bounds by more than the last bit.
TEST(Boxes, HoldWhatRoundingMakesOfTheEndsOfTheirShapes) {
  using Point = Flatland::Point;
  constexpr int count = 64;
  Generator g(5);
  for (const auto& [place, reach] : {std::pair(0.0, 1e6), {1e6, 1.5}}) {
    std::vector<Point> corners;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count, radius = 0.2 + 0.8 * g.uniform();
      corners.push_back(Point(place, 0.7 * place) +
                        radius * Point(std::cos(angle), std::sin(angle)));
    }
    std::vector<Shape<Flatland>> shapes;
    for (std::size_t i = 0; i < count; ++i)
      shapes.push_back(Segment<Flatland>(corners[i], corners[(i + 1) % count]));
    const Bvh<Flatland> bvh(shapes);
    for (int i = 0; i < 20'000; ++i) {
      const Point target = corners[static_cast<std::size_t>(count * g.uniform())];
      const Point origin = target + reach * (0.5 + g.uniform()) * random_direction<2>(g);
      const Ray<Flatland> ray{.origin = origin, .direction = glm::normalize(target - origin)};
      const auto expected = Hierarchy<Bvh<Flatland>>::search(shapes, ray);
      const auto hit = bvh.closest(ray);
      ASSERT_EQ(bool(hit), bool(expected)) << "corner at " << target.x << ", " << target.y;
      ASSERT_EQ(bvh.any(ray), bool(expected));
    }
  }
}

// Rays that graze circles where these touch their bounds.
TEST(Boxes, HoldWhatRoundingMakesOfTheSummitsOfTheirShapes) {
  using Point = Flatland::Point;
  Generator g(6);
  std::vector<Shape<Flatland>> shapes;
  std::vector<std::pair<Point, double>> circles;
  for (int i = 0; i < 64; ++i) {
    circles.emplace_back(Point(10 * g.uniform(), 10 * g.uniform()), 0.2 * g.uniform());
    shapes.push_back(Arc<Flatland>(circles.back().first, circles.back().second, 0,
                                   2 * std::numbers::pi, Arc<Flatland>::Facing::outward));
  }
  const Bvh<Flatland> bvh(shapes);
  int hits = 0;
  for (int i = 0; i < 100'000; ++i) {
    const auto& [center, radius] = circles[static_cast<std::size_t>(64 * g.uniform())];
    const Point up = g.uniform() < 0.5 ? Point(0, 1) : Point(1, 0), along(up.y, up.x);
    const double slope = 1e-16 * (2 * g.uniform() - 1), reach = 1e-3 + radius * g.uniform();
    const Ray<Flatland> ray{.origin = center + radius * up + reach * along,
                            .direction = slope * up - along};
    const auto expected = Hierarchy<Bvh<Flatland>>::search(shapes, ray);
    ASSERT_EQ(bool(bvh.closest(ray)), bool(expected)) << "ray " << i;
    ASSERT_EQ(bvh.any(ray), bool(expected));
    if (expected) ++hits;
  }
  EXPECT_GT(hits, 1000);
}

// The same in space, where boxes are held in single precision: rays at the corners of a shell of
// triangles, from far away, and of one that lies far from the origin of the coordinates.
TEST(Boxes, HoldWhatRoundingMakesOfTheCornersOfTriangles) {
  using W = Spaceland;
  constexpr int rows = 24;
  Generator g(7);
  for (const auto& [place, reach] : {std::pair(0.0, 1e7), {0.0, 1.5}, {1e7, 1.5}}) {
    const W::Point center(place, 0.7 * place, -0.3 * place);
    const auto corner = [&](int row, int column) {
      const double theta = std::numbers::pi * row / rows,
                   phi = 2 * std::numbers::pi * (column % rows) / rows;
      return center + W::Point(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
    };
    std::vector<Shape<W>> shapes;
    for (int row = 1; row + 1 < rows; ++row)
      for (int column = 0; column < rows; ++column) {
        const W::Point a = corner(row, column), b = corner(row, column + 1),
                       c = corner(row + 1, column), d = corner(row + 1, column + 1);
        shapes.push_back(Triangle<W>(a, c, b));
        shapes.push_back(Triangle<W>(b, c, d));
      }
    const WideBvh<W> hierarchy(shapes);
    int hits = 0;
    for (int i = 0; i < 5'000; ++i) {
      const W::Point target = corner(1 + static_cast<int>((rows - 2) * g.uniform()),
                                     static_cast<int>(rows * g.uniform()));
      const W::Point origin = target + reach * (0.5 + g.uniform()) * random_direction<3>(g);
      const Ray<W> ray{.origin = origin, .direction = glm::normalize(target - origin)};
      const auto expected = Hierarchy<WideBvh<W>>::search(shapes, ray);
      ASSERT_EQ(bool(hierarchy.closest(ray)), bool(expected)) << "ray " << i;
      ASSERT_EQ(hierarchy.any(ray), bool(expected));
      if (expected) ++hits;
    }
    EXPECT_GT(hits, 1000);
  }
}

}  // namespace
}  // namespace wander::test

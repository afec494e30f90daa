// Meshes: no light leaks at their edges and corners, none is caught where it starts, and those that
// emit are sampled evenly, one to one.
#include "core/geometry/mesh.h"

#include <gtest/gtest.h>

#include "tests/core/geometry/mesh_leaks.h"
#include "tests/support/expect.h"

namespace wander::test {
namespace {

using W = Spaceland;
using Point = W::Point;

TEST(ClosedMeshes, LetNoLightOut) {
  const MeshLeaks leaks = count_leaks(1, 200, 1000, by_hierarchy);
  EXPECT_GT(leaks.rays, 100'000);
  EXPECT_EQ(leaks.escaped, 0);
}

// Control: each triangle for itself, as it is often written [Möller and Trumbore 1997].
bool meets_alone(const Ray<W>& ray, Point a, Point b, Point c) {
  const Point across = glm::cross(ray.direction, c - a);
  const double det = glm::dot(b - a, across);
  const Point to = ray.origin - a, along = glm::cross(to, b - a);
  const double u = glm::dot(to, across) / det, v = glm::dot(ray.direction, along) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && glm::dot(c - a, along) / det > 0;
}
TEST(ClosedMeshes, LeakWhenEachTriangleComputesItsOwnEdges) {
  const auto alone = [](const MeshRays& draws) {
    return [&draws](const Ray<W>& ray) {
      const Triangles& mesh = draws.mesh();
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh.corners.size()); ++i)
        if (ray.from != Element<W>(0, i) &&
            meets_alone(ray, corner_of(mesh, i, 0), corner_of(mesh, i, 1), corner_of(mesh, i, 2)))
          return true;
      return false;
    };
  };
  EXPECT_GT(count_leaks(2, 100, 300, alone).escaped, 10);
}

// In the wedge between two walls rounding puts points of one behind the other; light that starts
// there stays in the room.
TEST(ClosedMeshes, LetNoLightOutOfSharpWedges) {
  Generator g(10);
  int rays = 0, escaped = 0;
  for (int i = 0; i < 300; ++i) {
    const Frame<3, double> frame{random_direction<3>(g)};
    const Point center = random_direction<3>(g);
    const double height = std::pow(10, -12 - 3 * g.uniform());
    Triangles wedge;  // a prism: the floor is z = 0, the roof rises along x
    for (const double y : {0, 1})
      for (const Point& p : {Point(0, y, 0), Point(1, y, 0), Point(1, y, height)}) {
        const Point q = center + frame.to_world(p);
        wedge.points.push_back({q.x, q.y, q.z});
      }
    wedge.corners = {{0, 4, 1}, {0, 3, 4}, {0, 2, 5}, {0, 5, 3},
                     {1, 4, 5}, {1, 5, 2}, {0, 1, 2}, {3, 5, 4}};
    const auto mesh = std::make_shared<const Triangles>(wedge);
    const std::vector<Shape<W>> shapes{Mesh<W>(mesh, Mesh<W>::Role::emitter)};
    const SceneAccelerator<W> hierarchy(shapes);
    for (int k = 0; k < 1000; ++k) {
      const auto triangle = static_cast<std::int32_t>(2 * g.uniform());
      const Point a = corner_of(*mesh, triangle, 0), b = corner_of(*mesh, triangle, 1),
                  c = corner_of(*mesh, triangle, 2);
      const double u = 0.1 + 0.4 * g.uniform(), v = 0.1 + 0.3 * g.uniform();
      const auto local = Dimension<3>::cosine_sample(random_square<3>(g));
      ++rays;
      escaped += !hierarchy.closest({.origin = a + u * (b - a) + v * (c - a),
                                     .direction = Frame<3, double>{frame.normal}.to_world(local),
                                     .from = Element<W>(0, triangle)});
    }
  }
  EXPECT_EQ(escaped, 0) << "of " << rays;
}

// Rays that leave a convex mesh never meet it again, from a micrometre to a thousand kilometres.
TEST(ClosedMeshes, AreNotMetByWhatLeavesThem) {
  Generator g(3);
  for (const double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const auto mesh = std::make_shared<const Triangles>(ball_mesh(g, 40, 0, Point(0), scale));
    const std::vector<Shape<W>> shapes{Mesh<W>(mesh, Mesh<W>::Role::emitter)};
    const SceneAccelerator<W> hierarchy(shapes);
    int met = 0;
    for (int i = 0; i < 20'000; ++i) {
      const auto start = std::get<Mesh<W>>(shapes[0]).sample(random_square<3>(g));
      const auto local = Dimension<3>::cosine_sample(random_square<3>(g));
      met += hierarchy.any({.origin = start.position,
                            .direction = Frame<3, double>{start.normal}.to_world(local),
                            .from = Element<W>(0, start.primitive)});
    }
    EXPECT_EQ(met, 0) << scale;
  }
}

// Sheets that share corners, as the walls of a room do.
// Whichever axis a ray runs along: the two others follow it in their order, and a triangle is met where
// its plane is.
TEST(ShearedRays, MeetTrianglesAlongEveryAxis) {
  using SpaceRay = Ray<Spaceland>;
  const Vec<3, double> directions[] = {{1, 0.2, -0.3}, {-0.3, 1, 0.2},  {0.2, -0.3, 1},
                                       {-1, 0.2, 0.3}, {0.3, -1, -0.2}, {-0.2, 0.3, -1}};
  for (const auto& d : directions) {
    const ShearedRay<Spaceland> ray(SpaceRay{{0.1, 0.2, 0.3}, d});
    EXPECT_EQ(std::abs(d[ray.z]), 1);
    EXPECT_EQ(ray.x, (ray.z + 1) % 3);
    EXPECT_EQ(ray.y, (ray.z + 2) % 3);
    // In a plane across the ray, two directions away.
    const Vec<3, double> target = ray.origin + 2.0 * d;
    const Vec<3, double> u = glm::cross(d, Vec<3, double>(0.4, 0.5, 0.6)), v = glm::cross(d, u);
    const Triangle<Spaceland> around(target - u - v, target + 2.0 * u - v, target + 2.0 * v);
    const Triangle<Spaceland> beside(target + u, target + 2.0 * u, target + 2.0 * u + v);
    EXPECT_NEAR(around.intersect(ray, Element<Spaceland>(0)), 2, 1e-14);
    EXPECT_TRUE(std::isinf(beside.intersect(ray, Element<Spaceland>(0))));
  }
}

TEST(Parallelograms, LetNoLightOutWhereTheyShareCorners) {
  const Point o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const std::vector<Shape<W>> room{Parallelogram<W>(o, x, y), Parallelogram<W>(z, y, x),
                                   Parallelogram<W>(o, y, z), Parallelogram<W>(x, z, y),
                                   Parallelogram<W>(o, z, x), Parallelogram<W>(y, x, z)};
  const SceneAccelerator<W> hierarchy(room);
  Generator g(4);
  for (int i = 0; i < 200'000; ++i) {
    const Point origin(0.1 + 0.8 * g.uniform(), 0.1 + 0.8 * g.uniform(), 0.1 + 0.8 * g.uniform());
    Point aim(g.uniform() < 0.5, g.uniform() < 0.5, g.uniform() < 0.5);
    if (g.uniform() < 0.5) aim[static_cast<int>(3 * g.uniform())] = g.uniform();
    ASSERT_TRUE(hierarchy.closest({.origin = origin, .direction = aim - origin}));
  }
}

// Of different sizes, two of them without area.
Mesh<W> uneven_mesh(double unit = 1) {
  Triangles mesh;
  mesh.points = {{0, 0, 0},   {1, 0, 0}, {0, 2, 0},   {1, 2, 0.5},
                 {0.5, 0, 0}, {5, 5, 5}, {5, 5.01, 5}};
  for (auto& p : mesh.points)
    for (double& c : p) c *= unit;
  mesh.corners = {{0, 1, 1}, {0, 1, 2}, {1, 3, 2}, {0, 4, 1}, {3, 5, 6}, {0, 3, 5}};
  return {std::make_shared<const Triangles>(mesh), Mesh<W>::Role::emitter};
}
const std::vector<double> uneven_areas = [] {
  const Point p[] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {1, 2, 0.5}, {5, 5, 5}, {5, 5.01, 5}};
  const auto area = [](Point a, Point b, Point c) {
    return glm::length(glm::cross(b - a, c - a)) / 2;
  };
  return std::vector{0.0, area(p[0], p[1], p[2]), area(p[1], p[3], p[2]),
                     0.0, area(p[3], p[4], p[5]), area(p[0], p[3], p[4])};
}();

TEST(Meshes, HaveTheAreaOfTheirTriangles) {
  double sum = 0;
  for (const double area : uneven_areas) sum += area;
  EXPECT_NEAR(uneven_mesh().measure(), sum, 1e-14);
}

TEST(Meshes, AreSampledByArea) {
  const Mesh<W> mesh = uneven_mesh();
  Generator g(5);
  constexpr int count = 200'000;
  std::vector<double> observed(6), expected(6), wrong(6);
  for (int i = 0; i < count; ++i)
    observed[static_cast<std::size_t>(mesh.sample(random_square<3>(g)).primitive)] += 1;
  double sum = 0;
  for (const double area : uneven_areas) sum += area;
  for (std::size_t i = 0; i < 6; ++i) {
    expected[i] = count * uneven_areas[i] / sum;
    wrong[i] = i == 0 || i == 3 ? 0 : count / 4.0;
  }
  EXPECT_TRUE(passes(chi_square_test(observed, expected, usual_false_alarm)));
  EXPECT_TRUE(rejects(chi_square_test(observed, wrong, usual_false_alarm)));
}

// The weight w of a corner has P(W > w) = (1 - w)².
TEST(Meshes, AreSampledEvenlyWithinTheirTriangles) {
  Generator g(6);
  const auto mesh = std::make_shared<const Triangles>(ball_mesh(g, 6, 0.4));
  const Mesh<W> ball(mesh, Mesh<W>::Role::emitter);
  std::vector<double> first, second;
  for (int i = 0; i < 100'000; ++i) {
    const auto point = ball.sample(random_square<3>(g));
    const Point a = corner_of(*mesh, point.primitive, 0), b = corner_of(*mesh, point.primitive, 1),
                c = corner_of(*mesh, point.primitive, 2);
    const Point area = glm::cross(b - a, c - a);
    const double size = glm::dot(area, area);
    const double to_b = glm::dot(glm::cross(point.position - a, c - a), area) / size,
                 to_c = glm::dot(glm::cross(b - a, point.position - a), area) / size;
    first.push_back(std::pow(1 - to_b, 2));
    second.push_back(std::pow(1 - to_c, 2));
    ASSERT_NEAR(glm::dot(point.normal, point.position - a), 0, 1e-14);
  }
  EXPECT_TRUE(passes(uniformity_test(first, usual_false_alarm)));
  EXPECT_TRUE(passes(uniformity_test(second, usual_false_alarm)));
}

TEST(Meshes, KnowTheParameterOfEachOfTheirPoints) {
  Generator g(7);
  const Mesh<W> ball(std::make_shared<const Triangles>(ball_mesh(g, 30, 0.3)),
                     Mesh<W>::Role::emitter);
  for (const Mesh<W>& mesh : {uneven_mesh(), ball})
    for (int i = 0; i < 20'000; ++i) {
      const auto u = random_square<3>(g);
      const auto point = mesh.sample(u);
      const auto v = mesh.parameter(point.position, point.primitive);
      ASSERT_NEAR(v[0], u[0], 1e-12);
      ASSERT_NEAR(v[1], u[1], 1e-9);  // near the first corner it is a matter of few bits
      const auto again = mesh.sample(v);
      ASSERT_EQ(again.primitive, point.primitive);
      ASSERT_NEAR(glm::length(again.position - point.position), 0, 1e-12);
    }
}

// Numbers at the borders of triangles choose one of the two, and never one without area.
TEST(Meshes, AreSampledAtTheEndsOfTheUnitSquare) {
  const Mesh<W> mesh = uneven_mesh();
  const double last = std::nextafter(1.0, 0.0);
  for (const double u0 : {0.0, last, 0.5})
    for (const double u1 : {0.0, last}) {
      const auto point = mesh.sample({u0, u1});
      EXPECT_NE(point.primitive, 0);
      EXPECT_NE(point.primitive, 3);
      EXPECT_EQ(point.primitive == 1, u0 == 0);
      EXPECT_EQ(point.primitive == 5, u0 > 0);
      for (const double v : mesh.parameter(point.position, point.primitive)) {
        EXPECT_GE(v, 0);
        EXPECT_LT(v, 1);
      }
      EXPECT_TRUE(std::isfinite(glm::length(point.position)));
    }
}

TEST(Meshes, AreBlindToPowersOfTwo) {
  const Mesh<W> mesh = uneven_mesh();
  for (const int power : {-100, 3, 100}) {
    const double unit = std::ldexp(1.0, power);
    const Mesh<W> scaled = uneven_mesh(unit);
    EXPECT_EQ(scaled.measure(), unit * unit * mesh.measure());
    Generator g(8);
    for (int i = 0; i < 5000; ++i) {
      const auto u = random_square<3>(g);
      const auto point = mesh.sample(u), other = scaled.sample(u);
      ASSERT_EQ(unit * point.position, other.position);
      ASSERT_EQ(point.primitive, other.primitive);
      ASSERT_EQ(point.normal, other.normal);
      ASSERT_EQ(mesh.parameter(point.position, point.primitive),
                scaled.parameter(other.position, other.primitive));
      const Point origin = 3.0 * random_direction<3>(g), aim = point.position - origin;
      for (std::int32_t k = 0; k < mesh.primitives(); ++k) {
        const Element<W> element(0, k);
        const Ray<W> ray{.origin = origin, .direction = aim},
            scaled_ray{.origin = unit * origin, .direction = unit * aim};
        const double d = mesh.intersect(ray, element);
        ASSERT_EQ(d, scaled.intersect(scaled_ray, element));
        if (std::isinf(d)) continue;
        ASSERT_EQ(unit * mesh.surface(ray, {0, d, k}).position,
                  scaled.surface(scaled_ray, {0, d, k}).position);
      }
    }
  }
}

// A mesh that is told apart triangle by triangle: two points of one do not see each other, those of
// two may.
TEST(Meshes, AreLeftByTheTriangleAndMetByTheOthers) {
  const auto mesh = std::make_shared<const Triangles>(box_mesh(Point(0), Point(1)));
  const std::vector<Shape<W>> shapes{Mesh<W>(mesh, Mesh<W>::Role::emitter)};
  const SceneAccelerator<W> hierarchy(shapes);
  Generator g(9);
  const auto& box = std::get<Mesh<W>>(shapes[0]);
  for (int i = 0; i < 20'000; ++i) {
    const auto a = box.sample(random_square<3>(g)), b = box.sample(random_square<3>(g));
    if (a.normal == b.normal) continue;
    const Ray<W> ray{.origin = a.position,
                     .direction = b.position - a.position,
                     .from = Element<W>(0, a.primitive),
                     .to = Element<W>(0, b.primitive),
                     .limit = 1};
    ASSERT_FALSE(hierarchy.any(ray));
    Ray<W> on = ray;
    on.to = {};
    on.limit = std::numeric_limits<double>::infinity();
    const Hit<W> hit = hierarchy.closest(on);
    ASSERT_EQ(hit.primitive, b.primitive);
    ASSERT_NEAR(hit.distance, 1, 1e-12);
  }
}

}  // namespace
}  // namespace wander::test

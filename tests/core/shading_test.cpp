// Meshes shaded by the normals of their corners: the normals between them, what they make of values and
// densities, and films.  False-alarm rate 1e-9 per film.
#include "core/shading.h"

#include <gtest/gtest.h>

#include "tests/core/film_sampling.h"
#include "tests/core/geometry/meshes.h"
#include "tests/support/expect.h"

namespace wander::test::shading_test {
namespace {

using W = Spaceland;
using Point = W::Point;
using Sheet = Parallelogram<W>;
using Ball = Sphere<W>;

std::shared_ptr<const Triangles> shared(Triangles mesh) {
  return std::make_shared<const Triangles>(std::move(mesh));
}
Mesh<W> passive(Triangles mesh) { return {shared(std::move(mesh)), SurfaceRole::passive}; }

std::array<double, 3> numbers(Point p) { return {p.x, p.y, p.z}; }

// ---- the normals

Triangles one_triangle() {
  Triangles mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.corners = {{0, 1, 2}};
  return mesh;
}

TEST(SmoothMeshes, HaveTheNormalsOfTheirCornersAndWhatIsBetween) {
  Triangles mesh = one_triangle();
  EXPECT_FALSE(passive(mesh).is_smooth());
  mesh.normals = {{0, 0, 1}, {0.6, 0, 0.8}, {0, 0.8, 0.6}};
  const Mesh<W> smooth = passive(mesh);
  EXPECT_TRUE(smooth.is_smooth());
  const auto expect_normal = [&](Point p, Point expected) {
    EXPECT_LT(glm::length(smooth.shading_normal(p, 0) - glm::normalize(expected)), 1e-15);
  };
  expect_normal({0, 0, 0}, {0, 0, 1});
  expect_normal({2, 0, 0}, {0.6, 0, 0.8});
  expect_normal({0, 2, 0}, {0, 0.8, 0.6});
  expect_normal({1, 0, 0}, {0.3, 0, 0.9});
  expect_normal({0.5, 0.5, 0}, {0.15, 0.2, 0.5 + 0.2 + 0.15});
  // Numbered apart from the points.
  mesh.normal_corners = {{1, 1, 2}};
  EXPECT_LT(glm::length(passive(mesh).shading_normal({0, 0, 0}, 0) - Point(0.6, 0, 0.8)), 1e-15);
}

// The corners of a triangle say where its front is; no normal says nothing.
TEST(SmoothMeshes, AreShadedOnTheSideOfTheirTriangles) {
  Triangles mesh = one_triangle();
  mesh.normals = {{0, 0, -1}, {-0.6, 0, -0.8}, {0, 0, 0}};
  const Mesh<W> turned = passive(mesh);
  EXPECT_LT(glm::length(turned.shading_normal({2, 0, 0}, 0) - Point(0.6, 0, 0.8)), 1e-15);
  EXPECT_EQ(turned.shading_normal({0, 2, 0}, 0), Point(0, 0, 1));
  mesh.normals = {{0.6, 0, 0.8}, {1, 0, 0}, {-1, 0, 0}};
  mesh.normal_corners = {{-1, 1, 2}};
  const Mesh<W> partial = passive(mesh);
  EXPECT_EQ(partial.shading_normal({0, 0, 0}, 0), Point(0, 0, 1));
  EXPECT_EQ(partial.shading_normal({1, 1, 0}, 0), Point(0, 0, 1));  // the two cancel
}

// To the last bit.
TEST(SmoothMeshes, AreShadedAlikeAtEveryPowerOfTwo) {
  Triangles mesh = one_triangle();
  mesh.normals = {{0.1, 0.2, 1}, {0.6, 0, 0.8}, {0, 0.8, 0.6}};
  Triangles large = mesh;
  for (auto& p : large.points)
    for (double& x : p) x = std::ldexp(x, 60);
  const Mesh<W> small_mesh = passive(mesh), large_mesh = passive(large);
  for (const Point p : {Point(0.1, 0.3, 0), Point(1.1, 0.7, 0), Point(0.3, 1.6, 0)})
    EXPECT_EQ(small_mesh.shading_normal(p, 0),
              large_mesh.shading_normal(p * std::ldexp(1.0, 60), 0));
}

// ---- values and densities

// A triangle whose normals are all this one, of a material, with rays from and to given points.
struct Tilted {
  std::shared_ptr<const Scene<W>> scene;

  Tilted(Material<W> material, Point shading) {
    Triangles mesh = one_triangle();
    mesh.normals = {numbers(shading)};
    mesh.normal_corners = {{0, 0, 0}};
    SceneParts<W> parts;
    parts.materials = {std::move(material), Black<W>{}};
    parts.parts.push_back({passive(mesh), 0, 0, false});
    parts.parts.push_back({Sheet({0, 0, 9}, {1, 0, 0}, {0, 1, 0}), 1, 1, true});
    parts.resolution = {1, 1};
    parts.max_vertices = 3;
    scene = std::make_shared<const Scene<W>>(std::move(parts));
  }
  // The path from a point to the triangle to another.
  Path<W> path(Point to_light, Point to_sensor, Event event) const {
    Path<W> x(3);
    x.resize(3);
    const Point middle(0.5, 0.5, 0);
    x[1].place = {middle, {0, 0, 1}, to_sensor, 0, 0};
    x[1].event = event;
    x[0].place = {middle + to_light, -to_light, -to_light, 1, 0};
    x[2].place = {middle + to_sensor, -to_sensor, {}, 1, 0};
    x[0].geometry = std::abs(to_light.z);
    x[1].geometry = std::abs(to_sensor.z);
    Transport<W>(*scene, Roulette::off).evaluate(x, 1);
    return x;
  }
};

// [Veach 1997, eq. 5.19]: f_s |L·S| / |L·N|, and densities of area are those about S.
TEST(Shading, GivesValuesAndDensitiesOfTheOwnNormal) {
  const Point s = glm::normalize(Point(0.3, -0.2, 1)),
              light = glm::normalize(Point(-0.1, 0.5, 0.7)),
              sensor = glm::normalize(Point(0.8, 0.1, 0.4));
  const Tilted plaster(Diffuse<W>{0.7}, s);
  const Path<W> x = plaster.path(light, sensor, Event::scattering);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(x[1].value * x[0].geometry, 0.7 / pi * glm::dot(light, s), 1e-15);
  EXPECT_NEAR(x[0].from_sensor, glm::dot(light, s) / pi, 1e-15);
  EXPECT_NEAR(x[2].from_light, glm::dot(sensor, s) / pi, 1e-15);
  // The adjoint, f*: the same formula with light and sensor exchanged.
  const Path<W> back = plaster.path(sensor, light, Event::scattering);
  EXPECT_NEAR(back[1].value * glm::dot(light, s) / light.z,
              x[1].value * glm::dot(sensor, s) / sensor.z, 1e-15);
  EXPECT_GT(std::abs(back[1].value / x[1].value - 1), 0.1);
}

TEST(Shading, CarriesNoLightWhereTheTwoNormalsDisagree) {
  const Point s = glm::normalize(Point(1, 0, 1)), above(0, 0, 1),
              behind_s = glm::normalize(Point(-1, 0, 0.5)),  // in front by N only
      behind_n = glm::normalize(Point(1, 0, -0.5));          // in front by S only
  for (const Material<W>& material :
       {Material<W>(Diffuse<W>{0.7}), Material<W>(RoughConductor<W>{0.5, 1}),
        Material<W>(RoughDielectric<W>{0.5, 1.5, 1})}) {
    const Tilted room(material, s);
    for (const Point bad : {behind_s, behind_n})
      for (const bool reversed : {false, true}) {
        const Path<W> x = reversed ? room.path(above, bad, Event::scattering)
                                   : room.path(bad, above, Event::scattering);
        EXPECT_EQ(x[1].value, 0);
        EXPECT_EQ(x[0].from_sensor, 0);
        EXPECT_EQ(x[2].from_light, 0);
      }
    EXPECT_GT(room.path(glm::normalize(Point(0.5, 0.1, 1)), above, Event::scattering)[1].value, 0);
  }
}

// ---- films

// A sheet above the floor whose normals lean to one side.
Triangles leaning_sheet() {
  Triangles mesh;
  mesh.points = {{0.05, 0.1, 0.6}, {0.95, 0.1, 0.62}, {0.95, 0.9, 0.65}, {0.05, 0.9, 0.63}};
  mesh.corners = {{0, 1, 2}, {0, 2, 3}};
  for (const Point lean :
       {Point(0.7, 0, 1), Point(0.8, 0.2, 1), Point(0.5, 0.1, 1), Point(1, 0, 1)})
    mesh.normals.push_back(numbers(glm::normalize(lean)));
  return mesh;
}

enum class Shading { flat, smooth };

struct SmoothRoom {
  std::vector<Material<W>> materials{Diffuse<W>{0.6}, Black<W>{}};
  SceneParts<W> parts;

  // The ball has few triangles: its normals are far from their own.
  explicit SmoothRoom(Material<W> smooth, Shading shading = Shading::smooth) {
    Generator g(1);
    const Point middle(0.5, 0.5, 0.3);
    Triangles ball = ball_mesh(g, 5, 0, middle, 0.25);
    for (const auto& p : ball.points)
      ball.normals.push_back(numbers(glm::normalize(Point(p[0], p[1], p[2]) - middle)));
    materials.push_back(std::move(smooth));
    const Point o(0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const auto add = [&](Shape<W> shape, std::size_t material, double radiance, bool is_sensor) {
      parts.parts.push_back({std::move(shape), material, radiance, is_sensor});
    };
    add(Sheet(o, x, y), 0, 0, true);
    add(Sheet(z, y, x), 0, 0, false);
    add(Sheet(o, y, z), 0, 0, false);
    add(Sheet(x, z, y), 0, 0, false);
    add(Sheet({0.2, 0.3, 0.95}, {0, 0.5, 0.02}, {0.6, 0, 0}), 1, 3, false);
    for (Triangles mesh : {ball, leaning_sheet()}) {
      if (shading == Shading::flat) mesh.normals.clear();
      add(passive(std::move(mesh)), 2, 0, false);
    }
    parts.materials = materials;
    parts.resolution = {2, 2};
    parts.max_vertices = 5;
  }
};

// Densities that are left about the shading normal.
struct Unstretched : Transport<W> {
  using Transport<W>::Transport;
  void evaluate(Path<W>& x, int i) const {
    Transport<W>::evaluate(x, i);
    if (x[i].event == Event::emission || x[i].event == Event::detection) return;
    const ShadingFrame<W> frame(scene(), x[i].place);
    const double light = frame.stretch(x[i - 1].place.to_sensor),
                 sensor = frame.stretch(x[i].place.to_sensor);
    if (light > 0) x[i - 1].from_sensor /= light;
    if (sensor > 0) x[i + 1].from_light /= sensor;
  }
};

// By walks from the sensor alone: those from the light weigh |E·N| / |L·N|, whose square has no mean over
// the light that grazes a surface, so that no number of samples has the error that it claims.
TEST(Shading, GivesAllEstimatorsTheSameFilm) {
  for (const Material<W>& material :
       {Material<W>(Diffuse<W>{0.8}), Material<W>(Mirror<W>{0.9}),
        Material<W>(Dielectric<W>{1.5, 1}), Material<W>(RoughConductor<W>{0.4, 0.9}),
        Material<W>(RoughDielectric<W>{0.5, 1.5, 1})}) {
    const Scene<W> scene(SmoothRoom(material).parts);
    const auto reference = sample_film(scene, find_estimator("bdpt"), 240'000, 1);
    for (const auto method : {"pt", "pt-naive"})
      EXPECT_TRUE(passes(agree(sample_film(scene, find_estimator(method), 60'000, 2), reference)))
          << method << ", material " << material.index();
    // The same room shaded flat is another one.
    const Scene<W> flat(SmoothRoom(material, Shading::flat).parts);
    EXPECT_TRUE(rejects(agree(sample_film(flat, find_estimator("bdpt"), 160'000, 3), reference)))
        << "material " << material.index();
  }
}

// Nothing grazes the sheet here, and the error of walks from the light is one: a lamp and a sensor above it.
TEST(Shading, GivesWalksFromTheLightTheSameFilm) {
  for (const Material<W>& material :
       {Material<W>(Diffuse<W>{0.8}), Material<W>(Mirror<W>{0.9}),
        Material<W>(Dielectric<W>{1.5, 1}), Material<W>(RoughConductor<W>{0.4, 0.9}),
        Material<W>(RoughDielectric<W>{0.5, 1.5, 1})}) {
    const auto films_of = [&](Shading shading) {
      Triangles sheet = leaning_sheet();
      if (shading == Shading::flat) sheet.normals.clear();
      SceneParts<W> parts;
      parts.materials = {Black<W>{}, material};
      parts.parts.push_back({Sheet({0.3, 0.3, 1.4}, {0, 0.4, 0}, {0.4, 0, 0}), 0, 3, false});
      parts.parts.push_back({Sheet({-1, -1, 1.6}, {0, 3, 0}, {4, 0, 0}), 0, 0, true});
      parts.parts.push_back({passive(std::move(sheet)), 1, 0, false});
      parts.resolution = {2, 2};
      parts.max_vertices = 3;
      return std::make_unique<Scene<W>>(std::move(parts));
    };
    const auto scene = films_of(Shading::smooth), flat = films_of(Shading::flat);
    const auto reference = sample_film(*scene, find_estimator("bdpt"), 240'000, 1);
    for (const auto method : {"lt", "lt-naive"})
      EXPECT_TRUE(passes(agree(sample_film(*scene, find_estimator(method), 60'000, 2), reference)))
          << method << ", material " << material.index();
    EXPECT_TRUE(rejects(agree(sample_film(*flat, find_estimator("lt"), 60'000, 3), reference)))
        << "material " << material.index();
  }
}

// Even light of radiance 1 all around a tilted triangle that a camera looks down on: a cosine lobe about
// S of which (1 + S·N)/2 is above the triangle; all of a mirror's image; what glass lets pass and not.
TEST(Shading, ReflectsTheRadianceOfAFurnaceAboutItsNormal) {
  const Point s = glm::normalize(Point(0.5, 0, 1));
  const double cosine = s.z, n = 1.5, f = fresnel(cosine, 1.0, n);
  const std::pair<Material<W>, double> cases[] = {{Diffuse<W>{0.7}, 0.7 * (1 + cosine) / 2},
                                                  {Mirror<W>{0.9}, 0.9},
                                                  {Dielectric<W>{n, 1}, f + (1 - f) / (n * n)}};
  for (const auto& [material, exact] : cases) {
    Triangles mesh = one_triangle();
    mesh.normals = {numbers(s)};
    mesh.normal_corners = {{0, 0, 0}};
    SceneParts<W> parts;
    parts.materials = {material, Black<W>{}};
    parts.parts.push_back({passive(mesh), 0, 0, false});
    parts.parts.push_back({Ball({0.5, 0.5, 0}, 2.2, Ball::Facing::inward), 1, 1, false});
    const bool is_specular = material.index() != 0;
    const double width = is_specular ? 1e-4 : 0.9;  // glass is as Fresnel says of one angle
    parts.camera = Camera<W>{.position = {0.5, 0.5, 1},
                             .axis = {0, 0, -1},
                             .across = {Point(1, 0, 0), Point(0, -1, 0)},
                             .extent = {width, width}};
    parts.resolution = {1, 1};
    parts.max_vertices = 3;
    const Scene<W> scene(parts);
    for (const auto method : {"pt", "pt-naive", "bdpt", "lt"}) {
      const bool from_light = method == std::string_view("lt");
      if (is_specular && from_light) continue;  // a camera sees no mirror so
      const auto film =
          sample_film(scene, find_estimator(method), from_light ? 1'000'000 : 100'000, 1);
      const double z = (film.total[0].value - exact) / std::max(film.total[0].error, 1e-5);
      EXPECT_LT(std::abs(z), 6.2) << method << ", material " << material.index();
      // With light and sensor exchanged it would be this much more or less.
      const double wrong = (film.total[0].value - exact * cosine) / film.total[0].error;
      EXPECT_GT(std::abs(wrong), 6.2) << method << ", material " << material.index();
    }
    // Densities about S are not those of areas; of a lobe the wrong weights have hardly a variance.
    if (!is_specular) continue;
    const Estimator& naive = find_estimator("pt-naive");
    const auto film = sample_film_in(Unstretched(scene, Roulette::off), naive.techniques,
                                     naive.heuristic, 100'000, 2);
    EXPECT_GT(std::abs(film.total[0].value - exact), 6.2 * film.total[0].error)
        << "material " << material.index();
  }
}

// ---- walks

// What was sampled has a density, and the numbers that would have made it make it again.
TEST(Shading, SamplesWhatItHasADensityOf) {
  for (const Material<W>& material :
       {Material<W>(Diffuse<W>{0.8}), Material<W>(Mirror<W>{0.9}),
        Material<W>(Dielectric<W>{1.5, 1}), Material<W>(RoughDielectric<W>{0.5, 1.5, 1})}) {
    const Scene<W> scene(SmoothRoom(material).parts);
    const Transport<W> space(scene, Roulette::off);
    Path<W> x(3), again(3);
    x.resize(3);
    Rng rng(5, Purpose::test, 0);
    int sampled = 0, ended = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
      rng.start(i);
      space.begin_light(x, 0, rng);
      if (!space.extend(x, 0, Toward::sensor, rng) || x[1].place.shape < 5) continue;
      if (!space.extend(x, 1, Toward::sensor, rng)) {
        ++ended;
        continue;
      }
      ++sampled;
      space.evaluate(x, 1);
      ASSERT_GT(x[2].from_light, 0);
      ASSERT_GT(x[0].from_sensor, 0);
      again = x;
      const auto u = space.invert_extend(x, 1, Toward::sensor, rng);
      ASSERT_TRUE(space.extend(again, 1, Toward::sensor, u));
      EXPECT_LT(glm::length(again[2].place.position - x[2].place.position), 1e-5);
      if (!is_specular(x[1].event)) continue;
      again[2].place.position = Point(0);
      ASSERT_TRUE(space.follow(again, 1, Toward::sensor, x[1].event));
      EXPECT_EQ(again[2].place.position, x[2].place.position);
      // The density of a mirror's only event is that of following it.
      if (std::holds_alternative<Mirror<W>>(material)) {
        EXPECT_NEAR(space.follow_density(x, 1, Toward::sensor) / x[2].from_light, 1, 1e-12);
      }
    }
    EXPECT_GT(sampled, 500);
    EXPECT_TRUE(ended > 10 || material.index() != 0);  // where the two normals disagree
  }
}

}  // namespace
}  // namespace wander::test::shading_test

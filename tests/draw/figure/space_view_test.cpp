// The picture of a scene in space: points lie where the camera that renders has them, lines end at
// the eye, and outlines have the edges that they should have.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/rng.h"
#include "draw/figure/space_figure.h"
#include "draw/figure/stage.h"
#include "draw/figure/wireframe.h"
#include "scenes/format/build_scene.h"
#include "scenes/format/scene_file.h"
#include "tests/support/coloured_box.h"
#include "tests/support/space_scene_text.h"

namespace wander::figure {
namespace {

namespace d = description;

d::Camera oblique() {
  d::Camera camera;
  camera.position = {2, 1, 3};
  camera.target = {0.3, 0.6, -1};
  camera.up = {0.2, 1, 0.1};
  camera.fov_degrees = 50;
  camera.resolution = {40, 30};
  return camera;
}

// Against the camera of the renderer: film coordinates run from the top left.
TEST(View, HasPointsWhereTheCameraHasThem) {
  d::Scene scene = parse_scene(test::coloured_box_text, "box").scene;
  scene.camera = oblique();
  const auto built = build_scene<Spaceland>(scene);
  const Camera<Spaceland>& camera = *built->camera();
  const View view(oblique());
  Rng rng(3, Purpose::test, 0);
  int met = 0;
  for (int k = 0; k < 400; ++k) {
    const Spaceland::Point p(4 * rng.uniform() - 2, 4 * rng.uniform() - 2, 3 - 6 * rng.uniform());
    const auto film = camera.film_coordinate(camera.position, glm::normalize(p - camera.position));
    if (!film) continue;
    const auto spot = view(Place(p.x, p.y, p.z));
    ASSERT_TRUE(spot);
    EXPECT_NEAR(spot->x, (*film)[0], 1e-9);
    EXPECT_NEAR(spot->y, view.height() * (1 - (*film)[1]), 1e-9);
    ++met;
  }
  EXPECT_GT(met, 40);
}

TEST(View, LinesEndBeforeTheEye) {
  const View view(oblique());
  const Place ahead(0.3, 0.6, -1), behind(4, 1.5, 8), beside(5, 1, 6);
  EXPECT_FALSE(view(behind));
  EXPECT_FALSE(view.line(behind, beside));
  const auto piece = view.line(ahead, behind);
  ASSERT_TRUE(piece);
  EXPECT_NEAR(piece->from.x, 0.5, 1e-12);
  EXPECT_NEAR(piece->from.y, view.height() / 2, 1e-12);
  EXPECT_TRUE(std::isfinite(piece->to.x + piece->to.y));
  const auto turned = view.line(behind, ahead);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->to, piece->from);
  EXPECT_EQ(turned->from, piece->to);
}

// The last vertex of a path is the eye; one behind it parts the line.
TEST(View, PathsEndWhereTheyAreSeen) {
  const View view(oblique());
  const std::vector<double> seen{0, 0, -1, 0.5, 0.5, -1, 2, 1, 3};
  EXPECT_EQ(view.path(seen).size(), 2u);
  const std::vector<double> around{0, 0, -1, 4, 1.5, 8, 5, 1, 6, 0.5, 0.5, -1, 2, 1, 3};
  const std::vector<Vector> line = view.path(around);
  EXPECT_EQ(std::ranges::count_if(line, [](Vector v) { return std::isnan(v.x); }), 1);
  d::Camera lens = oblique();
  lens.aperture_radius = 0.2;
  const std::vector<double> by_lens{0, 0, -1, 0.5, 0.5, -1, 2.1, 1.1, 3};
  EXPECT_EQ(View(lens).path(by_lens).size(), 2u);
  EXPECT_GT(view.path(by_lens).size(), 2u);  // control: for a pinhole, that is no eye
}

TEST(View, WithoutACameraAllIsInThePicture) {
  d::Scene scene = parse_scene(test::grey_room(), "room").scene;
  scene.camera.reset();
  const SceneFaces faces = scene_faces(scene);
  const View view = view_of(scene, faces);
  for (const WireLine& line : wireframe(faces, view.eye()))
    for (const Place& end : {line.from, line.to}) {
      const auto spot = view(end);
      ASSERT_TRUE(spot);
      EXPECT_TRUE(spot->x > 0 && spot->x < 1 && spot->y > 0 && spot->y < view.height());
    }
}

template <class Kind>
d::Shape shape(const Kind& kind) {
  d::Shape made;
  made.kind = kind;
  return made;
}

std::size_t lines_of(const std::vector<d::Shape>& shapes, WireKind kind = WireKind::surface) {
  d::Scene scene;
  scene.dimension = 3;
  scene.materials = {{"glass", d::Dielectric{}}};
  scene.shapes = shapes;
  const auto lines = wireframe(scene_faces(scene), {0.5, 0.5, 9});
  return static_cast<std::size_t>(std::ranges::count(lines, kind, &WireLine::kind));
}

TEST(Wireframe, HasEdgesAndNoSeams) {
  const d::Parallelogram square{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}};
  EXPECT_EQ(lines_of({shape(square)}), 4u);
  const d::Triangle half{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}};
  const d::Triangle other{{{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};
  EXPECT_EQ(lines_of({shape(half)}), 3u);
  EXPECT_EQ(lines_of({shape(half), shape(other)}), 4u);  // without the diagonal
  const d::Triangle bent{{{{0, 0, 0}, {1, 1, 0}, {0, 1, 0.8}}}};
  EXPECT_EQ(lines_of({shape(half), shape(bent)}), 5u);
  const d::Parallelogram wall{{0, 0, 0}, {{{0, 0, 1}, {0, 1, 0}}}};
  EXPECT_EQ(lines_of({shape(square), shape(wall)}), 7u);  // they share one
}

TEST(Wireframe, TellsGlassLightsAndSensorsApart) {
  const d::Shape ball = shape(d::Sphere{{0, 0, 0}, 1, false});
  EXPECT_EQ(lines_of({ball}), 64u);
  d::Shape glass = ball, lamp = ball;
  glass.material = 0;
  EXPECT_EQ(lines_of({glass}, WireKind::glass), 64u);
  lamp.light.emplace().radiance.channels = {1, 1, 1};
  EXPECT_EQ(lines_of({lamp}, WireKind::light), 64u);
  d::Shape sensor = shape(d::Parallelogram{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}}}});
  sensor.sensor.emplace().resolution = {2, 2};
  EXPECT_EQ(lines_of({sensor}, WireKind::sensor), 4u);
}

// The rim of a ball is where lines from the eye touch it.
TEST(Wireframe, RimsAreTangent) {
  d::Scene scene;
  scene.dimension = 3;
  scene.shapes = {shape(d::Sphere{{1, 2, 3}, 0.7, false})};
  const Place eye(4, 1, -2), centre(1, 2, 3);
  for (const WireLine& line : wireframe(scene_faces(scene), eye)) {
    EXPECT_NEAR(glm::distance(line.from, centre), 0.7, 1e-12);
    EXPECT_NEAR(glm::dot(line.from - centre, line.from - eye), 0, 1e-12);
  }
}

TEST(SpaceFigure, IsDrawnWithItsLegend) {
  const d::Scene scene = parse_scene(test::grey_room(), "room").scene;
  const std::string svg = space_figure(scene);
  for (const char* part :
       {">small room<", "class=\"wireframe\"", ">glass<", ">light<", "edges of surfaces"})
    EXPECT_NE(svg.find(part), svg.npos) << part;
  EXPECT_EQ(svg.find(">sensor<"), svg.npos);
}

}  // namespace
}  // namespace wander::figure

// The scenes of three dimensions that come with the program: nothing in them is doubtful, their
// meshes come along, and what is known of a film exactly is what is computed.
//
// False alarms: 1e-9 per film.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <span>

#include "lab/engine.h"
#include "lab/method_check.h"
#include "lab/scene_source.h"
#include "scenes/format/mesh_file.h"
#include "tests/support/expect.h"
#include "tests/support/films.h"

namespace wander::test {
namespace {

std::vector<GalleryScene> scenes_of_space() {
  std::vector<GalleryScene> found;
  for (const GalleryScene& scene : std::span(gallery_scenes, gallery_scene_count))
    if (open_scene(std::string(gallery_prefix) + scene.name).scene.dimension == 3)
      found.push_back(scene);
  return found;
}

TEST(GalleryOfSpace, HasScenesWithoutADoubt) {
  const std::vector<GalleryScene> scenes = scenes_of_space();
  EXPECT_EQ(scenes.size(), 10u);
  for (const GalleryScene& scene : scenes) {
    const SceneDocument document = open_scene(std::string(gallery_prefix) + scene.name);
    EXPECT_EQ(document.scene.name, scene.name);
    EXPECT_TRUE(document.warnings.empty()) << scene.name << ": " << document.warnings[0].what;
  }
}

TEST(GalleryOfSpace, HasTheMeshesThatItsScenesName) {
  std::set<std::string> named;
  for (const GalleryScene& scene : scenes_of_space()) {
    const description::Scene described = open_scene(std::string(gallery_prefix) + scene.name).scene;
    std::set<std::string> files, listed;
    for (const description::Shape& shape : described.shapes)
      if (const auto* mesh = std::get_if<description::Mesh>(&shape.kind)) files.insert(mesh->file);
    for (const GalleryMesh& mesh : meshes_of(scene)) listed.insert(mesh.file);
    EXPECT_EQ(files, listed) << scene.name;
    named.merge(files);
  }
  EXPECT_EQ(named.size(), gallery_mesh_count);
}

// Those that no triangle on the other side goes along in the opposite direction.
std::size_t open_edges(const Triangles& triangles) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& [a, b, c] : triangles.corners)
    for (const auto& edge : {std::pair{a, b}, {b, c}, {c, a}}) ++edges[edge];
  std::size_t open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    open += count != 1 || back == edges.end() || back->second != 1;
  }
  return open;
}

double volume(const Triangles& triangles) {
  double sum = 0;
  for (const auto& corners : triangles.corners) {
    std::array<std::array<double, 3>, 3> p{};
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = triangles.points[static_cast<std::size_t>(corners[k])];
    for (std::size_t k = 0; k < 3; ++k)
      sum += p[0][k] *
             (p[1][(k + 1) % 3] * p[2][(k + 2) % 3] - p[1][(k + 2) % 3] * p[2][(k + 1) % 3]) / 6;
  }
  return sum;
}

// Shade and tube are open at both ends, and the water has a rim; the rest is closed, with its
// outside out.
TEST(GalleryOfSpace, HasMeshesWithoutHoles) {
  const std::map<std::string, std::size_t> rims{
      {"meshes/shade.obj", 96}, {"meshes/tube.obj", 96}, {"meshes/water.obj", 224}};
  for (const GalleryMesh& mesh : std::span(gallery_meshes, gallery_mesh_count)) {
    Triangles triangles = parse_obj(mesh.text);
    const auto rim = rims.find(mesh.file);
    const std::size_t open = rim == rims.end() ? 0 : rim->second;
    EXPECT_EQ(open_edges(triangles), open) << mesh.file;
    EXPECT_TRUE(open > 0 || volume(triangles) > 0) << mesh.file;
    triangles.corners.pop_back();
    EXPECT_NE(open_edges(triangles), open) << mesh.file;
  }
}

std::size_t triangles_of(const SceneDocument& document) {
  std::size_t count = 0;
  for (const description::Shape& shape : document.scene.shapes)
    if (const auto* mesh = std::get_if<description::Mesh>(&shape.kind))
      count += mesh->triangles->corners.size();
  return count;
}

// What a record keeps of a scene is its text, and where it came from.
TEST(GalleryOfSpace, IsOpenedAgainWithItsMeshes) {
  const std::string text = gallery_scene("ring").text, file = WANDER_SOURCE "/scenes/ring.json";
  EXPECT_EQ(triangles_of(reopen_scene(text, "gallery:ring")), 5760u);
  EXPECT_EQ(triangles_of(reopen_scene(text, file)), 5760u);
  EXPECT_THROW(reopen_scene(text, "-"), SceneFileError);
  EXPECT_THROW(reopen_scene(text, "elsewhere/ring.json"), SceneFileError);
}

// Of 4096 pixels hardly one is reliable after these samples, of 256 nearly all are.
TEST(GalleryOfSpace, HasFilmsThatAreCheckedInLargePixels) {
  Session session;
  session.budget = SampleBudget{400'000};
  session.threads = 2;
  const Job job(open_scene("gallery:furnace-sphere").scene, find_method("mlt"));
  for (const MethodCheck& check : check_methods(job, session, 1e-9, [] {})) {
    EXPECT_EQ(check.verdict, Verdict::passed) << check.method << ": " << check.reason;
    EXPECT_EQ(check.bins, 16u * 16u * 3u) << check.method;
  }
}

// L = (1 - ρ) (1 + ρ + … + ρ⁶), whatever is seen: paths of n vertices carry (1 - ρ) ρⁿ⁻².
class FurnaceSphere : public ::testing::TestWithParam<const char*> {
 protected:
  static FilmEstimate exact_film(std::size_t pixels, int reflections) {
    FilmEstimate exact;
    for (std::size_t i = 0; i < 3 * pixels; ++i)
      exact.value.push_back(1 - std::pow(std::array{0.5, 0.25, 0.75}[i % 3], reflections + 1));
    exact.standard_error.assign(3 * pixels, 0);
    exact.reliable.assign(3 * pixels, true);
    exact.degrees_of_freedom = 1;
    return exact;
  }
};

TEST_P(FurnaceSphere, HasTheFilmThatIsKnown) {
  description::Scene scene = open_scene("gallery:furnace-sphere").scene;
  scene.camera->resolution = {2, 2};
  Session session;
  session.budget = SampleBudget{60'000};
  session.threads = 2;
  const FilmEstimate film = render(Job(scene, find_method(GetParam())), session).film;
  FilmEstimate exact = exact_film(4, 6), shorter = exact_film(4, 0);
  exact.shape = shorter.shape = film.shape;
  EXPECT_TRUE(passes(films_agree(film, exact, 1e-9)));
  EXPECT_TRUE(rejects(films_agree(film, shorter, 1e-9)));
}

INSTANTIATE_TEST_SUITE_P(Methods, FurnaceSphere,
                         ::testing::Values("pt", "lt", "bdpt", "mlt", "pssmlt", "mmlt"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace wander::test

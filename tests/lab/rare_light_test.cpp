// Light that samples seldom find, in films of which chains have a part: what of it was missed is in no error bar.
#include <gtest/gtest.h>

#include <algorithm>

#include "lab/engine.h"
#include "lab/scene_source.h"

namespace wander::test {
namespace rare_light_test {
namespace {

// An open room with a mirrored ball, under a sun that is far away: the caustic of the ball is found only by paths from
// the camera that meet the sun by chance, behind a mirror, by technique (4, 0).
constexpr const char* sunny_room =
    R"({ "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 4,
  "materials": { "w": { "type": "diffuse", "reflectance": 0.6 }, "s": { "type": "mirror", "reflectance": 0.8 } },
  "shapes": [
    { "type": "parallelogram", "origin": [-1, 0, -1], "edges": [[0, 0, 2.5], [2, 0, 0]], "material": "w" },
    { "type": "parallelogram", "origin": [-1, 0, -1], "edges": [[2, 0, 0], [0, 2, 0]], "material": "w" },
    { "type": "parallelogram", "origin": [-1, 0, 1.5], "edges": [[0, 2, 0], [2, 0, 0]], "material": "w" },
    { "type": "parallelogram", "origin": [-1, 0, -1], "edges": [[0, 2, 0], [0, 0, 2.5]], "material": "w" },
    { "type": "parallelogram", "origin": [1, 0, -1], "edges": [[0, 0, 2.5], [0, 2, 0]], "material": "w" },
    { "type": "sphere", "center": [100000, 300000, 50000], "radius": 30000, "light": { "radiance": 20 } },
    { "type": "sphere", "center": [-0.6, 0.4, 0.3], "radius": 0.3, "material": "s" } ],
  "camera": { "type": "perspective", "position": [0.1, 1, 1.4], "target": [0, 0.5, -0.3], "up": [0, 1, 0],
              "fov_deg": 85, "resolution": [6, 5] } })";

Rendering rendering_of(const description::Scene& scene, std::string_view method,
                       std::uint64_t samples) {
  Session session;
  session.threads = 2;
  session.budget = SampleBudget{samples};
  return render({scene, find_method(method)}, session);
}
std::ptrdiff_t reliable_bins(const Rendering& rendering) {
  return std::ranges::count(rendering.film.reliable, true);
}
bool tells_of_techniques(const Rendering& rendering) {
  return std::ranges::any_of(rendering.warnings, [](const std::string& warning) {
    return warning.find("techniques (n, s)") != std::string::npos;
  });
}

// Of the pixels that 60 runs of mlt of 250 000 called reliable 0.93 lay inside their intervals.
TEST(RareLight, IsToldOfPooledFilmsToo) {
  const description::Scene scene = parse_scene(sunny_room, "room").scene;
  EXPECT_LE(reliable_bins(rendering_of(scene, "bdpt", 50'000)), 2);
  for (const char* method : {"bdpt", "mlt", "pssmlt", "mmlt"})
    EXPECT_TRUE(tells_of_techniques(rendering_of(scene, method, 250'000))) << method;
}

// Where all techniques are often seen, nothing is said of them.
TEST(RareLight, IsNotSeenWhereThereIsNone) {
  const description::Scene scene = open_scene("gallery:article-1").scene;
  for (const char* method : {"bdpt", "mlt", "pssmlt"}) {
    const Rendering rendering = rendering_of(scene, method, 400'000);
    EXPECT_GT(2 * reliable_bins(rendering), std::ssize(rendering.film.value)) << method;
    EXPECT_FALSE(tells_of_techniques(rendering)) << method;
  }
}

}  // namespace
}  // namespace rare_light_test
}  // namespace wander::test

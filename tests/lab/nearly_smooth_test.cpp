// Surfaces that are nearly smooth: connections hardly ever find their light, so a method that has nothing else makes no bin
// reliable, and is not held against the others, as where they are smooth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/requirements.h"
#include "lab/engine.h"
#include "lab/sample_doubts.h"
#include "scenes/format/build_scene.h"
#include "scenes/format/scene_file.h"

namespace wander::test::nearly_smooth_test {
namespace {

constexpr const char* camera = R"("camera": { "type": "perspective", "position": [0.5,0.5,2.2],
    "target": [0.5,0.5,0], "up": [0,1,0], "fov_deg": 42, "resolution": [6, 5] })";

// A ball of metal in a box with a lamp, before a camera.
description::Scene room(double roughness) {
  return parse_scene(fmt::format(R"({{
  "format": "wanderlight-scene/1", "dimension": 3, "name": "room", "max_vertices": 5,
  "materials": {{ "white": {{ "type": "diffuse", "reflectance": 0.7 }},
                 "metal": {{ "type": "rough_conductor", "roughness": {}, "reflectance": 0.9 }} }},
  "shapes": [
    {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[0,0,1],[1,0,0]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [0,1,0], "edges": [[1,0,0],[0,0,1]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[0,1,0],[0,0,1]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [1,0,0], "edges": [[0,0,1],[0,1,0]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[1,0,0],[0,1,0]], "material": "white" }},
    {{ "type": "sphere", "center": [0.5,0.4,0.4], "radius": 0.3, "material": "metal" }},
    {{ "type": "parallelogram", "origin": [0.3,0.98,0.3], "edges": [[0.4,0,0],[0,0,0.4]],
      "light": {{ "radiance": 8 }} }} ],
  {} }})",
                                 roughness, camera),
                     "room")
      .scene;
}

Rendering rendering_of(const char* method, double roughness) {
  Session session;
  session.threads = 2;
  session.budget = SampleBudget{100'000};
  return render({room(roughness), find_method(method)}, session);
}

// Light tracing sees half of this film or less: of a hundred thousand connections no lobe below a ten thousandth of all directions
// gets ten.
TEST(NearlySmooth, SurfacesMakeNoBinOfLightTracingReliable) {
  for (const double roughness : {1e-6, 1e-3, 0.009}) {
    const Rendering r = rendering_of("lt", roughness);
    EXPECT_EQ(std::ranges::count(r.film.reliable, true), 0) << roughness;
    ASSERT_FALSE(r.warnings.empty()) << roughness;
    EXPECT_NE(r.warnings.back().find("nearly"), std::string::npos) << r.warnings.back();
  }
  const Rendering of_pt = rendering_of("pt", 1e-6);
  EXPECT_GT(std::ranges::count(of_pt.film.reliable, true), 15) << "it meets the lamp";
}

TEST(NearlySmooth, SurfacesAreNoMatterWhereManyConnectionsFindThem) {
  const Rendering r = rendering_of("lt", 0.3);
  EXPECT_GT(std::ranges::count(r.film.reliable, true), 15);
  EXPECT_TRUE(r.warnings.empty());
}

// Of what a method does not see it is no reference, and no check.
TEST(NearlySmooth, SurfacesBlindLightTracingBeforeACamera) {
  const Method& lt = find_method("lt");
  EXPECT_FALSE(lt.sees_all_light(room(1e-3)));
  EXPECT_TRUE(lt.sees_all_light(room(2e-3)));
  EXPECT_TRUE(find_method("bdpt").sees_all_light(room(1e-6)));
}

// The scene that is rendered says the same of its lobes as its description does.
TEST(NearlySmooth, LobesAreThoseOfTheDescription) {
  for (const double roughness : {1e-6, 0.2})
    EXPECT_DOUBLE_EQ(build_scene<Spaceland>(room(roughness))->narrowest_lobe(),
                     requires_of(room(roughness)).narrowest_lobe);
}

}  // namespace
}  // namespace wander::test::nearly_smooth_test

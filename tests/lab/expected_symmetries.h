// What may not change a bit of a film of the gallery, by every method.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lab/scene_source.h"
#include "lab/symmetries.h"

namespace wander::test {

inline description::Scene scene_named(const std::string& name) {
  description::Scene scene = open_scene("gallery:" + name).scene;
  if (scene.camera && scene.dimension == 3) scene.camera->resolution = {12, 9};
  return scene;
}

// Meshes of metal.
inline description::Scene ring_behind_a_lens() {
  description::Scene scene = scene_named("ring");
  scene.camera->aperture_radius = 0.02;
  scene.camera->focus_distance = 0.7;
  return scene;
}

inline std::vector<SymmetryCheck> checks_of(const description::Scene& scene,
                                            const std::vector<Variation>& variations) {
  Session session;
  session.budget = SampleBudget{1000};
  return check_symmetries(Job(scene, reference_method()), variations, session, [] {});
}

inline void expect_symmetries(const description::Scene& scene,
                              const std::vector<Variation>& variations) {
  std::size_t same = 0;
  for (const SymmetryCheck& check : checks_of(scene, variations)) {
    EXPECT_NE(check.verdict, SymmetryVerdict::differs)
        << check.method << " in " << name_of(check.precision) << ", " << check.variation << ": "
        << check.difference;
    // What is beyond single precision is said to be.
    if (check.precision == Precision::of_double) {
      EXPECT_EQ(check.verdict, SymmetryVerdict::same) << check.reason;
    }
    if (check.verdict == SymmetryVerdict::same) ++same;
  }
  EXPECT_GE(same, (std::max(variations.size(), std::size_t{3}) - 2) * (checked_methods().size() + 1));
}

}  // namespace wander::test

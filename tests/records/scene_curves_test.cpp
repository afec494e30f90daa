// The recorded geometry of scenes: the names of materials.
#include "records/scene_curves.h"

#include <gtest/gtest.h>

#include "core/requirements.h"
#include "records/scene_faces.h"
#include "tests/support/core_scenes.h"

namespace wander::test {
namespace {

const description::Quantity one{{1, 1, 1}, false};

// Of every material there is, the number of its type.
TEST(RecordedMaterials, AreCalledAsInSceneFiles) {
  const std::vector<std::pair<description::MaterialKind, std::string>> all{
      {description::Black{}, "black"},
      {description::Diffuse{one}, "diffuse"},
      {description::Mirror{one}, "mirror"},
      {description::Dielectric{}, "dielectric"},
      {description::RoughConductor{0.1, one}, "rough_conductor"},
      {description::RoughDielectric{}, "rough_dielectric"},
      {description::Conductor{one, one}, "conductor"},
      {description::RoughMetal{0.1, one, one}, "rough_conductor"}};
  ASSERT_EQ(all.size(), std::variant_size_v<description::MaterialKind>);
  SceneMaker flat(4);
  description::Scene space;
  space.dimension = 3;
  for (const auto& [kind, name] : all) {
    const std::size_t material = flat.material(kind);
    flat.segment({0, 0}, {1, 0}, {material});
    space.materials.push_back({name, kind});
    description::Shape& shape = space.shapes.emplace_back();
    shape.kind = description::Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    shape.material = material;
  }
  const SceneCurves curves = scene_curves(flat.description());
  const SceneFaces faces = scene_faces(space);
  ASSERT_EQ(curves.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(material_types.at(static_cast<std::size_t>(curves.material[i])), all[i].second);
    EXPECT_EQ(material_types.at(static_cast<std::size_t>(faces.material[i])), all[i].second);
  }
  flat.segment({0, 0}, {1, 0});
  EXPECT_EQ(scene_curves(flat.description()).material.back(), 0);  // without a material: black
}

}  // namespace
}  // namespace wander::test

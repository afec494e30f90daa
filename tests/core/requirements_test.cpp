#include "core/requirements.h"

#include <gtest/gtest.h>

namespace wander::requirements_test {
namespace {

using description::Scene;

// A lamp, a wall of one material and a sensor.
Scene scene_with(description::MaterialKind material) {
  Scene scene;
  scene.materials = {{"unused", description::Dielectric{}}, {"wall", std::move(material)}};
  scene.shapes.resize(3);
  scene.shapes[0].light.emplace();
  scene.shapes[1].kind = description::Circle{};
  scene.shapes[1].material = 1;
  scene.shapes[2].sensor = description::Sensor{{8}};
  return scene;
}

description::Quantity grey(double value) { return {{value, value, value}, false}; }

TEST(Requirements, OnlyMaterialsThatShapesWearCount) {
  const Requirements needs = requires_of(scene_with(description::Diffuse{grey(0.5)}));
  EXPECT_EQ(needs.materials, std::vector<std::string>{"diffuse"});
  EXPECT_EQ(needs.shapes, (std::vector<std::string>{"circle", "segment"}));
  EXPECT_FALSE(needs.specular);
  EXPECT_FALSE(needs.caustic_paths_possible);
}

TEST(Requirements, AMirrorOrAnInterfaceIsSpecularAndMakesCaustics) {
  for (const description::MaterialKind& kind :
       {description::MaterialKind(description::Mirror{grey(0.9)}),
        description::MaterialKind(description::Dielectric{})}) {
    const Requirements needs = requires_of(scene_with(kind));
    EXPECT_TRUE(needs.specular);
    EXPECT_TRUE(needs.caustic_paths_possible);
  }
}

TEST(Requirements, AMirrorThatReflectsNothingIsNotSpecular) {
  EXPECT_FALSE(requires_of(scene_with(description::Mirror{grey(0)})).specular);
}

TEST(Requirements, TheNarrowestLobeIsOfRoughnessByDimension) {
  const auto narrowest = [](description::MaterialKind kind, int dimension) {
    Scene scene = scene_with(std::move(kind));
    scene.dimension = dimension;
    return requires_of(scene).narrowest_lobe;
  };
  const description::RoughConductor rough{0.01, grey(0.9)};
  const description::RoughDielectric glass{0.25};
  EXPECT_DOUBLE_EQ(narrowest(rough, 2), 0.01);
  EXPECT_DOUBLE_EQ(narrowest(rough, 3), 1e-4);
  EXPECT_DOUBLE_EQ(narrowest(glass, 3), 0.0625);
  EXPECT_EQ(narrowest(description::RoughConductor{0.01, grey(0)}, 3), 1) << "it is black";
  EXPECT_EQ(narrowest(description::Mirror{grey(0.9)}, 3), 0);
  EXPECT_EQ(narrowest(description::Mirror{grey(0)}, 3), 1);
  EXPECT_EQ(narrowest(description::Diffuse{grey(0.9)}, 3), 1);
}

TEST(Requirements, OfConductorsAreThoseOfMirrorsAndRoughMetals) {
  const description::Quantity eta = grey(0.2), k = grey(3.9), coloured{{3.9, 2.4, 2.1}, true};
  const Requirements smooth = requires_of(scene_with(description::Conductor{eta, k}));
  EXPECT_EQ(smooth.materials, std::vector<std::string>{"conductor"});
  EXPECT_TRUE(smooth.specular);
  EXPECT_TRUE(smooth.caustic_paths_possible);
  EXPECT_FALSE(smooth.scatters);
  EXPECT_EQ(smooth.colour_channels, 1);
  const Requirements rough = requires_of(scene_with(description::RoughMetal{0.2, eta, coloured}));
  EXPECT_EQ(rough.materials, std::vector<std::string>{"rough_conductor"});
  EXPECT_FALSE(rough.specular);
  EXPECT_TRUE(rough.scatters);
  EXPECT_TRUE(rough.glossy);
  EXPECT_EQ(rough.colour_channels, 3);
  // As the air around it: nothing comes back.
  EXPECT_FALSE(requires_of(scene_with(description::Conductor{grey(1), grey(0)})).specular);
  EXPECT_FALSE(requires_of(scene_with(description::RoughMetal{0.2, grey(1), grey(0)})).glossy);
}

TEST(Requirements, ACausticNeedsAVertexBetweenLightAndSensor) {
  Scene scene = scene_with(description::Mirror{grey(0.9)});
  scene.max_vertices = 2;
  EXPECT_TRUE(requires_of(scene).specular);
  EXPECT_FALSE(requires_of(scene).caustic_paths_possible);
}

TEST(Requirements, ACameraSeesACausticOnlyOnASurfaceThatScatters) {
  Scene scene = scene_with(description::Mirror{grey(0.9)});
  scene.shapes[2].sensor.reset();
  scene.camera.emplace();
  EXPECT_FALSE(requires_of(scene).caustic_paths_possible);
  scene.materials.push_back({"floor", description::Diffuse{grey(0.5)}});
  scene.shapes[2].material = 2;
  EXPECT_TRUE(requires_of(scene).caustic_paths_possible);
  scene.max_vertices = 3;
  EXPECT_FALSE(requires_of(scene).caustic_paths_possible);
}

TEST(Requirements, OneColouredNumberMakesThreeChannels) {
  Scene scene = scene_with(description::Diffuse{grey(0.5)});
  EXPECT_EQ(requires_of(scene).colour_channels, 1);
  scene.shapes[0].light->radiance.coloured = true;
  EXPECT_EQ(requires_of(scene).colour_channels, 3);
}

TEST(Requirements, GlossIsRoughnessThatReflectsOrRefracts) {
  EXPECT_TRUE(requires_of(scene_with(description::RoughConductor{0.1, grey(0.9)})).glossy);
  EXPECT_FALSE(requires_of(scene_with(description::RoughConductor{0.1, grey(0)})).glossy);
  EXPECT_FALSE(requires_of(scene_with(description::Diffuse{grey(0.5)})).glossy);
  EXPECT_TRUE(requires_of(scene_with(description::Diffuse{grey(0.5)})).scatters);
}

}  // namespace
}  // namespace wander::requirements_test

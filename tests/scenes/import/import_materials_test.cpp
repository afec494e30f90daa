// The bsdfs of Mitsuba and what becomes of them.
#include "scenes/import/optical_constants.h"
#include "tests/scenes/import/import_folder.h"

namespace wander::test {
namespace {

class ImportedBsdfs : public ImportFolder {
 protected:
  // That of the first shape.
  static Json material(const Json& scene) {
    return scene["materials"][scene["shapes"][0]["material"].get<std::string>()];
  }
  Json exactly(const std::string& bsdf) const { return material(exact(ball_of(bsdf))); }
  Json nearly(const std::string& bsdf, const std::string& words) const {
    return material(approximate(ball_of(bsdf), words));
  }
};

Json parsed(const char* text) { return Json::parse(text); }

TEST_F(ImportedBsdfs, AreExactWhereTheyCanBe) {
  EXPECT_EQ(exactly("<bsdf type='diffuse'><rgb name='reflectance' value='0.1, 0.2 0.3'/></bsdf>"),
            parsed(R"({"type": "diffuse", "reflectance": [0.1, 0.2, 0.3]})"));
  EXPECT_EQ(exactly("<bsdf type='diffuse'/>"),
            parsed(R"({"type": "diffuse", "reflectance": 0.5})"));
  EXPECT_EQ(exactly("<bsdf type='twosided'><bsdf type='diffuse'><float name='reflectance' "
                    "value='0.25'/></bsdf></bsdf>"),
            parsed(R"({"type": "diffuse", "reflectance": 0.25})"));
  EXPECT_EQ(exactly("<bsdf type='conductor'><string name='material' value='none'/><rgb "
                    "name='specular_reflectance' value='0.9,0.8,0.7'/></bsdf>"),
            parsed(R"({"type": "mirror", "reflectance": [0.9, 0.8, 0.7]})"));
  EXPECT_EQ(exactly("<bsdf type='conductor'/>"),
            parsed(R"({"type": "mirror", "reflectance": 1.0})"));
  EXPECT_EQ(exactly("<bsdf type='dielectric'/>"),
            parsed(R"({"type": "dielectric", "ior": 1.5046, "exterior_ior": 1.000277})"));
  EXPECT_EQ(exactly("<bsdf type='dielectric'><string name='int_ior' value='Water'/><float "
                    "name='ext_ior' value='1'/></bsdf>"),
            parsed(R"({"type": "dielectric", "ior": 1.333})"));
}

TEST_F(ImportedBsdfs, OfAShapeWithoutOneAreHalfGreyAndOfALampBlack) {
  const Json scene = exact(scene_of("<shape type='sphere'/>"));
  EXPECT_EQ(material(scene), parsed(R"({"type": "diffuse", "reflectance": 0.5})"));
  EXPECT_FALSE(scene["shapes"][1].contains("material"));
  EXPECT_EQ(scene["shapes"][1]["light"], parsed(R"({"radiance": 1.0})"));
}

TEST_F(ImportedBsdfs, AreNamedByTheirIdsAndEqualOnesAreOne) {
  const std::string grey = "<bsdf type='diffuse'><float name='reflectance' value='0.2'/></bsdf>";
  const Json scene = exact(scene_of(
      "<bsdf type='diffuse' id='white'><float name='reflectance' value='0.9'/></bsdf>"
      "<shape type='sphere'><ref id='white'/></shape><shape type='sphere'>" +
      grey +
      "<transform name='to_world'><translate x='4'/></transform></shape><shape type='sphere'>" +
      grey + "<transform name='to_world'><translate x='-4'/></transform></shape>"));
  EXPECT_EQ(scene["materials"].size(), 2u);
  EXPECT_EQ(scene["shapes"][0]["material"], "white");
  EXPECT_EQ(scene["shapes"][1]["material"], "diffuse");
  EXPECT_EQ(scene["shapes"][2]["material"], "diffuse");
}

// The masking of the two programs differs, which is told, but is no fault.
TEST_F(ImportedBsdfs, OfRoughGgxSayThatMaskingDiffers) {
  const ImportedScene imported = scene(ball_of(
      "<bsdf type='roughconductor'><string name='distribution' value='ggx'/><float name='alpha' "
      "value='0.3'/></bsdf>"));
  ASSERT_EQ(imported.approximations.size(), 1u);
  EXPECT_SAYS(imported.approximations[0].what, "separable in Mitsuba");
  EXPECT_EQ(material(Json::parse(imported.text)),
            parsed(R"({"type": "rough_conductor", "roughness": 0.3, "reflectance": 1.0})"));
}

TEST_F(ImportedBsdfs, AreTheNearestThingWhereTheyCannotBeSaid) {
  EXPECT_EQ(nearly("<bsdf type='roughdielectric'><float name='alpha' value='0.2'/><float "
                   "name='int_ior' value='1.5'/><float name='ext_ior' value='1'/></bsdf>",
                   "a Beckmann lobe"),
            parsed(R"({"type": "rough_dielectric", "roughness": 0.2, "ior": 1.5})"));
  EXPECT_EQ(nearly("<bsdf type='roughconductor'><string name='distribution' value='ggx'/><float "
                   "name='alpha_u' value='0.1'/><float name='alpha_v' value='0.4'/></bsdf>",
                   "an anisotropic lobe")["roughness"],
            0.2);
  for (const char* type : {"plastic", "roughplastic"})
    EXPECT_EQ(nearly(std::string("<bsdf type='") + type +
                         "'><rgb name='diffuse_reflectance' value='0.1,0.2,0.3'/></bsdf>",
                     std::string("a ") + type),
              parsed(R"({"type": "diffuse", "reflectance": [0.1, 0.2, 0.3]})"));
  EXPECT_EQ(
      nearly("<bsdf type='mask'><float name='opacity' value='0.9'/><bsdf type='diffuse'/></bsdf>",
             "a mask")["type"],
      "diffuse");
}

TEST_F(ImportedBsdfs, OfMetalsHaveTheirIndexOfRefraction) {
  const Json gold = exactly("<bsdf type='conductor'><string name='material' value='Au'/></bsdf>");
  EXPECT_EQ(gold["type"], "conductor");
  expect_near(gold["eta"], {0.143036, 0.375307, 1.44205}, 1e-4);  // of Mitsuba 3.9
  expect_near(gold["k"], {3.983, 2.38556, 1.60336}, 1e-4);
  EXPECT_EQ(exactly("<bsdf type='conductor'><rgb name='eta' value='0.2,0.9,1.1'/><float name='k' "
                    "value='3'/></bsdf>"),
            parsed(R"({"type": "conductor", "eta": [0.2, 0.9, 1.1], "k": 3.0})"));
  const ImportedScene rough = scene(ball_of(
      "<bsdf type='roughconductor'><string name='distribution' value='ggx'/><float name='alpha' "
      "value='0.3'/><float name='eta' value='0.5'/><float name='k' value='2'/></bsdf>"));
  EXPECT_EQ(material(Json::parse(rough.text)),
            parsed(R"({"type": "rough_conductor", "roughness": 0.3, "eta": 0.5, "k": 2.0})"));
}

// Numbers of matter are no light: one value is the same in all channels, and what may be above 1 is not cut (0.1998 and 3.996
// of Mitsuba 3.9).
TEST_F(ImportedBsdfs, OfMetalsHaveSpectraOfMatter) {
  const Json grey = exactly(
      "<bsdf type='conductor'><spectrum name='eta' value='0.2'/><spectrum name='k' "
      "value='4'/></bsdf>");
  EXPECT_EQ(grey, parsed(R"({"type": "conductor", "eta": 0.2, "k": 4.0})"));
  const Json listed = nearly(
      "<bsdf type='conductor'><spectrum name='eta' value='300:0.2, 900:0.2'/><spectrum name='k' "
      "value='300:4, 900:4'/></bsdf>",
      "a spectrum over wavelengths");
  // Three channels or, where rounding leaves them the same, one.
  const auto channels = [](const Json& value) {
    return value.is_array() ? value : Json{value, value, value};
  };
  expect_near(channels(listed["eta"]), {0.2, 0.2, 0.2}, 1e-3);
  expect_near(channels(listed["k"]), {4, 4, 4}, 0.02);
}

// A tint has no place beside eta and k: the reflectance is then that along the normal.
TEST_F(ImportedBsdfs, OfTintedMetalsHaveTheirReflectanceAlongTheNormal) {
  const Json gold = nearly(
      "<bsdf type='conductor'><string name='material' value='Au'/><rgb name='specular_reflectance' "
      "value='0.5,1,1'/></bsdf>",
      "Fresnel's factor of a metal with a tint");
  EXPECT_EQ(gold["type"], "mirror");
  // ((n - 1)² + k²) / ((n + 1)² + k²) of 0.143036 + 3.983 i and so on
  expect_near(gold["reflectance"], {0.4833, 0.8020, 0.3241}, 1e-3);
  EXPECT_DOUBLE_EQ(normal_reflectance({{1.5, 1.5, 1.5}, {0, 0, 0}})[1], 0.04);
}

TEST_F(ImportedBsdfs, OfVersion06AreTheSameUnderTheirOldNames) {
  EXPECT_EQ(
      exactly("<bsdf type='dielectric'><float name='intIOR' value='1.5'/><string name='extIOR' "
              "value='air'/></bsdf>"),
      parsed(R"({"type": "dielectric", "ior": 1.5, "exterior_ior": 1.000277})"));
  const auto old = [&](const std::string& bsdf) {
    return material(exact("<scene version='0.6.0'><shape type='sphere'>" + bsdf + "</shape>" +
                          lamp_and_camera + "</scene>"));
  };
  // Its metal is copper unless it says otherwise, and air has an index.
  expect_near(old("<bsdf type='conductor'/>")["k"], {3.9122, 2.4524, 2.1415}, 1e-4);
  EXPECT_DOUBLE_EQ(old("<bsdf type='conductor'><float name='eta' value='1'/><float name='k' "
                       "value='3'/><float name='extEta' value='1.5'/></bsdf>")["k"],
                   2);
}

TEST_F(ImportedBsdfs, ThatLetLightPassAreLeftOut) {
  const std::string pane = scene_of("<shape type='sphere'><bsdf type='thindielectric'/></shape>");
  EXPECT_EQ(approximate(pane, "a thin pane of glass")["shapes"].size(), 1u);
  EXPECT_EQ(exact(scene_of("<shape type='sphere'><bsdf type='null'/></shape>"))["shapes"].size(),
            1u);
}

TEST_F(ImportedBsdfs, OnLampsThatCannotBeAreRefused) {
  const std::string glowing =
      scene_of("<shape type='sphere'><bsdf type='dielectric'/><emitter type='area'/></shape>");
  EXPECT_FALSE(approximate(glowing, "a light on glass")["shapes"][0].contains("material"));
}

// Mitsuba's diffuse is black from behind; here it is not.  That matters only where it can be seen.
TEST_F(ImportedBsdfs, WithABlackBackMatterWhereTheBackCanBeSeen) {
  const std::string words = "black from behind";
  const std::string away = "<transform name='to_world'><rotate x='1' angle='180'/></transform>";
  EXPECT_EQ(exact(scene_of("<shape type='rectangle'/>"))["shapes"].size(), 2u);
  approximate(scene_of("<shape type='rectangle'>" + away + "</shape>"), words);
  exact(scene_of("<shape type='rectangle'>" + away +
                 "<bsdf type='twosided'><bsdf type='diffuse'/></bsdf></shape>"));
  exact(scene_of("<shape type='rectangle'>" + away +
                 "<bsdf type='diffuse'><float name='reflectance' value='0'/></bsdf></shape>"));
  // Something else is behind it.
  approximate(scene_of("<shape type='rectangle'/><shape type='sphere'><float name='radius' "
                       "value='0.1'/><point name='center' x='0' y='0' z='-1'/></shape>"),
              words);
  // What is closed is seen from behind only from inside: here by the camera, or by a ball in it.
  exact(scene_of("<shape type='cube'/>"));
  approximate(
      scene_of("<shape type='cube'><transform name='to_world'><scale value='12'/></transform>"
               "</shape>"),
      words);
  exact(
      scene_of("<shape type='cube'><boolean name='flip_normals' value='true'/><transform "
               "name='to_world'><scale value='30'/></transform></shape>"));
  approximate(scene_of("<shape type='sphere'><float name='radius' value='2'/></shape><shape "
                       "type='sphere'/>"),
              words);
}

TEST_F(ImportedBsdfs, ThatAreNotKnownAreRefusedWithWhatIs) {
  EXPECT_SAYS(refused(ball_of("<bsdf type='difuse'/>")), "did you mean \"diffuse\"?");
  EXPECT_SAYS(refused(ball_of("<bsdf type='diffuse'><float name='reflectence' value='1'/></bsdf>")),
              "did you mean \"reflectance\"?");
  EXPECT_SAYS(
      refused(ball_of("<bsdf type='dielectric'><string name='int_ior' value='bk8'/></bsdf>")),
      "did you mean \"bk7\"?");
  EXPECT_SAYS(refused(ball_of("<bsdf type='conductor'><string name='material' value='Unobtainium'/>"
                              "</bsdf>")),
              "the metal \"Unobtainium\" is not known");
  EXPECT_SAYS(
      refused(ball_of("<bsdf type='roughconductor'><float name='alpha' value='0'/></bsdf>")),
      "alpha is > 0");
  EXPECT_SAYS(refused(ball_of("<bsdf type='dielectric'><float name='int_ior' value='-1'/></bsdf>")),
              "> 0");
}

}  // namespace
}  // namespace wander::test

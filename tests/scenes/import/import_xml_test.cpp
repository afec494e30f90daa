// The XML of Mitsuba: parameters, includes and references, places of faults, and hostile files.
#include <fmt/format.h>

#include "tests/scenes/import/import_folder.h"

namespace wander::test {
namespace {

class ImportedXml : public ImportFolder {
 protected:
  std::string first_radius(const std::string& xml, const XmlParameters& parameters = {}) const {
    return Json::parse(scene(xml, Fidelity::exact, parameters).text)["shapes"][0]["radius"].dump();
  }
  static std::string ball(const std::string& radius) {
    return "<shape type='sphere'><float name='radius' value='" + radius + "'/></shape>";
  }
};

TEST_F(ImportedXml, HasParametersWithDefaults) {
  const std::string xml = scene_of("<default name='r' value='2'/>" + ball("$r"));
  EXPECT_EQ(first_radius(xml), "2.0");
  EXPECT_EQ(first_radius(xml, {{"r", "3"}}), "3.0");
  EXPECT_EQ(first_radius(scene_of(ball("$r")), {{"r", "3"}}), "3.0");
  EXPECT_EQ(first_radius(scene_of("<default name='a' value='1'/><default name='ab' value='2'/>" +
                                  ball("$a.$ab"))),
            "1.2");
  EXPECT_EQ(first_radius(scene_of("<default name='a' value='1.'/>" + ball("$a5"))), "1.5");
  EXPECT_EQ(first_radius(scene_of("<default name='a' value='1'/><default name='b' value='$a'/>" +
                                  ball("$b"))),
            "1.0");
}

// Each doubles the one before: a kilobyte would be gigabytes.
TEST_F(ImportedXml, ValuesThatGrowWithEachParameterEndSomewhere) {
  std::string xml = "<default name='a0' value='1111111111'/>";
  for (int k = 1; k < 40; ++k)
    xml += fmt::format("<default name='a{}' value='$a{}$a{}'/>", k, k - 1, k - 1);
  EXPECT_NE(refused(scene_of(xml + ball("1"))).find("too large with the values of its parameters"),
            std::string::npos);
}

TEST_F(ImportedXml, WithoutAValueForAParameterSaysHowToGiveIt) {
  EXPECT_SAYS(said(scene_of(ball("$r"))), "say -D r=VALUE");
  try {
    scene(scene_of(""), Fidelity::exact, {{"spp", "4"}});
    FAIL();
  } catch (const ImportError& error) {
    EXPECT_SAYS(words(error.faults), "-D spp: the scene has no $spp");
  }
}

TEST_F(ImportedXml, OfWhatIsNoSceneIsRefusedWithParametersAsWithout) {
  const XmlParameters parameters{{"spp", "4"}};
  for (const std::string text : {"", "<html/>", "<scene>", "{}"}) {
    std::string without;
    for (const XmlParameters& given : {XmlParameters{}, parameters}) try {
        scene(text, Fidelity::exact, given);
        FAIL() << text;
      } catch (const ImportError& error) {
        if (given.empty())
          without = words(error.faults);
        else
          EXPECT_EQ(words(error.faults), without) << text;
      }
  }
  EXPECT_THROW(
      import_mitsuba({"no/such.xml", "scene", "scene-meshes", parameters, Fidelity::exact}),
      ImportError);
}

TEST_F(ImportedXml, IncludesFiles) {
  write("parts/ball.xml", "<scene version='3.0.0'>" + ball("$r") + "</scene>");
  EXPECT_EQ(
      first_radius(scene_of("<default name='r' value='4'/><include filename='parts/ball.xml'/>")),
      "4.0");
  write("deep/ball.xml", "<scene version='3.0.0'>" + ball("5") + "</scene>");
  EXPECT_EQ(first_radius(scene_of("<path value='deep'/><include filename='ball.xml'/>")), "5.0");
  EXPECT_SAYS(said(scene_of("<include filename='none.xml'/>")), "there is no file none.xml");
}

TEST_F(ImportedXml, TellsFaultsOfIncludedFilesInThem) {
  write("part.xml", "<scene version='3.0.0'>\n\n  <shape type='sfere'/>\n</scene>");
  const auto found = faults(scene_of("<include filename='part.xml'/>"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(fs::path(found[0].file).filename(), "part.xml");
  EXPECT_EQ(found[0].line, 3);
  EXPECT_EQ(found[0].column, 3);
}

TEST_F(ImportedXml, RefersForwardsAndBackwards) {
  const Json json = exact(
      scene_of("<shape type='sphere'><ref id='later'/></shape>"
               "<bsdf type='diffuse' id='later'><float name='reflectance' value='0.1'/></bsdf>"
               "<alias id='later' as='other'/><shape type='sphere'><transform "
               "name='to_world'><translate x='5'/>"
               "</transform><ref id='other' name='bsdf'/></shape>"));
  EXPECT_EQ(json["shapes"][0]["material"], "later");
  EXPECT_EQ(json["shapes"][1]["material"], "later");
  EXPECT_SAYS(
      said(scene_of(
          "<bsdf type='diffuse' id='white'/><shape type='sphere'><ref id='whit'/></shape>")),
      "did you mean \"white\"?");
  EXPECT_SAYS(said(scene_of("<bsdf type='diffuse' id='a'/><bsdf type='diffuse' id='a'/>")),
              "another object with the id a");
}

// ---- places

TEST_F(ImportedXml, TellsAllFaultsWithTheirPlaces) {
  const auto found = faults(
      "<scene version='3.0.0'>\n"
      "  <!-- a comment -->\n"
      "  <shape type='sphere'><float name='radius' value='x'/></shape>\n"
      "  <shape type='sphere'>\n"
      "    <bsdf type='diffuse'><rgb name='reflectance'\n"
      "                              value='2'/></bsdf>\n"
      "    \xC3\xA4<!-- text, of two bytes --><bsdf type='shiny'/>\n"
      "  </shape>\n" +
      lamp_and_camera + "</scene>");
  ASSERT_EQ(found.size(), 4u) << words(found);
  const auto place = [&](std::size_t i) {
    return fmt::format("{}:{} {}", found[i].line, found[i].column, found[i].path);
  };
  EXPECT_EQ(place(0), "3:24 /scene/shape[1]/float");
  EXPECT_EQ(place(1), "4:3 /scene/shape[2]");  // text
  EXPECT_EQ(place(2), "5:26 /scene/shape[2]/bsdf[1]/rgb");
  EXPECT_EQ(place(3), "7:33 /scene/shape[2]/bsdf[2]");  // one bsdf too many
  EXPECT_EQ(line_of(found[0]),
            (place_ / "scene.xml").string() +
                ":3:24: /scene/shape[1]/float: radius is \"x\"; it is a finite number");
}

TEST_F(ImportedXml, FindsWhatIsNotKnown) {
  EXPECT_SAYS(said(scene_of("<shape type='sphere'><float name='radios' value='1'/></shape>")),
              "did you mean \"radius\"?");
  EXPECT_SAYS(said(scene_of("<shape type='sphere'><string name='radius' value='1'/></shape>")),
              "radius is a <string>; it is given by <float> or <integer>");
  EXPECT_SAYS(said(scene_of("<luminaire type='area'/>")), "<luminaire> is not known in a scene");
  EXPECT_SAYS(said(scene_of("<shape type='sphere'><luminaire type='area'/></shape>")),
              "<luminaire> is not known in a shape \"sphere\"");
  EXPECT_SAYS(
      said(scene_of("<shape type='sphere'><float name='radius' value='1'/><float name='radius' "
                    "value='1'/></shape>")),
      "radius is given twice");
}

// ---- hostile files

TEST_F(ImportedXml, ThatIsNoneIsRefusedWithItsPlace) {
  const auto found = faults("<scene version='3.0.0'>\n<shape></scene>");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].line, 2);
  EXPECT_SAYS(found[0].what, "this is no XML");
  EXPECT_SAYS(said(""), "this is no XML");
  EXPECT_SAYS(said("\x1f\x8b\x08"), "this is no XML");
  EXPECT_SAYS(said("<html/>"), "outermost element is <scene>");
  EXPECT_SAYS(said(std::string("<scene version='\xff\xfe'/>")), "UTF-8");
  EXPECT_THROW(import_mitsuba({place_ / "none.xml", "", "m"}), ImportError);
  EXPECT_THROW(import_mitsuba({place_, "", "m"}), ImportError);
}

TEST_F(ImportedXml, OfAnyDepthIsRefused) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "<bsdf type='twosided'>";
    for (int i = 0; i < depth; ++i) text += "</bsdf>";
    return scene_of(text);
  };
  EXPECT_SAYS(said(nested(70)), "more than 64 deep");
  EXPECT_SAYS(said(nested(100000)), "more than 64 deep");
}

TEST_F(ImportedXml, ThatGoesInCirclesIsRefused) {
  write("a.xml", "<scene version='3.0.0'><include filename='scene.xml'/></scene>");
  EXPECT_SAYS(said(scene_of("<include filename='a.xml'/>")), "includes itself");
  EXPECT_SAYS(said(scene_of("<bsdf type='twosided' id='a'><ref id='a'/></bsdf>")), "in a circle");
  EXPECT_SAYS(said(scene_of("<bsdf type='twosided' id='a'><ref id='b'/></bsdf>"
                            "<bsdf type='twosided' id='b'><ref id='a'/></bsdf>")),
              "in a circle");
  EXPECT_SAYS(
      said(scene_of("<texture type='checkerboard' id='t'><ref name='color0' id='t'/></texture>"
                    "<shape type='sphere'><bsdf type='diffuse'><ref name='reflectance' id='t'/>"
                    "</bsdf></shape>")),
      "in a circle");
  std::string chain;
  for (int i = 0; i < 3000; ++i)
    chain += fmt::format("<bsdf type='twosided' id='b{}'><ref id='b{}'/></bsdf>", i, i + 1);
  EXPECT_SAYS(said(scene_of(chain + "<bsdf type='diffuse' id='b3000'/>")), "more than 16 deep");
}

TEST_F(ImportedXml, DoesNotExpandEntities) {
  write("secret.txt", "radiance");
  EXPECT_SAYS(said("<!DOCTYPE scene [<!ENTITY s SYSTEM 'secret.txt'><!ENTITY a 'aaaaaaaa'>]>"
                   "<scene version='3.0.0'><shape type='&s;&a;'/>" +
                   lamp_and_camera + "</scene>"),
              "the shape \"&s;&a;\" is not known");
}

TEST_F(ImportedXml, OfManyFaultsTellsAHundred) {
  std::string many;
  for (int i = 0; i < 500; ++i) many += "<shape type='x'/>";
  const auto found = faults(scene_of(many));
  ASSERT_EQ(found.size(), 101u);
  EXPECT_SAYS(found.back().what, "more like these follow");
}

// Any part of a scene left out, or doubled, gives a scene or faults, and no crash.
TEST_F(ImportedXml, OfAnyBrokenTextIsSafeToRead) {
  const std::string whole = scene_of(
      "<default name='r' value='0.5'/><bsdf type='twosided' id='w'><bsdf type='diffuse'><rgb "
      "name='reflectance' value='0.1,0.2,0.3'/></bsdf></bsdf><shape type='cylinder'><point "
      "name='p0' "
      "x='1' y='2' z='3'/><transform name='toWorld'><rotate y='1' angle='$r'/><matrix value='1 0 0 "
      "0 0 "
      "1 0 0 0 0 1 0 0 0 0 1'/></transform><ref id='w'/></shape>");
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    for (const std::size_t length : {std::size_t{1}, std::size_t{5}, std::size_t{40}}) {
      std::string less = whole, more = whole;
      less.erase(i, length);
      more.insert(i, whole.substr(i, length));
      faults(less, Fidelity::approximate);
      faults(more, Fidelity::approximate);
    }
  }
}

// ---- one scene in the words of both versions

Json imported_file(const char* name, const XmlParameters& parameters = {}) {
  const ImportedScene scene =
      import_mitsuba({fs::path(WANDER_SOURCE) / "tests/scenes/import" / name, "cornell",
                      "cornell-meshes", parameters});
  EXPECT_TRUE(scene.approximations.empty());
  return Json::parse(scene.text);
}

TEST(ImportedCornellBox, IsTheBox) {
  const Json box = imported_file("cornell_3.xml");
  EXPECT_EQ(box["max_vertices"], 7);
  EXPECT_EQ(box["camera"]["resolution"], Json::parse("[64, 48]"));
  EXPECT_EQ(imported_file("cornell_3.xml", {{"width", "32"}})["camera"]["resolution"][0], 32);
  // The angle is that of the height.
  EXPECT_NEAR(box["camera"]["fov_deg"].get<double>(), 50.93, 0.01);
  ASSERT_EQ(box["shapes"].size(), 8u);
  const Json& floor = box["shapes"][0];
  expect_near(floor["origin"], {0, 0, 0.556}, 1e-15);
  expect_near(floor["edges"][0], {0.556, 0, 0}, 1e-15);
  expect_near(floor["edges"][1], {0, 0, -0.556}, 1e-15);
  EXPECT_EQ(box["shapes"][4]["material"], "red");
  EXPECT_EQ(box["materials"]["red"],
            Json::parse(R"({"type": "diffuse", "reflectance": [0.65, 0.05, 0.05]})"));
  EXPECT_EQ(box["materials"]["glass"], Json::parse(R"({"type": "dielectric", "ior": 1.5})"));
  EXPECT_EQ(box["shapes"][6]["radius"], 0.09);
  EXPECT_EQ(box["shapes"][7]["light"], Json::parse(R"({"radiance": [18.4, 15.6, 8.0]})"));
  EXPECT_EQ(box["shapes"][7]["name"], "lamp");
}

TEST(ImportedCornellBox, IsTheSameInVersion06) {
  Json now = imported_file("cornell_3.xml"), before = imported_file("cornell_06.xml");
  now.erase("description");
  before.erase("description");
  EXPECT_EQ(now, before);
}

}  // namespace
}  // namespace wander::test

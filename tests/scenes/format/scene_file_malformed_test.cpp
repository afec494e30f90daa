// Of an invalid scene every fault is told, and no other, with its place: the text, the root and the
// materials.
#include "tests/scenes/format/malformed_scene.h"

namespace wander {
namespace {

TEST_P(MalformedScene, HasExactlyTheExpectedFaultsInTheirPlaces) {
  const Marked marked = without_marks(GetParam().text);
  const std::vector<Fault> faults = faults_of(marked.text);
  const auto& expected = GetParam().faults;
  ASSERT_EQ(marked.places.size(), expected.size()) << "the test itself is malformed";
  EXPECT_EQ(faults.size(), expected.size());
  for (std::size_t i = 0; i < std::min(faults.size(), expected.size()); ++i) {
    EXPECT_EQ(std::pair(faults[i].line, faults[i].column), marked.places[i]) << faults[i].what;
    EXPECT_EQ(faults[i].pointer, expected[i].pointer) << faults[i].what;
    EXPECT_NE(faults[i].what.find(expected[i].part), std::string::npos) << faults[i].what;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Json, MalformedScene,
    testing::Values(
        Malformed{"Empty", "^", {{"/", "the end of the file"}}},
        Malformed{"OnlyComments", "// no scene\n/* yet */^", {{"/", "the end of the file"}}},
        Malformed{"NotAnObject", "^42", {{"/", "42 is not an object"}}},
        Malformed{"TrailingComma", "{\"a\": [1, 2,^]}", {{"/a/2", "expected is a value"}}},
        Malformed{"TrailingCommaInObject", "{\"a\": 1,^}", {{"/", "a key in double quotes"}}},
        Malformed{"MissingComma", "{\"a\": 1\n ^\"b\": 2}", {{"/", "expected is ',' or '}'"}}},
        Malformed{"MissingColon", "{\"a\" ^1}", {{"/a", "expected is ':'"}}},
        Malformed{"WrongBracket", "{\"a\": [1^}", {{"/a/1", "expected is ',' or ']'"}}},
        Malformed{"Unclosed", "{\"a\": [1^", {{"/a/1", "the end of the file"}}},
        Malformed{"UnclosedText", "{\"a\": ^\"b", {{"/a", "missing closing quote"}}},
        Malformed{"TextOverTwoLines", "{\"a\": ^\"b\nc\"}", {{"/a", "closing \" is missing"}}},
        Malformed{"SingleQuotes", "{^'a': 1}", {{"/", "no JSON"}}},
        Malformed{"BareKey", "{^a: 1}", {{"/", "no JSON"}}},
        Malformed{"BadWord", "{\"a\": ^tru}", {{"/a", "tru is no JSON"}}},
        Malformed{"LeadingZero", "{\"a\": ^01}", {{"/", "01 is not allowed"}}},
        Malformed{"LeadingPoint", "{\"a\": ^.5}", {{"/a", ".5 is no JSON"}}},
        Malformed{"LetterAfterTooLarge", "{\"a\": ^1e999x}", {{"/a", "1e999x is no JSON"}}},
        Malformed{"BadEscape", "{\"a\": ^\"\\q\"}", {{"/a", "forbidden character"}}},
        Malformed{"LoneSurrogate", "{\"a\": ^\"\\ud800\"}", {{"/a", "surrogate"}}},
        Malformed{"TextAfterTheScene", "{} ^x", {{"/", "x is no JSON"}}},
        Malformed{"TwoScenes", "{}\n^{}", {{"/", "the end, for a scene is one object"}}},
        Malformed{"OpenComment", "{} /* no end^", {{"/", "comment"}}},
        Malformed{"InvalidUtf8", "{\"a\": \"\xC3\xA9^\xC3(\"}", {{"/", "0xC3"}}},
        Malformed{"OverlongUtf8", "{\"a\": \"^\xC0\xAF\"}", {{"/", "0xC0"}}},
        Malformed{"NulByte", std::string("{} ^\0 {", 8), {{"/", "0x00"}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Root, MalformedScene,
    testing::Values(
        Malformed{"NoMembers",
                  "^^^{}",
                  {{"/", "\"dimension\" is missing"},
                   {"/", "\"format\" is missing"},
                   {"/", "\"shapes\" is missing"}}},
        Malformed{"WrongFormat",
                  "{\"format\": ^\"wander/2\", \"dimension\": 2, \"shapes\": [" + a_light + "," +
                      a_sensor + "]}",
                  {{"/format", "\"wander/2\" is not allowed; the format is"}}},
        Malformed{"DimensionFour",
                  "{\"format\": \"wanderlight-scene/1\", \"dimension\": ^4, \"shapes\": [" +
                      a_light + "," + a_sensor + "]}",
                  {{"/dimension", "4 is not allowed; a dimension is 2 or 3"}}},
        Malformed{"UnknownKey",
                  with_root("^\"max_vertcies\": 4"),
                  {{"/max_vertcies", "did you mean \"max_vertices\"?"}}},
        Malformed{"KeyInAnotherCase",
                  with_root("^\"Name\": \"x\""),
                  {{"/Name", "did you mean \"name\"?"}}},
        Malformed{"KeyLikeNone", with_root("^\"zzzzzzzz\": 4"), {{"/zzzzzzzz", "the nearest is"}}},
        Malformed{"KeyWithSlash", with_root("^\"a/b~c\": 4"), {{"/a~1b~0c", "unknown key"}}},
        Malformed{"KeyWithEscapeSequence",
                  with_root("^\"a\\u001b[31m\": 4"),
                  {{"/a\\u001b[31m", "unknown key \"a\\u001b[31m\""}}},
        Malformed{"DuplicateKey",
                  with_root("\"name\": \"a\", ^\"name\": {\"b\": [1]}"),
                  {{"/name", "appears twice"}}},
        Malformed{"MaxVerticesOne",
                  with_root("\"max_vertices\": ^1"),
                  {{"/max_vertices", "from 2 to 100000"}}},
        Malformed{"MaxVerticesHuge",
                  with_root("\"max_vertices\": ^100001"),
                  {{"/max_vertices", "100001 is not allowed"}}},
        Malformed{"MaxVerticesHalf",
                  with_root("\"max_vertices\": ^2.5"),
                  {{"/max_vertices", "2.5 is not an integer"}}},
        Malformed{"NameIsNumber", with_root("\"name\": ^3"), {{"/name", "3 is not a text"}}},
        Malformed{"ColumnsCountCharacters",
                  with_root("\"name\": \"h\xC3\xA9\xE2\x82\xAC\", ^\"idd\": \"\""),
                  {{"/idd", "did you mean \"id\"?"}}},
        Malformed{"TextTooLong",
                  with_root("\"name\": ^\"" + std::string(4097, 'x') + "\""),
                  {{"/name", "4097 bytes"}}},
        Malformed{"KeyTooLong",
                  with_root("^\"" + std::string(4097, 'x') + "\": 1"),
                  {{"/", "4097 bytes"}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Materials, MalformedScene,
    testing::Values(
        Malformed{
            "ReflectanceAboveOne",
            with_material(R"("m": { "type": "mirror", "reflectance": ^1.01 })"),
            {{"/materials/m/reflectance", "1.01 is not allowed; a reflectance is from 0 to 1"}}},
        Malformed{"ReflectanceNegative",
                  with_material(R"("m": { "type": "diffuse", "reflectance": ^-0.1 })"),
                  {{"/materials/m/reflectance", "-0.1 is not allowed"}}},
        Malformed{"ReflectanceInColour",
                  with_material(R"("m": { "type": "diffuse", "reflectance": ^[1, 0, 0] })"),
                  {{"/materials/m/reflectance", "a list is not a number"}}},
        Malformed{
            "RoughnessZero",
            with_material(R"("m": {"type": "rough_conductor", "roughness": ^0, "reflectance": 1})"),
            {{"/materials/m/roughness", "> 0 and at most 1"}}},
        Malformed{"ConductorInColour",
                  with_material(R"("m": { "type": "conductor", "eta": ^[1, 2, 3], "k": 2 })"),
                  {{"/materials/m/eta", "a list is not a number; eta and k are from 0 to 1e6"}}},
        Malformed{"IndexZero",
                  with_material(R"("m": { "type": "dielectric", "ior": ^0 })"),
                  {{"/materials/m/ior", "an index of refraction is > 0"}}},
        Malformed{"IndexMissing",
                  with_material(R"("m": ^{ "type": "rough_dielectric", "roughness": 0.1 })"),
                  {{"/materials/m", "\"ior\" is missing"}}},
        Malformed{"UnknownType",
                  with_material(R"("m": { "type": ^"mirorr", "reflectance": 1 })"),
                  {{"/materials/m/type", "did you mean \"mirror\"?"}}},
        Malformed{"TypeMissing",
                  with_material(R"("m": ^{ "reflectance": 1 })"),
                  {{"/materials/m", "\"type\" is missing"}}},
        Malformed{"NotAMaterial",
                  with_material(R"("m": ^"diffuse")"),
                  {{"/materials/m", "is not an object"}}},
        Malformed{
            "KeyOfAnotherType",
            with_material(R"("m": { "type": "mirror", "reflectance": 1, ^"roughness": 0.1 })"),
            {{"/materials/m/roughness", "unknown key"}}},
        Malformed{"TypeIsNumber",
                  with_material(R"("m": { "type": ^7 })"),
                  {{"/materials/m/type", "7 is not a text"}}}),
    name_of);

}  // namespace
}  // namespace wander

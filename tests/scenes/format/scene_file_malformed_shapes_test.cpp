// Of an invalid scene every fault is told, and no other, with its place: shapes, lights, sensors
// and several faults at once.
#include "tests/scenes/format/malformed_scene.h"

namespace wander {
namespace {

INSTANTIATE_TEST_SUITE_P(
    Shapes, MalformedScene,
    testing::Values(
        Malformed{"UnknownType",
                  with_shape(R"({ "type": ^"polylin", "points": [[0, 0], [1, 0]] })"),
                  {{"/shapes/2/type", "did you mean \"polyline\"?"}}},
        Malformed{
            "UnknownKey",
            with_shape(R"({ "type": "circle", "center": [0, 0], "radius": 1, ^"raduis": 1 })"),
            {{"/shapes/2/raduis", "did you mean \"radius\"?"}}},
        Malformed{
            "UnknownMaterial",
            with_shape(
                R"({ "type": "circle", "center": [0, 0], "radius": 1, "material": ^"plastr" })"),
            {{"/shapes/2/material", "did you mean \"plaster\"?"}}},
        Malformed{"ReferenceWithoutMaterials",
                  shapes_only(
                      "[" + a_light + "," + a_sensor +
                      R"(, {"type": "circle", "center": [0, 0], "radius": 1, "material": ^"x"}])"),
                  {{"/shapes/2/material", "the scene has no \"materials\""}}},
        Malformed{"NotAShape", with_shape("^null"), {{"/shapes/2", "null is not an object"}}},
        Malformed{"ThreeCoordinates",
                  with_shape(R"({ "type": "segment", "from": ^[0, 0, 0], "to": [1, 1] })"),
                  {{"/shapes/2/from", "a list of 3 is not allowed; a point is [x, y]"}}},
        Malformed{"CoordinateIsText",
                  with_shape(R"({ "type": "segment", "from": [0, ^"0"], "to": [1, 1] })"),
                  {{"/shapes/2/from/1", "\"0\" is not a number"}}},
        Malformed{"CoordinateTooLarge",
                  with_shape(R"({ "type": "segment", "from": [0, ^1e200], "to": [1, 1] })"),
                  {{"/shapes/2/from/1", "1e200 is not allowed"}}},
        Malformed{"NotANumber",
                  with_shape(R"({ "type": "segment", "from": [0, ^NaN], "to": [1, 1] })"),
                  {{"/shapes/2/from/1", "NaN is not a finite number"}}},
        Malformed{
            "InfiniteNumbers",
            with_shape(R"({ "type": "segment", "from": [^-Infinity, ^1e999], "to": [1, 1] })"),
            {{"/shapes/2/from/0", "-Infinity is not a finite"},
             {"/shapes/2/from/1", "1e999 is not a finite"}}},
        Malformed{"SegmentWithoutLength",
                  with_shape(R"({ "type": "segment", "from": [1, 0], "to": ^[1.0, -0.0] })"),
                  {{"/shapes/2/to", "a segment has a length > 0"}}},
        Malformed{"SegmentTooShort",
                  with_shape(R"({ "type": "segment", "from": [0, 1e-310], "to": ^[1e-310, 0] })"),
                  {{"/shapes/2/to", "shorter than 1e-60"}}},
        Malformed{"SideTooShort",
                  with_shape(R"({ "type": "polyline", "points": [[0, 0], ^[0, 1e-160], [1, 0]] })"),
                  {{"/shapes/2/points/1", "shorter than 1e-60"}}},
        Malformed{"RadiusTooShort",
                  with_shape(R"({ "type": "circle", "center": [0, 0], "radius": ^1e-310 })"),
                  {{"/shapes/2/radius", "shorter than 1e-60"}}},
        Malformed{
            "RepeatedPoint",
            with_shape(R"({ "type": "polyline", "points": [[0, 0], [1, 0], ^[1, 0], [2, 0]] })"),
            {{"/shapes/2/points/2", "repeats the point before it"}}},
        Malformed{
            "ClosedTwice",
            with_shape(
                R"({"type": "polyline", "points": [[0,0],[1,0],[1,1],^[0,0]], "closed": true})"),
            {{"/shapes/2/points/3", "repeats the first point"}}},
        Malformed{"OnePoint",
                  with_shape(R"({ "type": "polyline", "points": ^[[0, 0]] })"),
                  {{"/shapes/2/points", "at least 2 points"}}},
        Malformed{
            "ClosedWithTwoPoints",
            with_shape(R"({ "type": "polyline", "points": ^[[0, 0], [1, 0]], "closed": true })"),
            {{"/shapes/2/points", "at least 3 points"}}},
        Malformed{
            "ClosedIsText",
            with_shape(R"({ "type": "polyline", "points": [[0, 0], [1, 0]], "closed": ^"yes" })"),
            {{"/shapes/2/closed", "\"yes\" is not true or false"}}},
        Malformed{"RadiusZero",
                  with_shape(R"({ "type": "circle", "center": [0, 0], "radius": ^0 })"),
                  {{"/shapes/2/radius", "0 is not allowed; a radius is > 0"}}},
        Malformed{"RadiusTooSmallForANumber",
                  with_shape(R"({ "type": "circle", "center": [0, 0], "radius": ^1e-400 })"),
                  {{"/shapes/2/radius", "1e-400 is not allowed"}}},
        Malformed{
            "ArcWithoutExtent",
            with_shape(
                R"({"type": "arc", "center": [0,0], "radius": 1, "from_deg": 9, "to_deg": ^9})"),
            {{"/shapes/2/to_deg", "are equal"}}},
        Malformed{
            "ArcTooLong",
            with_shape(
                R"({"type": "arc", "center": [0,0], "radius": 1, "from_deg": 0, "to_deg": ^361})"),
            {{"/shapes/2/to_deg", "at most 360"}}},
        Malformed{
            "ArcOfManyTurns",
            with_shape(
                R"({"type": "arc", "center": [0,0], "radius": 1, "from_deg": ^1e18, "to_deg": 1})"),
            {{"/shapes/2/from_deg", "from -3600 to 3600"}}},
        Malformed{"ArcWithoutRadius",
                  with_shape(R"(^{"type": "arc", "center": [0,0], "from_deg": 0, "to_deg": 90})"),
                  {{"/shapes/2", "\"radius\" is missing"}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    LightsAndSensors, MalformedScene,
    testing::Values(
        Malformed{
            "RadianceNegative",
            with_shape(
                R"({"type": "segment", "from": [0,2], "to": [1,2], "light": {"radiance": ^-1}})"),
            {{"/shapes/2/light/radiance", "-1 is not allowed; a radiance is > 0"}}},
        Malformed{
            "RadianceTooLarge",
            with_shape(
                R"({"type": "segment", "from": [0,2], "to": [1,2], "light": {"radiance": ^1.1e36}})"),
            {{"/shapes/2/light/radiance",
              "1.1e36 is not allowed; a radiance is > 0, from 1e-36 to 1e36"}}},
        Malformed{
            "RadianceTooSmall",
            with_shape(
                R"({"type": "segment", "from": [0,2], "to": [1,2], "light": {"radiance": ^9e-37}})"),
            {{"/shapes/2/light/radiance", "9e-37 is not allowed"}}},
        Malformed{"LightIsNumber",
                  with_shape(R"({"type": "segment", "from": [0,2], "to": [1,2], "light": ^5})"),
                  {{"/shapes/2/light", "5 is not an object; a light is { \"radiance\": > 0 }"}}},
        Malformed{"BinsZero",
                  shapes_only("[" + a_light + R"(,
            {"type": "segment", "from": [0,0], "to": [1,0], "sensor": {"bins": ^0}}])"),
                  {{"/shapes/1/sensor/bins", "an integer from 1 to 10000000"}}},
        Malformed{"BinsTooMany",
                  shapes_only("[" + a_light + R"(,
            {"type": "segment", "from": [0,0], "to": [1,0], "sensor": {"bins": ^10000001}}])"),
                  {{"/shapes/1/sensor/bins", "10000001 is not allowed"}}},
        Malformed{"NoSensor",
                  shapes_only("^[" + a_light + "]"),
                  {{"/shapes", "the scene has no sensor"}}},
        Malformed{
            "NoLight", shapes_only("^[" + a_sensor + "]"), {{"/shapes", "no shape is a light"}}},
        Malformed{"NoShapes",
                  shapes_only("^^[]"),
                  {{"/shapes", "no shape is a light"}, {"/shapes", "no sensor"}}},
        Malformed{"MisspeltSensorIsNotMissingToo",
                  shapes_only("[" + a_light + R"(,
            {"type": "segment", "from": [0,0], "to": [1,0], ^"senser": {"bins": 3}}])"),
                  {{"/shapes/1/senser", "did you mean \"sensor\"?"}}},
        Malformed{"TwoSensors",
                  with_shape(
                      R"({"type": "segment", "from": [0,2], "to": [1,2], "sensor": ^{"bins": 1}})"),
                  {{"/shapes/2/sensor", "a sensor too many, after /shapes/1/sensor"}}},
        Malformed{"CameraAndSensor",
                  shapes_only("[" + a_light + "," + R"(
            {"type": "segment", "from": [0,2], "to": [1,2], "sensor": {"bins": 1}} ], "camera": ^{
            "type": "perspective", "position": [0,0], "target": [1,0], "fov_deg": 40, "resolution": 8})"),
                  {{"/camera", "a sensor too many"}}},
        Malformed{"SensorOnPolyline",
                  shapes_only("[" + a_light + R"(,
            {"type": "polyline", "points": [[0,0],[1,0]], "sensor": ^{"bins": 3}}])"),
                  {{"/shapes/1/sensor", "a polyline cannot be a sensor"}}},
        Malformed{"LightOnGlass",
                  with_shape(R"({"type": "circle", "center": [0,0], "radius": 1,
            "material": "glass", "light": ^{"radiance": 1}})"),
                  {{"/shapes/2/light", "a light cannot lie on the dielectric \"glass\""}}},
        Malformed{"SensorOnRoughGlass",
                  R"({ "format": "wanderlight-scene/1", "dimension": 2,
            "materials": {"frost": {"type": "rough_dielectric", "roughness": 0.1, "ior": 1.5}},
            "shapes": [ )" +
                      a_light + R"(, {"type": "segment", "from": [0,0], "to": [1,0],
            "material": "frost", "sensor": ^{"bins": 3}} ]})",
                  {{"/shapes/1/sensor", "a sensor cannot lie on the rough_dielectric"}}},
        Malformed{"CameraTooNear",
                  shapes_only("[" + a_light + R"(], "camera": {
            "type": "perspective", "position": [0,2e-200], "target": ^[0,1e-200], "fov_deg": 40, "resolution": 8})"),
                  {{"/camera/target", "nearer to position than 1e-60"}}},
        Malformed{"CameraWithoutDirection",
                  shapes_only("[" + a_light + R"(], "camera": {
            "type": "perspective", "position": [1,2], "target": ^[1,2], "fov_deg": 40, "resolution": 8})"),
                  {{"/camera/target", "the same point"}}},
        Malformed{"CameraTooWide",
                  shapes_only("[" + a_light + R"(], "camera": {
            "type": "perspective", "position": [1,2], "target": [0,0], "fov_deg": ^180, "resolution": 8})"),
                  {{"/camera/fov_deg", "> 0 and < 180 degrees"}}},
        Malformed{"CameraWithUp",
                  shapes_only("[" + a_light + R"(], "camera": {"type": "perspective",
            "position": [1,2], "target": [0,0], ^"up": [0,1], "fov_deg": 90, "resolution": 8})"),
                  {{"/camera/up", "unknown key"}}},
        Malformed{"CameraOfPixels",
                  shapes_only("[" + a_light + R"(], "camera": {"type": "perspective",
            "position": [1,2], "target": [0,0], "fov_deg": 90, "resolution": ^[8, 8]})"),
                  {{"/camera/resolution", "a list is not an integer"}}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(Several, MalformedScene,
                         testing::Values(Malformed{
                             "AtOnce",
                             R"({
  "format": "wanderlight-scene/1", "dimension": 2, ^"max_vertex": 3,
  "materials": { "a": { "type": "diffuse", "reflectance": ^2 }, ^"a": 1 },
  "shapes": ^[
    { "type": "segment", "from": [0, 0], "to": ^[0, 0], "material": ^"b" },
    { "type": "segment", "from": [0, ^NaN], "to": [0, 0], "light": { "radiance": ^-1 } }
  ]
})",
                             {{"/max_vertex", "max_vertices"},
                              {"/materials/a/reflectance", "2 is not allowed"},
                              {"/materials/a", "appears twice"},
                              {"/shapes", "no sensor"},
                              {"/shapes/0/to", "the same point"},
                              {"/shapes/0/material", "no material \"b\""},
                              {"/shapes/1/from/1", "NaN"},
                              {"/shapes/1/light/radiance", "-1 is not allowed"}}}),
                         name_of);

}  // namespace
}  // namespace wander

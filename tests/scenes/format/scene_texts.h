// Texts of scenes for the tests of their reader.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "scenes/format/scene_file.h"

namespace wander {

// A valid scene around what a test adds: members of the root, materials, shapes.
struct Around {
  std::string root, materials, shapes;

  std::string text() const {
    return fmt::format(R"({{
  "format": "wanderlight-scene/1", "dimension": 2, {}
  "materials": {{
    "plaster": {{ "type": "diffuse", "reflectance": 0.75 }},
    "glass": {{ "type": "dielectric", "ior": 1.5 }}{}
  }},
  "shapes": [
    {{ "type": "segment", "from": [0, 1], "to": [-1, 1], "light": {{ "radiance": 5 }} }},
    {{ "type": "segment", "from": [0, 0], "to": [1, 0], "sensor": {{ "bins": 100 }} }}{}
  ]
}})",
                       root, materials, shapes);
  }
};
inline std::string with_root(const std::string& members) {
  return Around{members + ",", "", ""}.text();
}
inline std::string with_material(const std::string& m) {
  return Around{"", ",\n    " + m, ""}.text();
}
inline std::string with_shape(const std::string& s) { return Around{"", "", ",\n    " + s}.text(); }

// A document of just these shapes.
inline std::string shapes_only(const std::string& list) {
  return R"({ "format": "wanderlight-scene/1", "dimension": 2, "shapes": )" + list + " }";
}
inline const std::string a_light =
    R"({ "type": "segment", "from": [0, 1], "to": [-1, 1], "light": { "radiance": 5 } })";
inline const std::string a_sensor =
    R"({ "type": "segment", "from": [0, 0], "to": [1, 0], "sensor": { "bins": 8 } })";

inline SceneDocument parse(const std::string& text) { return parse_scene(text, "s.json"); }

inline std::vector<Fault> faults_of(const std::string& text) {
  try {
    parse(text);
  } catch (const SceneFileError& error) {
    return error.faults;
  }
  return {};
}

inline const std::string everything = R"(// A scene of everything.
{
  "format": "wanderlight-scene/1", "dimension": 2, "name": "all", "id": "a", "description": "é",
  "max_vertices": 12,
  "materials": {
    "z": { "type": "diffuse", "reflectance": 0.75, "name": "wall" },
    "m": { "type": "mirror", "reflectance": 1 },
    "g": { "type": "dielectric", "ior": 1.5 }, /* in air */
    "w": { "type": "dielectric", "ior": 1.5, "exterior_ior": 1.33 },
    "c": { "type": "rough_conductor", "roughness": 0.2, "reflectance": 0.9 },
    "f": { "type": "rough_dielectric", "roughness": 1e-5, "ior": 2, "exterior_ior": 0.5 },
    "b": { "type": "black", "description": "absorbs" }
  },
  "shapes": [
    { "type": "segment", "from": [0.1, -2e-310], "to": [3, 4], "material": "m", "id": "s" },
    { "type": "polyline", "points": [[5, 5], [6, 5], [6, 6]], "closed": true, "material": "z",
      "light": { "radiance": 1e36 } },
  // circles and arcs
    { "type": "circle", "center": [20, 0], "radius": 2, "material": "g" },
    { "type": "arc", "center": [30, 0], "radius": 2.5, "from_deg": 350, "to_deg": 10.5,
      "flip": true, "name": "bowl", "light": { "radiance": 3 }, "sensor": { "bins": 1e2 } }
  ]
})";

}  // namespace wander

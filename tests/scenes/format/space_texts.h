// Texts of scenes of three dimensions, for the tests of their reader.
#pragma once

#include <string>

#include "tests/scenes/format/scene_texts.h"

namespace wander {

inline const std::string everything_in_space = R"({
  "format": "wanderlight-scene/1", "dimension": 3, "name": "all",
  "materials": {
    "red": { "type": "diffuse", "reflectance": [0.9, 0.1, 0.2] },
    "grey": { "type": "mirror", "reflectance": [0.5, 0.5, 0.5] },
    "gold": { "type": "rough_conductor", "roughness": 0.3, "reflectance": [1, 0.8, 0.3] }
  },
  "shapes": [
    { "type": "triangle", "points": [[1, 2, 3], [4, 5, 6], [7, 8, 10]], "material": "red" },
    { "type": "parallelogram", "origin": [0, 1, 2], "edges": [[1, 0, 0], [0, 1, 0.5]],
      "material": "gold", "sensor": { "resolution": [30, 20] } },
    { "type": "sphere", "center": [9, 9, 9], "radius": 2, "flip": true, "material": "grey",
      "light": { "radiance": [1, 0, 2] } }
  ]
})";

// A document of just these shapes, and members of the root.
inline std::string space_only(const std::string& list, const std::string& members = "") {
  return R"({ "format": "wanderlight-scene/1", "dimension": 3, "shapes": )" + list + members + " }";
}
inline const std::string a_lamp = R"({ "type": "sphere", "center": [0, 3, 0], "radius": 0.5,
      "light": { "radiance": 5 } })";
inline const std::string a_screen =
    R"({ "type": "parallelogram", "origin": [0, 0, 0], "edges": [[1, 0, 0], [0, 0, -1]],
      "sensor": { "resolution": [8, 4] } })";

// A valid scene with one more shape.
inline std::string with_solid(const std::string& shape) {
  return space_only("[" + a_lamp + ", " + a_screen + ",\n    " + shape + "]");
}
// A valid scene of this camera: what it says beside its type.
inline std::string with_view(const std::string& members) {
  return space_only("[" + a_lamp + "]",
                    ",\n  \"camera\": { \"type\": \"perspective\", " + members + " }");
}

}  // namespace wander

// Small scenes in space for runs of the program: a box with a lamp and a ball of glass before a
// camera, in one channel or in colour.
#pragma once

#include <fmt/format.h>

#include <string>

namespace wander::test {

inline std::string space_scene(const std::string& wall, int width = 12, int height = 8) {
  return fmt::format(R"({{
  "format": "wanderlight-scene/1", "dimension": 3, "name": "small room", "max_vertices": 4,
  "materials": {{ "white": {{ "type": "diffuse", "reflectance": 0.7 }},
                 "wall": {{ "type": "diffuse", "reflectance": {} }},
                 "glass": {{ "type": "dielectric", "ior": 1.5 }} }},
  "shapes": [
    {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[0,0,1],[1,0,0]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [0,1,0], "edges": [[1,0,0],[0,0,1]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[0,1,0],[0,0,1]], "material": "wall" }},
    {{ "type": "parallelogram", "origin": [1,0,0], "edges": [[0,0,1],[0,1,0]], "material": "white" }},
    {{ "type": "parallelogram", "origin": [0,0,0], "edges": [[1,0,0],[0,1,0]], "material": "white" }},
    {{ "type": "sphere", "center": [0.6,0.25,0.4], "radius": 0.2, "material": "glass" }},
    {{ "type": "parallelogram", "origin": [0.3,0.98,0.3], "edges": [[0.4,0,0],[0,0,0.4]],
      "light": {{ "radiance": 8 }} }} ],
  "camera": {{ "type": "perspective", "position": [0.5,0.5,2.2], "target": [0.5,0.5,0],
    "up": [0,1,0], "fov_deg": 42, "resolution": [{}, {}] }} }})",
                     wall, width, height);
}
inline std::string grey_room(int width = 12, int height = 8) {
  return space_scene("0.4", width, height);
}
inline std::string coloured_room(int width = 12, int height = 8) {
  return space_scene("[0.8, 0.1, 0.05]", width, height);
}

}  // namespace wander::test

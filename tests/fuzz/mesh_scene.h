// A scene that wants all that a mesh may have: its triangles, its normals and its places in a
// picture.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "scenes/format/scene_file.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

// A PNG file.
inline constexpr std::string_view one_white_texel{
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\001\000"
    "\000\000\001\010\000\000\000\000\072\176\233\125\000\000\000\012\111\104\101\124\170"
    "\332\143\370\017\000\001\001\001\000\034\260\214\231\000\000\000\000\111\105\116\104"
    "\256\102\140\202",
    67};

inline void read_mesh_in_a_scene(std::string_view bytes, const char* name,
                                 const std::filesystem::path& folder) {
  write_bytes(folder / name, bytes);
  write_bytes(folder / "white.png", one_white_texel);
  write_bytes(folder / "scene.json", fmt::format(R"({{
  "format": "wanderlight-scene/1", "dimension": 3,
  "materials": {{ "white": {{ "type": "diffuse", "reflectance": 0.5 }},
                 "picture": {{ "type": "diffuse", "reflectance": {{ "texture": "white.png" }} }} }},
  "shapes": [
    {{ "type": "mesh", "file": "{0}", "material": "white", "light": {{ "radiance": 1 }} }},
    {{ "type": "mesh", "file": "{0}", "material": "white", "normals": "smooth",
      "transform": [[1, 0, 0, 1e3], [0, 1, 0, 0], [0, 0, 1, 0]] }},
    {{ "type": "mesh", "file": "{0}", "material": "picture",
      "transform": [[1, 0, 0, 0], [0, 1, 0, 1e3], [0, 0, 1, 0]] }}
  ],
  "camera": {{ "type": "perspective", "position": [0, -20, 0], "target": [0, 0, 0], "up": [0, 0, 1],
              "fov_deg": 40, "resolution": [4, 4] }}
}}
)",
                                                 name));
  read_scene_file(folder / "scene.json");
}

}  // namespace wander::fuzz

#include "scenes/format/scene_file.h"
#include "tests/fuzz/target.h"

namespace wander::fuzz {

namespace {

constexpr std::string_view scene = R"({
  "format": "wanderlight-scene/1", "dimension": 3,
  "materials": { "picture": { "type": "diffuse", "reflectance": { "texture": "texture.png" } } },
  "shapes": [
    { "type": "parallelogram", "origin": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]], "material": "picture" },
    { "type": "sphere", "center": [0, 0, 3], "radius": 0.5, "light": { "radiance": 1 } }
  ],
  "camera": { "type": "perspective", "position": [0, -20, 1], "target": [0, 0, 0], "up": [0, 0, 1],
              "fov_deg": 40, "resolution": [4, 4] }
}
)";

}  // namespace

const Target texture_target{"texture",
                            [](std::string_view bytes, const std::filesystem::path& folder) {
                              write_bytes(folder / "texture.png", bytes);
                              write_bytes(folder / "scene.json", scene);
                              read_scene_file(folder / "scene.json");
                            }};

}  // namespace wander::fuzz

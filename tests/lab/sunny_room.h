// A scene with light that is seldom found.
#pragma once

namespace wander::test {

// An open room with a mirrored ball, under a sun that is far away: the caustic of the ball is found only by paths from
// the camera that meet the sun by chance, behind a mirror, by technique (4, 0).
inline constexpr const char* sunny_room =
    R"({ "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 4,
  "materials": { "w": { "type": "diffuse", "reflectance": 0.6 }, "s": { "type": "mirror", "reflectance": 0.8 } },
  "shapes": [
    { "type": "parallelogram", "origin": [-1, 0, -1], "edges": [[0, 0, 2.5], [2, 0, 0]], "material": "w" },
    { "type": "parallelogram", "origin": [-1, 0, -1], "edges": [[2, 0, 0], [0, 2, 0]], "material": "w" },
    { "type": "parallelogram", "origin": [-1, 0, 1.5], "edges": [[0, 2, 0], [2, 0, 0]], "material": "w" },
    { "type": "parallelogram", "origin": [-1, 0, -1], "edges": [[0, 2, 0], [0, 0, 2.5]], "material": "w" },
    { "type": "parallelogram", "origin": [1, 0, -1], "edges": [[0, 0, 2.5], [0, 2, 0]], "material": "w" },
    { "type": "sphere", "center": [100000, 300000, 50000], "radius": 30000, "light": { "radiance": 20 } },
    { "type": "sphere", "center": [-0.6, 0.4, 0.3], "radius": 0.3, "material": "s" } ],
  "camera": { "type": "perspective", "position": [0.1, 1, 1.4], "target": [0, 0.5, -0.3], "up": [0, 1, 0],
              "fov_deg": 85, "resolution": [6, 5] } })";

}  // namespace wander::test

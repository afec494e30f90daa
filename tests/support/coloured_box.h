// A box of Spaceland in colour, as a scene file says it: two coloured walls, gold, a tinted mirror,
// a ball of glass, a warm lamp; and the scenes of one channel that its channels are.
#pragma once

#include "core/description.h"
#include "scenes/format/scene_file.h"

namespace wander::test {

inline const std::string coloured_box_text = R"({
  "format": "wanderlight-scene/1", "dimension": 3, "max_vertices": 5,
  "materials": {
    "white": { "type": "diffuse", "reflectance": 0.7 },
    "red": { "type": "diffuse", "reflectance": [0.8, 0.1, 0.05] },
    "blue": { "type": "diffuse", "reflectance": [0.1, 0.2, 0.9] },
    "gold": { "type": "rough_conductor", "roughness": 0.4, "reflectance": [0.95, 0.7, 0.3] },
    "tinted": { "type": "mirror", "reflectance": [0.5, 0.9, 0.6] },
    "glass": { "type": "dielectric", "ior": 1.5 }
  },
  "shapes": [
    { "type": "parallelogram", "origin": [0, 0, 0], "edges": [[0, 0, 1], [1, 0, 0]], "material": "white" },
    { "type": "parallelogram", "origin": [0, 1, 0], "edges": [[1, 0, 0], [0, 0, 1]], "material": "white" },
    { "type": "parallelogram", "origin": [0, 0, 0], "edges": [[0, 1, 0], [0, 0, 1]], "material": "red" },
    { "type": "parallelogram", "origin": [1, 0, 0], "edges": [[0, 0, 1], [0, 1, 0]], "material": "blue" },
    { "type": "parallelogram", "origin": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]], "material": "gold" },
    { "type": "parallelogram", "origin": [0, 0, 1], "edges": [[0, 1, 0], [1, 0, 0]], "material": "tinted" },
    { "type": "sphere", "center": [0.55, 0.3, 0.4], "radius": 0.2, "material": "glass" },
    { "type": "parallelogram", "origin": [0.3, 0.98, 0.3], "edges": [[0.4, 0, 0], [0, 0, 0.4]],
      "light": { "radiance": [9, 7, 4] } }
  ],
  "camera": { "type": "perspective", "position": [0.5, 0.6, 0.95], "target": [0.5, 0.4, 0],
              "up": [0, 1, 0], "fov_deg": 70, "resolution": [6, 4] }
})";

inline description::Scene coloured_box() {
  return parse_scene(coloured_box_text, "box.json").scene;
}

// With a prism of gold, which is a mesh.
inline description::Scene box_with_mesh() {
  description::Scene scene = coloured_box();
  Triangles prism;
  for (const double y : {0.1, 0.3})
    for (const auto& [x, z] : {std::pair{0.15, 0.6}, {0.35, 0.65}, {0.2, 0.8}})
      prism.points.push_back({x, y, z});
  prism.corners = {{0, 1, 2}, {3, 5, 4}, {0, 3, 1}, {1, 3, 4},
                   {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}};
  description::Mesh mesh;
  mesh.triangles = std::make_shared<const Triangles>(std::move(prism));
  description::Shape& shape = scene.shapes.emplace_back();
  shape.kind = std::move(mesh);
  shape.material = 3;
  return scene;
}

// Without caustics, whose error bars need many samples.
inline description::Scene coloured_box_without_caustics() {
  description::Scene scene = coloured_box();
  for (auto& material : scene.materials)
    if (std::holds_alternative<description::Mirror>(material.kind) ||
        std::holds_alternative<description::Dielectric>(material.kind))
      material.kind = description::Diffuse{{{0.2, 0.7, 0.4}, true}};
  return scene;
}

// All that is coloured has the value of one channel.
inline description::Scene channel_of(description::Scene scene, std::size_t channel) {
  const auto take = [&](description::Quantity& q) { q = {{q.channels[channel], 0, 0}, false}; };
  for (auto& material : scene.materials)
    std::visit(
        [&](auto& kind) {
          if constexpr (requires { kind.reflectance; }) take(kind.reflectance);
          if constexpr (requires { kind.eta; }) {
            take(kind.eta);
            take(kind.k);
          }
        },
        material.kind);
  for (auto& shape : scene.shapes)
    if (shape.light) take(shape.light->radiance);
  return scene;
}

}  // namespace wander::test

// From what a scene file says to a scene that can be sampled.
#pragma once

#include <memory>
#include <vector>

#include "core/description.h"
#include "core/scene.h"

namespace wander {

// The description is valid, as the reader of scene files leaves it, and of the dimension of `W`.
// Where `W` has one channel, a colour is its luminance.
template <World W>
std::unique_ptr<const Scene<W>> build_scene(const description::Scene& scene);

// Of each shape of the built scene, which shape of the file it is, or is a part of.
template <World W>
std::vector<std::size_t> shapes_named(const description::Scene& scene);

// In a world of two dimensions, in the precision that is wanted.
template <World W = Flatland>
std::unique_ptr<const Scene<W>> build_flatland(const description::Scene& scene) {
  return build_scene<W>(scene);
}

// The materials as the scene models them: roughness below 1e-8 is smooth, and an interface of rough
// glass between equal indices lets everything pass.
template <World W>
Material<W> build_material(const description::MaterialKind& kind);

}  // namespace wander

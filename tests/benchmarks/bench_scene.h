// Scenes of the gallery whose rays can be written down.
#pragma once

#include <memory>
#include <string_view>

#include "core/scene.h"

namespace wander {

// Throws std::runtime_error when the gallery has no such scene.
template <World W>
std::unique_ptr<Scene<W>> bench_scene(std::string_view name);

// Casts all rays of the log again.  The sum of what they met, for an optimiser to respect.
template <World W>
double cast_closest(const Scene<W>& scene, const RayLog<W>& log);
template <World W>
double cast_any(const Scene<W>& scene, const RayLog<W>& log);

}  // namespace wander

// Scenes of the gallery whose rays can be written down.
#pragma once

#include <memory>
#include <string_view>

#include "core/scene.h"

namespace wander {

// Throws std::runtime_error when the gallery has no such scene.
std::unique_ptr<Scene<Flatland>> bench_scene(std::string_view name);

// Casts all rays of the log again.  The sum of what they met, for an optimiser to respect.
double cast_closest(const Scene<Flatland>& scene, const RayLog<Flatland>& log);
double cast_any(const Scene<Flatland>& scene, const RayLog<Flatland>& log);

}  // namespace wander

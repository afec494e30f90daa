// Whether a camera lies on a surface: of what it sees there rounding decides, ray by ray.
#pragma once

#include <cstddef>
#include <optional>

#include "core/description.h"

namespace wander {

// The first shape from which the camera's position is no farther than the rounding of coordinates.
std::optional<std::size_t> shape_below_camera(const description::Scene& scene);

}  // namespace wander

// The fluence of a scene in the plane: light in the space between the surfaces, as a figure.
#pragma once

#include <string>

#include "core/description.h"
#include "core/geometry/plane_grid.h"
#include "records/rendering.h"

namespace wander::figure {

inline constexpr double fluence_width = 360;

// An SVG document; `picture` is what estimate_fluence() made over this grid.
std::string fluence_figure(const description::Scene& scene, const PlaneGrid& grid,
                           const Rendering& picture, const std::string& title,
                           double page_width = fluence_width);

}  // namespace wander::figure

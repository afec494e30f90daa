// A scene in space as a figure of its own: its outline in the picture of its camera, its name above
// and a legend below.
#pragma once

#include <string>

#include "core/description.h"
#include "draw/figure/scene_figure.h"
#include "draw/figure/view.h"

namespace wander::figure {

// That of its camera, or of all of it.
View view_of(const description::Scene& scene, const SceneFaces& faces);

// An SVG document.
std::string space_figure(const description::Scene& scene, const SceneFigureOptions& options = {});

}  // namespace wander::figure

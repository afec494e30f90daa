// A scene as a figure of its own, one column wide: the drawing in equal aspect with axes in metres,
// its name above and a legend below.
#pragma once

#include <string>

#include "core/description.h"

namespace wander::figure {

struct SceneFigureOptions {
  std::string title;  // empty: the name of the scene
};

// An SVG document.  The scene must be two-dimensional.
std::string scene_figure(const description::Scene& scene, const SceneFigureOptions& options = {});

}  // namespace wander::figure

// A scene as a figure of its own: the drawing in equal aspect with axes in metres,
// its name above and a legend below.
#pragma once

#include <string>

#include "core/description.h"
#include "draw/figure/style.h"

namespace wander::figure {

struct SceneFigureOptions {
  std::string title{};  // empty: the name of the scene
  double width = style::column_width;
};

// An SVG document.  The scene must be two-dimensional.
std::string scene_figure(const description::Scene& scene, const SceneFigureOptions& options = {});

}  // namespace wander::figure

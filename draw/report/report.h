// `report.html`: what a comparison has found, as one page that needs nothing else - no network, no
// scripts, no other file.  A verdict in words first, then the evidence, then how to repeat it.
#pragma once

#include <string>

#include "core/description.h"
#include "lab/compare/comparison.h"

namespace wander {

// The scene is that of the provenance; throws SceneFileError where its text is none, or needs meshes.
std::string report_html(const compare::Comparison& comparison);
std::string report_html(const compare::Comparison& comparison, const description::Scene& scene);

}  // namespace wander

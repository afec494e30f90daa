// `report.html`: what a comparison has found, as one page that needs nothing else - no network, no
// scripts, no other file.  A verdict in words first, then the evidence, then how to repeat it.
#pragma once

#include <string>

#include "lab/compare/comparison.h"

namespace wander {

// The scene is that of the provenance; throws SceneFileError where its text is none.
std::string report_html(const compare::Comparison& comparison);

}  // namespace wander

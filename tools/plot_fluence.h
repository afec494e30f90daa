// `wander plot SCENE --fluence`: computes the light in the space between the surfaces, and draws it
// or saves it as an image.
#pragma once

#include "lab/exit_code.h"
#include "tools/plot_options.h"

namespace wander {

// The output is a figure, or EXR where its name ends so.
ExitCode plot_fluence(const PlotOptions& options, const Global& global);

}  // namespace wander

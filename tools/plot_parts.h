// `wander plot --parts`: what samples and what chains carry of a pooled film.
#pragma once

#include <string>

#include "tools/plot_options.h"

namespace wander {

// An SVG document of the run that is named.  Throws where it does not say it.
std::string parts_svg(const PlotOptions& options);

}  // namespace wander

// `wander plot --parts`: what samples and what chains carry of a pooled film.
#pragma once

#include <string>

#include "tools/plot_film.h"
#include "tools/plot_options.h"

namespace wander {

// An SVG document.  Throws where the run does not say it.
std::string parts_svg(const Film& film, const PlotOptions& options);

}  // namespace wander

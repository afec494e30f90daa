// `wander plot` of runs of three-dimensional scenes: images, their errors and differences.
#pragma once

#include <string>

#include "tools/plot_film.h"
#include "tools/plot_options.h"

namespace wander {

// What its pixels hold.  What is drawn needs no scene that is whole, with all its meshes.
figure::Quantity value_of(const RunRecord& run);
// All files of the command line; `first` is the first of them.
std::string image_svg(Film first, const PlotOptions& options);

}  // namespace wander

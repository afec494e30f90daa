// Maps of what mutations did in each bin, where a large film has them by the cells of its raster.
#pragma once

#include <vector>

#include "core/film_estimate.h"

namespace wander {

// What is known of a cell, at each of its bins.  A map that is of bins, or of nothing, stays.
std::vector<double> on_bins(const std::vector<double>& map, const FilmEstimate& film);
// The same of counts, which the bins of a cell share.
std::vector<double> shared_by_bins(std::vector<double> counts, const FilmEstimate& film);

}  // namespace wander

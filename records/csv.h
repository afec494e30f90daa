// `film.csv` of a film with one row of bins: bin,center,value,standard_error,reliable.  Numbers are
// written with the digits that read back to the same double, whatever the locale; an unknown error
// is `nan`; a bin is reliable (1) or not (0).
#pragma once

#include <string>
#include <vector>

#include "core/description.h"
#include "records/atomic_file.h"
#include "records/rendering.h"

namespace wander {

// Where the centres of the bins lie: on a sensor shape metres of arc length from its start, on the
// film of a camera the fraction of its width in [0, 1).
std::vector<double> bin_centers(const description::Scene& scene);

std::string to_csv(const FilmEstimate& film, const std::vector<double>& centers);
void write_csv(const FilmEstimate& film, const std::vector<double>& centers, const ByteSink& file);

}  // namespace wander

// The film of samples and chains together (pooled_film.h) where it is large: the chains' part in films
// that groups share (shared_films.h), the samples' in one film of sums over samples.
//
// The error of a pixel is that of the chains' part and of b, by the jackknife over the films, and that
// of the samples' part, by their own variance, as if both were independent: they are not, for chains
// start from paths of the seed pass and b rests on it, but what one pixel has to do with either is of
// the order of one over their number.
#pragma once

#include <span>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/group_findings.h"
#include "mlt/run/large_film.h"
#include "mlt/run/pooled_film.h"

namespace wander {

// `groups`: of the first run, of the second, …
PooledFilm pooled_film(std::span<const SharedLight> runs, std::span<const GroupFindings> groups,
                       const Constant& constant, std::vector<int> shape);

// The film of the chains alone, by bins; without error bars.
FilmEstimate total_film(std::span<const SharedLight> runs, const Constant& constant,
                        std::vector<int> shape);

}  // namespace wander

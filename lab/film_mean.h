// The mean of independent films, each with error bars of its own, that count by weights which do
// not depend on what they show.
#pragma once

#include <span>

#include "core/film_estimate.h"

namespace wander {

struct WeightedFilm {
  FilmEstimate film;
  double weight;
};

// Of at least one film; all have the same shape.  The degrees of freedom are those of Satterthwaite,
// over the whole film.  A bin is reliable where it is in all films.
FilmEstimate mean_film(std::span<const WeightedFilm> films);

}  // namespace wander

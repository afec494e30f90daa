// Films of groups on fewer bins: what chains know too little of by itself, they know together.
#pragma once

#include <vector>

#include "mlt/run/film_fit.h"

namespace wander {

// All films have this shape, fastest axis last.
struct CoarseFilms {
  std::vector<FilmFitGroup> groups;
  std::vector<int> shape;

  // Takes two bins that lie side by side as one, along each axis; the last of an axis may be alone.
  // What groups found and deposited stays as much.
  void halve();
};

}  // namespace wander

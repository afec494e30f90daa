#include "mlt/run/reliability.h"

#include "core/reliability.h"
#include "mlt/run/deposit.h"

namespace wander {

std::vector<bool> reliability_of_groups(const FilmEstimate& film, std::size_t groups) {
  if (groups < static_cast<std::size_t>(GroupsFilm::fewest_groups) ||
      film.degrees_of_freedom < fewest_film_degrees)
    return std::vector<bool>(film.value.size());
  return reliability(film, EventWeight::of_groups());
}

}  // namespace wander

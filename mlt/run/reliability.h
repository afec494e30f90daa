// Which bins of a film of chains are reliable (core/reliability.h): the error that a bin claims comes from few groups.
#pragma once

#include <cstddef>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// Fewer leave an interval of 95 % next to nothing that it excludes.
inline constexpr double fewest_film_degrees = 3;

// By bin; `groups` of those that the errors rest on have found light.  None where intervals have too few degrees of freedom.
std::vector<bool> reliability_of_groups(const FilmEstimate& film, std::size_t groups);

}  // namespace wander

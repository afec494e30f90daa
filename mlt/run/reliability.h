// Which bins of a film of chains are reliable (core/reliability.h): the error that a bin claims comes from few groups.
#pragma once

#include <cstddef>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// By bin; `groups` of those that the errors rest on have found light.
std::vector<bool> reliability_of_groups(const FilmEstimate& film, std::size_t groups);

}  // namespace wander

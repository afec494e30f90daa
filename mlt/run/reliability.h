// Which bins of a film of chains are reliable: whose t-interval holds what it promises.
//
// A bin is known as n independent events would tell it when its value is √n standard errors.  The
// error that a bin claims comes from few groups, grows with what fell into the bin, and is too small
// where the value is: bins chosen by their own claim are often those that claim too little.  So what
// is asked of a bin, a hundred events (`fewest_effective_samples`), is asked of the median of the lit
// bins around it, itself among them, and of itself no more than half as many; or four times as many
// of itself, whatever lies around it.
#pragma once

#include <cstddef>

#include "core/film_estimate.h"

namespace wander {

// Around a bin of a curve lie four bins to each side; around a pixel the eight next to it, of its own
// channel.
inline constexpr int bins_to_each_side = 4;

// Fills `film.reliable`.  Values, errors and shape are there; `groups` of those that the errors rest
// on have found light.
void tell_reliable(FilmEstimate& film, std::size_t groups);

}  // namespace wander

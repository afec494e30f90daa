// Which bins of a film of chains are reliable: whose t-interval holds what it promises.
//
// A bin of value v and standard error σ is known as n = v²/σ² independent events would tell it, each of
// the weight v/n = σ²/v.  The error that a bin claims comes from few groups, grows with what fell into
// the bin, and is too small where the value is: bins chosen by their own claim are often those that
// claim too little, and a bin that has met none of the rare light around it claims least.  So the lit
// bins around it, itself among them, say what an event weighs there: w̄, the mean of their σ²/v, which
// is not small by chance as one of them may be.  By it the bin is known as v/w̄ events; of these it is asked
// three quarters of a hundred (`fewest_effective_samples`), and by its own claim a half, and that this is
// no more than six times as much.
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

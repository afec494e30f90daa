// Do two estimated films agree?  A Welch test per bin, from the values, standard errors and degrees
// of freedom that the films state, with Šidák's correction over the bins that both call reliable.
// What it would have seen is relative to the second film.
#pragma once

#include "records/rendering.h"
#include "tests/support/statistics.h"

namespace wander::test {

Decision films_agree(const FilmEstimate& a, const FilmEstimate& b, double false_alarm);

}  // namespace wander::test

// Which bins of a film are reliable: whose interval holds what it promises.
//
// A bin of value v in which an event weighs w is known as n = v/w events.  Of independent samples an event
// is one that reached the bin: w = Σ x²/Σ x, so that n = (Σ x)²/Σ x², its effective samples [Kish 1965].  Of
// groups of chains it is what the spread of the groups amounts to: w = σ²/v, n = v²/σ².
//
// What a bin claims of itself grows with what fell into it, and is too small where the value is: bins chosen by
// their own claim are often those that claim too little, and a bin that has met none of the rare light
// around it claims least.  So the lit bins around it, itself among them, say what an event weighs there: w̄, the
// mean of their w, which is not small by chance as one of them may be.  By it the bin is known as v/w̄
// events; of these it is asked three quarters of a hundred (`fewest_effective_samples`), and by its own
// claim a half, and that this is no more than six times as much.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// Of what is judged by itself alone, at least this many: then no few samples dominate it.
inline constexpr double fewest_effective_samples = 100;

// Around a bin of a curve lie four bins to each side; around a pixel the eight next to it, of its own
// channel.  So a neighbourhood has as many bins in curves and in images.
inline constexpr int bins_to_each_side = 4;
inline constexpr double bins_of_neighbourhood = 2 * bins_to_each_side + 1;

// What an event weighs in a bin of this value and error, in their units; NaN where that cannot be told.
using EventWeight = std::function<double(double value, double error)>;

// By bin; values, errors and shape of the film are there.
std::vector<bool> reliability(const FilmEstimate& film, const EventWeight& weight);
// The same of a film of independent samples.
std::vector<bool> reliability_of_samples(const FilmEstimate& film, std::uint64_t samples);

}  // namespace wander

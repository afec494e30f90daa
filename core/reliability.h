// Which bins of a film are reliable: whose interval holds what it promises.
//
// A bin of value v in which an event weighs w is known as v/w events.  Of n independent samples an event
// is one that reached the bin: w = Σ x²/Σ x over n, so that v/w = (Σ x)²/Σ x², its effective samples
// [Kish 1965].  Of groups of chains it is what their spread amounts to, w = σ²/v, with σ the standard error.
//
// What a bin claims of itself grows with what fell into it, and is too small where the value is: bins chosen by
// their own claim are often those that claim too little, and a bin that has met none of the rare light
// around it claims least.  Nor may its value decide: where bins have three quarters of a hundred events or a few less, those with
// more by chance are too bright, all of them.  So the lit bins around it, itself among them, say what an event weighs
// there: w̄, the mean of their w, which is not small by chance as one of them may be; and the others, how many events a bin
// there has, v̄/w̄ by their mean value.  Of these it is asked three quarters of a hundred, and of v/w̄, its own by that weight,
// three fifths, which few such bins lack; or of its own twice as many, where it is brighter than what is around it.  By its
// own claim it is asked a half, and that this is no more than three times v/w̄, unless that is two thousand: beside a lamp a
// wall may be known better than the lamp.
#pragma once

#include <cstdint>
#include <vector>

#include "core/film_estimate.h"

namespace wander {

// Of a sum that nothing around it is asked of, such as b, at least this many: then no few samples dominate it.
inline constexpr double fewest_effective_samples = 100;
// Of a bin by its own claim; with fewer none is reliable, whatever is around it.
inline constexpr double fewest_claimed_events = fewest_effective_samples / 2;

// Around a bin of a curve lie four bins to each side; around a pixel the eight next to it, of its own
// channel.  So a neighbourhood has as many bins in curves and in images.
inline constexpr int bins_to_each_side = 4;
inline constexpr double bins_of_neighbourhood = 2 * bins_to_each_side + 1;

// What an event weighs in a bin of this value and standard error, in their units; NaN where that cannot be told.
class EventWeight {
 public:
  // Of the mean of n samples: Σ x²/n = (n - 1) σ² + v².
  static EventWeight of_samples(std::uint64_t samples) {
    const auto n = static_cast<double>(samples);
    return {(n - 1) / n, 1 / n};
  }
  static EventWeight of_groups() { return {1, 0}; }

  double operator()(double value, double error) const {
    return of_spread_ * (error / value * error) + of_value_ * value;
  }

 private:
  EventWeight(double of_spread, double of_value) : of_spread_(of_spread), of_value_(of_value) {}

  double of_spread_, of_value_;
};

// By bin; values, errors and shape of the film are there.
std::vector<bool> reliability(const FilmEstimate& film, const EventWeight& weight);

}  // namespace wander

// The reference, made ready to measure errors with.
//
// Squares of films lit by 1e200 W would overflow: everything here is in units of `unit`, the
// largest |I|.  A bin whose standard error is not known counts as exact, and is counted.
#pragma once

#include <vector>

#include "core/film_statistics.h"
#include "lab/compare/run_errors.h"
#include "lab/compare/runs.h"

namespace wander::compare {

struct Yardstick {
  explicit Yardstick(const Reference& reference);

  FilmEstimate film;             // the reference as it came; exact ones with infinite degrees
  double unit = 1;               // W/m; what follows is in these units
  std::vector<double> value{};   // I
  std::vector<double> weight{};  // 1 / (I² + (0.01 mean I)²); empty where the reference is dark
  double mean = 0;               // mean I
  double mean_square = 0;        // mean I²
  double noise = 0;              // mean e²
  double weighted_noise = 0;     // mean weight e²
  double noise_of_mean = 0;      // mean e: of the mean of I if all bins err together
  double degrees = 0;            // of freedom, of e
  std::size_t bins_of_unknown_error = 0;
};

// How far a film is from the reference, in the yardstick's units; the reference's own error is in
// it.  NaN where the film holds a value that is not finite.
struct Distance {
  double square = not_known;    // mean (x - I)²
  double absolute = not_known;  // mean |x - I|
  double weighted = not_known;  // mean weight (x - I)²
  double mean = not_known;      // mean (x - I)
};
// Throws std::invalid_argument if the film has another number of bins than the reference.
Distance distance(const FilmEstimate& film, const Yardstick& yardstick);

RunErrors errors_of(const FilmEstimate& film, const Yardstick& yardstick);

}  // namespace wander::compare

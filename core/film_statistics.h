// Numbers that sum up a film, and one film held against another.
//
// Bins whose error cannot be told (a standard error that is not finite) take no part; a figure that
// no bin can give is NaN.
#pragma once

#include <cstddef>

#include "core/film_estimate.h"

namespace wander {

// Of luminance, if the film has colour: the normalization b.
double mean_value(const FilmEstimate& film);
// sqrt(sum se^2 / sum value^2): the error of the film in units of the film.
double relative_error(const FilmEstimate& film);
std::size_t reliable_bins(const FilmEstimate& film);
bool is_dark(const FilmEstimate& film);  // no bin is above zero

struct FilmComparison {
  double relative_rmse = 0;    // sqrt(sum (x - r)^2 / sum r^2) over all bins
  double chi2_per_degree = 0;  // mean of (x - r)^2 / (se_x^2 + se_r^2)
  double covered_share = 0;    // of bins where the 95 % t-interval of x - r holds zero
  double largest_z = 0;        // largest |x - r| / sqrt(se_x^2 + se_r^2)
  std::size_t bins = 0;        // that the last three are about: reliable in both films
};
// The films must have the same shape.
FilmComparison film_comparison(const FilmEstimate& film, const FilmEstimate& reference);

// The t with P(|T| <= t) = 0.95 for Student's distribution; below one degree of freedom, infinity.
double student_t_95(double degrees_of_freedom);

}  // namespace wander

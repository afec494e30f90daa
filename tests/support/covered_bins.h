// How many of a film's reliable bins have the truth in their 95 % t-interval.
#pragma once

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "core/film_estimate.h"

namespace wander::test {

struct CoveredBins {
  double covered = 0, reliable = 0;

  double share() const { return covered / reliable; }
};

// Error bars are scaled by `scale`.
inline CoveredBins covered_bins(const FilmEstimate& film, const std::vector<double>& exact,
                                double scale) {
  const boost::math::students_t law(film.degrees_of_freedom);
  const double reach = scale * boost::math::quantile(law, 0.975);
  CoveredBins bins;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!film.reliable[i]) continue;
    bins.reliable += 1;
    if (std::abs(film.value[i] - exact[i]) <= reach * film.standard_error[i]) bins.covered += 1;
  }
  return bins;
}

}  // namespace wander::test

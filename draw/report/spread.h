// How far the films of several seeds lie apart, held against the errors that they claim.
//
// For bin j of R replicates x_r with claimed standard errors e_r of ν degrees of freedom each,
//
//   s_j  = standard deviation of x_rj over r,   σ_j = √(mean_r e_rj²),   ratio_j = s_j / σ_j.
//
// The standard error of a film is the spread of independent groups of chains within the run, so the
// ratio is for a bin what R̂ is for a functional: between over within.  Where errors are claimed
// truly and are normal, ratio_j² has Fisher's F distribution with R - 1 and R ν degrees of freedom.
#pragma once

#include <vector>

#include "draw/report/subject.h"

namespace wander::report {

struct SeedSpread {
  std::size_t replicates = 0;
  std::vector<double> ratio{};       // per bin; NaN where no error is claimed
  double pooled = not_known;         // √(Σ s_j² / Σ σ_j²)
  compare::Interval expected{};      // holds 95 % of the ratios of single bins
  std::size_t bins = 0, beyond = 0;  // bins with a ratio, and those outside `expected`

  bool is_known() const { return bins > 0; }
  // Bins hang together, so a pooled ratio varies at most as much as that of one bin.
  bool is_wide() const { return is_known() && pooled > expected.high; }
};

SeedSpread spread_of(const std::vector<const Run*>& replicates);

}  // namespace wander::report

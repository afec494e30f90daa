// The bias of a cell, from all its replicates together.
//
// With y_r = x_r - Î and S = Σ_r y_r, in means over bins,
//   U = mean over pairs r ≠ s of y_r y_s = (|S|² - Σ |y_r|²) / (R (R - 1))
// is unbiased for |bias - ε|²; the diagonal r = s would add the variance.  Its spread is that of
// the jackknife over replicates, never too small in the mean [Efron and Stein 1981].
#pragma once

#include "lab/compare/cells.h"

namespace wander::compare {

// In the squared units of the yardstick; not known for a single replicate.
struct PairedSquare {
  double value = not_known;           // U, the reference's error inside
  double standard_error = not_known;  // with three replicates or more
};
PairedSquare paired_square(const CellRuns& runs, const Yardstick& yardstick);

// Signed root of (U - mean e²) / mean I², and its interval by the recovery of variances [Zou and
// Donner 2008] from those of U, of the reference's error, and of what both have in common. Measured
// coverage is .96 to 1; but .87 with four replicates whose bins err together, and a bias as large
// as the error.
Measured relative_bias(const PairedSquare& pairs, std::size_t replicates,
                       const Yardstick& yardstick);

// (mean film - mean I) / mean I, by Student's t over replicates and the reference's error.
Measured error_of_mean(const CellRuns& runs, const Yardstick& yardstick);

}  // namespace wander::compare

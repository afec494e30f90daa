// A contender at a budget: errors of its replicates, and what the mean square error can plausibly
// be.
//
// Against a reference Î = I + ε of standard error e, in means over bins, the replicates give
//   D̄ = mean_r (x_r - Î)²                      E D = V + |bias - ε|²
//   U = mean over pairs r ≠ s of (x_r - Î)(x_s - Î),   E U = |bias - ε|²,   V = D̄ - U
// so that m = D̄ - mean e² is unbiased for V + |bias|², and U - mean e² for |bias|².
//
// Draws of m are of D̄ (plausible.h), less the reference's error.  Nobody knows how the errors of
// its bins hang together; all err together in the worst case, ε = t e with one t for all, hence
//   m = E D - t² mean e² + 2 t √(mean e² |bias|²)
// and never less than the variance, m >= V, which needs no reference.
#pragma once

#include "lab/compare/plausible.h"
#include "lab/compare/yardstick.h"

namespace wander::compare {

struct MeasuredCell {
  Cell cell;
  double relative_mse = not_known;  // m; may be negative
  Draws draws{};                    // of it; none with one replicate
};

// The usable runs of a cell: those whose films are finite.
struct CellRuns {
  std::vector<const Run*> runs{};
  std::vector<const RunErrors*> errors{};
  TimeKind time = TimeKind::wall;
};

// `reference` are draws_of_reference(), and the cell has as many; `stream` tells cells apart.
MeasuredCell measure_cell(const CellRuns& runs, const Yardstick& yardstick, const Draws& reference,
                          std::uint32_t stream);

}  // namespace wander::compare

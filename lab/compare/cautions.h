// Reasons to doubt a comparison, each a sentence, the gravest first: runs that are missing or not
// finite, a reference that is no better than what it judges, replicates that disagree beyond their
// own error bars (one of them missed a part of the light), bias, error bars that do not cover,
// errors that do not fall like the root of time, unreliable bins.
#pragma once

#include <string>
#include <vector>

#include "lab/compare/cells.h"

namespace wander::compare {

// Spread of the replicates over what their own error bars say,
//   √( Σ_j var_r(x_rj) / Σ_j mean_r(se_rj²) )   over bins that are reliable in all of them,
// with the value that it exceeds once in a thousand times if the error bars are right: the root of
// a quantile of F with R - 1 degrees, for bins that err together, and those of the error bars.
struct Disagreement {
  double ratio = not_known, threshold = not_known;
};
Disagreement disagreement_of(const CellRuns& cell);

// `cells` are the usable runs, whose films need not be there, and how far each lie apart:
// [contender][budget].
std::vector<std::string> cautions_of(const Comparison& comparison,
                                     const std::vector<CellRuns>& cells,
                                     const std::vector<Disagreement>& disagreements,
                                     const Yardstick& yardstick);

}  // namespace wander::compare

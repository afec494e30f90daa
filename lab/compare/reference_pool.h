// A long reference from the independent runs of two methods.
//
// Its value is Σ w_m x_m, with x_m the mean film of the runs of method m (lab/film_pool.h)
// and w_m what its samples are worth by the trial (trial.h).  The trial has seeds of its own, so
// the weights know nothing of the errors of x_m, and the mean stays unbiased; weights by the
// variances that the runs claim would prefer films that miss light.
//
// What makes the reference may be a contender, too.  It gains nothing from that: no run of the
// reference shares a random number with a measured run, so that with Î = I + ε
//   E (x - Î)² = E (x - I)² + E ε²
// for the same method as for any other, and E ε² is subtracted from all alike.  All that a method
// could share with itself is light that it never finds.  Hence two methods, which must agree.
#pragma once

#include <string>
#include <vector>

#include "lab/compare/runs.h"
#include "records/rendering.h"
#include "statistics/decision.h"

namespace wander::compare {

struct Part {
  std::string made_by;
  std::vector<Rendering> runs{};  // one at least
  double weight = 1;              // against the other part's
};

// Welch's tests, bin by bin, of bins that are reliable in both, or reliable in one and dark in the
// other.  Passes where there are none.
inline constexpr double false_disagreement = 1e-3;
Decision agreement(const FilmEstimate& a, const FilmEstimate& b);

// Of one part or two.  Where two do not agree, the errors are raised to what they differ by, and
// there is a doubt; as there is if one is alone.
Reference pooled_reference(const std::vector<Part>& parts);

}  // namespace wander::compare

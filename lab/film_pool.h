// The mean of independent runs of one method as one film.
//
// With runs x_i of n_i samples each and w_i = n_i / Σ n, per bin
//   value     x = Σ w_i x_i
//   claimed   C = Σ w_i² se_i²                        [what the runs say of themselves]
//   observed  D = Σ w_i (x_i - x)² / (N - 1)          [unbiased for Var x, where Var x_i ∝ 1 / n_i]
// D of one bin has few degrees of freedom, so it is pooled over the film: where ΣD exceeds ΣC, all
// claims are raised by that factor.  A bin of which no run knows an error gets the mean of D.
#pragma once

#include <span>

#include "records/rendering.h"

namespace wander {

// Of at least one run; all have the same shape.
FilmEstimate pooled_film(std::span<const Rendering> runs);

}  // namespace wander

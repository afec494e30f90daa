// Optimal bridge sampling of b = ∫ f [Bennett 1976; Meng and Wong 1996], as reverse logistic
// regression [Geyer 1994].
//
// The seed pass is a point process of paths with intensity p̄ = Σ p_{s,t} per sample; the chains
// are draws from f / b.  Both sides tell l(x) = f(x) / p̄(x), and with r = n_M / n_B
//
//   b = E_B[Σ l / (r l + b)] / E_M[1 / (r l + b)],
//
// where E_B is over all samples, those that find nothing counted, and Σ over the paths that one
// finds.  It is where the logistic loss of telling the sides apart is least:
//   L(β) = n_B E_B[Σ log(1 + r l e^-β)] + n_M E_M[log(1 + e^β / (r l))],   b = e^β,
// which is convex.  The influence of a path is bounded, so no firefly of the seed pass dominates,
// but where chains know nothing of such light (unmet_light.h), which is left to samples.
// Any r gives a consistent estimate; the best is that of effective sizes, which the spread of the
// groups tells.  Chains that miss a part of f bias it: hence the alarm in normalization.h.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mlt/seeds/ratio_histogram.h"

namespace wander {

// One group: the paths of its slice of the seed pass, and the states of its chains.
struct BridgeGroup {
  const RatioHistogram* found;
  double samples;  // of the slice
  const RatioHistogram* states;
  double state_weight;  // of each state among those of all groups
};

struct BridgeFit {
  double b = 0;
  // b from all groups but one, for the jackknife: 0 where these found nothing, NaN where they tell nothing.
  std::vector<double> without;
  // By how much b moves with what the samples of each group found, and how many independent events would know it as well: no
  // more than there are samples.
  std::vector<double> moved;
  double effective_samples = 0;
  double balance = 1;   // r
  std::string failure;  // why there is no b; empty if there is
};

// By Ceres, which solves L'(β) = 0.  b is unknown if no path was found, or if Ceres does not converge; where chains tell nothing of
// what samples found it is what these say.  `unmet`: the share of light that chains are known not to have met (unmet_light.h).
BridgeFit bridge(std::span<const BridgeGroup> groups, double unmet = 0);

}  // namespace wander

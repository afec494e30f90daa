// How the light of a scene is distributed over the ratios l = f / p̄ of the paths that carry it, as few
// samples and states know it: S(t), the share of light with l ≥ t.
//
// Of states S is a count, but of several chains without the one that has most of its states beyond t:
// a chain that was caught there all alone knows nothing of how much light there is, and would have all
// of it left to chains.  Samples say the same by what they found (without the one that found most,
// which the caller leaves out): Σ l over those with l ≥ t, over Σ l.  Samples have seldom drawn what has a large l, and chains may not have
// come there, so S is the more of both.  What neither has seen is not nothing: the tails of l are often powers,
//   S(t) = S(t₁) (t / t₁)^-α  beyond t₁,   α = log(S(t₀) / S(t₁)) / log(t₁ / t₀),
// with t₁ as far out as S is 0.05, and S is no less than that.  α is the steepest that three pairs of
// quantiles know, 0.3 and 0.05, 0.15 and 0.025, 0.05 and 0.0125: between the light of two parts of path space, such as
// what is seen and what is a caustic, S is flat, and no tail.  Where l is bounded S falls steeply, and
// the power law adds nothing.
//
// S so is above what it may be, and E_π[g] of all g that grow with l: it errs for the chains' side of a
// partition (partition.h), whose fault is the smaller one.
#pragma once

#include <span>
#include <vector>

#include "mlt/seeds/ratio_histogram.h"

namespace wander {

class LightByRatio {
 public:
  // Of samples, what they found; of each chain, l of its states.  Either may be empty.
  LightByRatio(const RatioHistogram& found, std::span<const RatioHistogram> chains);

  // E_π[g(l)]
  template <class G>
  double mean(G&& g) const {
    double total = 0;
    for (const Cell& cell : cells_) total += cell.light * g(cell.ratio);
    return total;
  }

 private:
  struct Cell {
    double ratio, light;  // l, and the share of light that has it
  };
  std::vector<Cell> cells_;
};

}  // namespace wander

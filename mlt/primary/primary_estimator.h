// From steps in primary sample space to a film: what the sample at each end of a step u→v deposits,
// as a multiple of its splats' shares of C*, so that a bin is bins / N · Σ deposits over N steps.
//
// b_g is the group's own constant, the mean C* of its slice of the seed pass.
#pragma once

#include <string_view>

#include "mlt/primary/primary_chain.h"
#include "mlt/run/deposit.h"

namespace wander {

struct PrimaryConstants {
  double own;         // b_g
  double others;      // b_0: the same of all other groups, hence independent of this one
  double large_step;  // p
};

struct PrimaryDeposit {
  double current, proposed;
};

// Splat by splat: put(sample, vertices, bin, weight, colour).
template <class Sample, class Put>
void for_each_deposit(const PrimaryStep<Sample>& step, PrimaryDeposit weights, Put&& put) {
  const auto split = [&put](const Sample& sample, double weight) {
    if (!(weight > 0)) return;
    sample.for_each_share([&](int vertices, int bin, double share, const auto& colour) {
      put(sample, vertices, bin, weight * share, colour);
    });
  };
  split(step.current, weights.current);
  split(step.proposed, weights.proposed);
}

// Expected values [Veach 1997, 11.3.2]: 1 - a of b_g at u, and a of b_g at v.
struct ExpectedValues {
  static constexpr bool needs_seed = true;

  template <class Sample>
  static PrimaryDeposit deposit(const PrimaryStep<Sample>& step, const PrimaryConstants& b) {
    return {b.own * (1 - step.acceptance), b.own * step.acceptance};
  }
};

// Kelemen's weights: every large step, accepted or not, is also an independent sample of the film,
// and the balance heuristic joins the two [Kelemen et al. 2002, section 3.4].  With w(C) = C/b_0,
//   Metropolis part   w/(w + p)  of what expected values deposit,
//   uniform part      p/(w + p)  of C*(v) / p, for each large step.
// The two fractions sum to one whatever b_0 is, so that each part may be estimated without bias by
// its own means: the first with b_g, from the seeds that b_g came with; the second, which needs no
// constant, with the expected number p N of large steps.  Together, with m(C) = C / (C + p b_0),
//   current   b_g (1 - a) m(C_u)          proposed   (b_g a + [large] b_0) m(C_v).
// With b_0 = b_g = b this is Kelemen's formula, (1 - a) / (C/b + p) and (a + [large]) / (C/b + p)
// times C.  A b_0 that knew the group's own slice would be biased, and so would be a group that
// took no large steps because its slice is dark.
struct KelemenWeights {
  static constexpr bool needs_seed = false;

  template <class Sample>
  static PrimaryDeposit deposit(const PrimaryStep<Sample>& step, const PrimaryConstants& b) {
    const double uniform = step.move == PrimaryMove::large ? b.others : 0;
    return {b.own * (1 - step.acceptance) * metropolis_share(step.current.total, b),
            (b.own * step.acceptance + uniform) * metropolis_share(step.proposed.total, b)};
  }

 private:
  static double metropolis_share(double total, const PrimaryConstants& b) {
    return total > 0 ? total / (total + b.large_step * b.others) : 0;
  }
};

}  // namespace wander

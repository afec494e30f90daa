// The large step: a path that owes nothing to the present one.  Length, technique and random
// numbers are fresh: n with a fixed pmf q, s uniform among the techniques of that length.
//
//   T(x→y) = q(n_y) / |techniques(n_y)| Σ_s p_s(y),  a = min(1, [f / T](y) / [f / T](x)).
// The sum over techniques is the density whichever of them made y.  It changes lengths and makes
// any mixture ergodic.  Measure: area product.
#pragma once

#include <vector>

#include "mlt/mutation.h"
#include "mlt/single_technique.h"

namespace wander {

struct PrimaryLarge {
  static constexpr std::string_view name = "primary_large";
  std::vector<double> length_pmf;  // q(n) at n - 2; sums to 1

  explicit PrimaryLarge(int max_vertices)
      : length_pmf(static_cast<std::size_t>(max_vertices) - 1, 1.0 / (max_vertices - 1)) {}

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const int n = 2 + random.choose(length_pmf);
    const int s = random.choose(technique_count(space, n));
    const Reason flaw = sample_technique(space, y, n, s, random);
    if (flaw != Reason::none) return Failure{flaw};
    measure(space, y);
    return Proposal{density(space, y), density(space, x)};
  }

 private:
  template <class Space>
  Scaled density(const Space& space, const Path<typename Space::Universe>& z) const {
    const double q = length_pmf[static_cast<std::size_t>(z.size()) - 2];
    return Scaled(q / technique_count(space, z.size())) * z.intensity;
  }
};

}  // namespace wander

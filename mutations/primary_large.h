// The large step: a path that owes nothing to the present one.  Length, technique and random
// numbers are fresh, with a pmf q(n, s) = q(n) q(s | n).
//
//   T(x→y) = Σ_s q(n_y, s) p_s(y),  a = min(1, [f / T](y) / [f / T](x))
// The sum over techniques is the density whichever of them made y.  It changes lengths and makes
// any mixture ergodic.  Measure: area product.
//
// q is uniform, or what a seed pass has found: the share of b that each technique carried there
// under the balance heuristic, which is one step of expectation maximization of ∫ f log T from the
// uniform q; mixed with the uniform one, so that nothing that was not found becomes impossible.
#pragma once

#include <vector>

#include "mlt/mutation.h"
#include "mlt/primary/single_technique.h"
#include "mlt/traits.h"
#include "mutations/primary.h"

namespace wander {

class PrimaryLarge {
 public:
  static constexpr std::string_view name = "primary_large";
  // Of q, after a seed pass.
  static constexpr double uniform_part = 0.25;

  explicit PrimaryLarge(int max_vertices)
      : length_pmf_(static_cast<std::size_t>(max_vertices) - 1, 1.0 / (max_vertices - 1)),
        technique_pmf_(max_vertices) {
    for (int n = 2; n <= technique_pmf_.most(); ++n)
      std::ranges::fill(technique_pmf_.row(n), 1.0 / (n + 1));
  }

  void learn(const SeedTally& seeds) {
    const double b = seeds.total.value();
    if (!(b > 0)) return;
    for (std::size_t k = 0; k < length_pmf_.size(); ++k)
      mix(length_pmf_[k], seeds.sum[k].value() / b);
    for (int n = 2; n <= technique_pmf_.most(); ++n) {
      double total = 0;
      for (const double share : seeds.techniques.row(n)) total += share;
      if (!(total > 0)) continue;
      for (std::size_t s = 0; s < technique_pmf_.row(n).size(); ++s)
        mix(technique_pmf_.row(n)[s], seeds.techniques.row(n)[s] / total);
    }
  }

  template <class Space>
  double applicability(const Space&, const Path<typename Space::Universe>&) const {
    return 1;
  }

  template <class Space, class Random>
  Proposed propose(const Space& space, const Path<typename Space::Universe>& x,
                   Path<typename Space::Universe>& y, Random& random) const {
    const int n = 2 + random.choose(length_pmf_);
    const int s = technique_pmf_.has(n) ? random.choose(technique_pmf_.row(n))
                                        : random.choose(technique_count(space, n));
    const Reason flaw = sample_technique(space, y, n, s, random);
    if (flaw != Reason::none) return Failure{flaw};
    weigh(space, y);
    return Proposal{density(space, y), density(space, x)};
  }

 private:
  static void mix(double& q, double found) { q = uniform_part * q + (1 - uniform_part) * found; }

  // Σ_s q(n, s) p_s(z), with p_s = w_s Σ p.
  template <class Space>
  Scaled density(const Space& space, const Path<typename Space::Universe>& z) const {
    const int n = z.size();
    double q = 0;
    if (technique_pmf_.has(n)) {
      const auto row = technique_pmf_.row(n);
      for (std::size_t s = 0; s < row.size(); ++s) q += row[s] * z.weights()[s];
    } else {
      q = 1.0 / technique_count(space, n);
    }
    return Scaled(length_pmf_[static_cast<std::size_t>(n) - 2] * q) * z.intensity;
  }

  std::vector<double> length_pmf_;  // q(n) at n - 2; sums to 1
  TechniqueTable technique_pmf_;    // q(s | n); beyond the table, uniform
};

template <>
inline constexpr Traits<PrimaryLarge> traits<PrimaryLarge>{
    .word = primary_word,
    .auto_weight = primary_auto_weight,
    .share = [](double large_step) { return large_step; },
    .learn = [](PrimaryLarge& m, const SeedTally& seeds) { m.learn(seeds); }};

}  // namespace wander

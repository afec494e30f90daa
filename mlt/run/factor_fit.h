// The factor b between two films by least squares: I_j ≈ b p_j, where both have errors of their own
// [effective variance; Orear 1982]: the b of the least Σ_j (I_j - b p_j)²/(v_j + b² Var p_j).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace wander {

// v_j and Var p_j.
struct FactorVariances {
  const std::vector<double>&found, &shape;

  double of_residual(std::size_t j, double b) const { return found[j] + b * b * shape[j]; }
};

struct Factor {
  double b, chi2;
};

// By Ceres, from b0 > 0.
std::optional<Factor> fit_factor(const std::vector<double>& found, const std::vector<double>& shape,
                                 const FactorVariances& variances, double b0);

// The same where b is about b0 already, by Gauss and Newton alone, for a jackknife asks hundreds of times; by
// Ceres where that fails.  NaN where it fails, too.
double refined_factor(const std::vector<double>& found, const std::vector<double>& shape,
                      const FactorVariances& variances, double b0);

}  // namespace wander

#include "mlt/run/factor_fit.h"

#include <ceres/ceres.h>

#include <cmath>
#include <limits>

#include "mlt/run/solver_log.h"

namespace wander {

namespace {

using Film = std::vector<double>;

// Of ln b.
constexpr double tolerance = 1e-11;
constexpr int most_iterations = 50;

// (I_j - b p_j) / √(v_j + b² Var p_j) with b = b_0 e^β, over all bins.
class Residuals : public ceres::CostFunction {
 public:
  Residuals(const Film& found, const Film& shape, const FactorVariances& variances, double b0)
      : found_(found), shape_(shape), variances_(variances), b0_(b0) {
    set_num_residuals(static_cast<int>(found.size()));
    mutable_parameter_block_sizes()->push_back(1);
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const double b = b0_ * std::exp(parameters[0][0]);
    for (std::size_t j = 0; j < found_.size(); ++j) {
      const double variance = variances_.of_residual(j, b), sigma = std::sqrt(variance);
      residuals[j] = (found_[j] - b * shape_[j]) / sigma;
      if (jacobians && jacobians[0])
        jacobians[0][j] =
            -b * (shape_[j] / sigma + residuals[j] * b * variances_.shape[j] / variance);
    }
    return std::isfinite(b);
  }

 private:
  const Film &found_, &shape_;
  FactorVariances variances_;
  double b0_;
};

}  // namespace

std::optional<Factor> fit_factor(const Film& found, const Film& shape,
                                 const FactorVariances& variances, double b0) {
  silence_solver();
  ceres::Problem problem;
  double beta = 0;
  problem.AddResidualBlock(new Residuals(found, shape, variances, b0), nullptr, &beta);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.function_tolerance = 1e-15;
  options.parameter_tolerance = 1e-12;
  options.gradient_tolerance = 1e-12;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const double b = b0 * std::exp(beta);
  if (!summary.IsSolutionUsable() || !std::isfinite(b) || !(b > 0)) return std::nullopt;
  return Factor{b, 2 * summary.final_cost};
}

double refined_factor(const Film& found, const Film& shape, const FactorVariances& variances,
                      double b0) {
  const Residuals problem(found, shape, variances, b0);
  Film residuals(found.size()), slopes(found.size());
  double beta = 0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double* parameters = &beta;
    double* jacobian = slopes.data();
    if (!problem.Evaluate(&parameters, residuals.data(), &jacobian)) break;
    double above = 0, below = 0;
    for (std::size_t j = 0; j < residuals.size(); ++j) {
      above += residuals[j] * slopes[j];
      below += slopes[j] * slopes[j];
    }
    beta -= above / below;
    if (std::abs(above) <= tolerance * below) return b0 * std::exp(beta);
  }
  const std::optional<Factor> factor = fit_factor(found, shape, variances, b0);
  return factor ? factor->b : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace wander

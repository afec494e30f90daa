#include "mlt/run/bridge.h"

#include <ceres/ceres.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "core/film_estimate.h"
#include "mlt/run/bridge_cells.h"
#include "mlt/run/solver_log.h"
#include "statistics/squared.h"
#include "work/parallel.h"

namespace wander {

namespace {

// The derivative of the loss of bridge.h over β = log(b / b_direct) vanishes where both of its
// parts are equal; the logarithm of their quotient is nearly a straight line.
//   log Σ_B P(l) - log Σ_M r (1 - P(l)),  P(l) = r l e^-β / (1 + r l e^-β)
class Score : public ceres::SizedCostFunction<1, 1> {
 public:
  Score(std::span<const Cell> cells, double balance) : cells_(cells), balance_(balance) {}

  bool Evaluate(double const* const* parameters, double* residual,
                double** jacobians) const override {
    const double unit = balance_ * std::exp(-parameters[0][0]);
    double found = 0, states = 0, slope_found = 0, slope_states = 0;
    for (const Cell& c : cells_) {
      const double p = unit * c.found_ratio / (1 + unit * c.found_ratio);
      const double q = 1 / (1 + unit * c.state_ratio);
      found += c.found * p;
      states += balance_ * c.states * q;
      slope_found -= c.found * p * (1 - p);
      slope_states += balance_ * c.states * q * (1 - q);
    }
    residual[0] = std::log(found / states);
    if (jacobians && jacobians[0]) jacobians[0][0] = slope_found / found - slope_states / states;
    return std::isfinite(residual[0]);
  }

 private:
  std::span<const Cell> cells_;
  double balance_;
};

constexpr double closest = 1e-10;  // of the two parts, relatively

// Where the loss is least.
std::optional<double> solve(std::span<const Cell> cells, double balance, double start) {
  double beta = start;
  silence_solver();
  ceres::Problem problem;
  problem.AddResidualBlock(new Score(cells, balance), nullptr, &beta);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.max_num_iterations = 100;
  options.function_tolerance = 0;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-14;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  const bool is_solved = summary.IsSolutionUsable() && std::sqrt(2 * summary.final_cost) < closest;
  return is_solved ? std::optional(beta) : std::nullopt;
}

// The same from close by, by Newton alone, for a jackknife asks for each group; by Ceres where that fails.
std::optional<double> refined(std::span<const Cell> cells, double balance, double start) {
  constexpr int most_iterations = 20;
  const Score score(cells, balance);
  double beta = start;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double* parameters = &beta;
    double residual = 0, slope = 0;
    double* jacobian = &slope;
    if (!score.Evaluate(&parameters, &residual, &jacobian)) break;
    if (std::abs(residual) < closest) return beta;
    beta -= residual / slope;
  }
  return solve(cells, balance, start);
}

// What the samples of each group bring to b beyond their share of it, in its units: by E_B[Σ h] of the cells, of whose light
// that is a measure, and by what they found elsewhere.
std::vector<double> moved_by(const Cells& cells, double balance, double beta, double elsewhere) {
  const auto h = [&](double l) { return l / (balance * l + std::exp(beta)); };
  double mean = 0;
  for (const Cell& c : cells.all()) mean += c.found * h(c.found_ratio);
  const double light = std::exp(beta) / mean;  // of a unit of E_B[Σ h]
  std::vector<double> moved;
  for (std::size_t g = 0; g < cells.groups(); ++g) {
    const double paths = cells.sums_of(g, h, [](double) { return 0.0; }).paths;
    const double found = light * paths + (elsewhere > 0 ? cells.unmet_light_of(g) : 0);
    moved.push_back((found - cells.samples_of(g) * (light * mean + elsewhere)) / cells.samples());
  }
  return moved;
}

// How many independent events would tell b as well as what moves it does.
double effective_samples(const std::vector<double>& moved, double b, double samples) {
  double spread = 0;
  for (const double of_group : moved) spread += squared(of_group / b);
  return spread > 0 ? std::min(1 / spread, samples) : samples;
}

// What m, a function of l, would vary by because of light that samples know and chains have not come to.  Where chains
// hardly mix, those that all began elsewhere are alike, which says nothing of one that had begun there; and groups that have
// a large part of the states may all have begun elsewhere.  What chance explains is none: neither that of the octave nor that
// of b, whose relative variance is `of_b`.
template <class M>
double unseen_variance(const Cells& cells, double b, double of_b, M&& m, double mean) {
  // Standard errors that may be: three, were groups many and alike.
  constexpr double luck = 1.35e-3;
  const boost::math::students_t spread(std::max(1.0, cells.groups_with_states() - 1));
  const double chance = boost::math::quantile(boost::math::complement(spread, luck));
  double variance = 0;
  for (const Cells::Octave& octave : cells.octaves(b, m)) {
    const double share = octave.light / b, lacking = share - octave.states;
    const double error = std::sqrt(squared(octave.error) + of_b * squared(share));
    if (lacking > chance * error) variance += lacking * squared(octave.mean - mean);
  }
  return variance;
}

// How many independent draws tell E_M[m] as well as the chains do; of what they have not seen, as many as there are groups,
// and where all their states are alike.
// `of_samples`: the relative variance that they leave b.  `unmet`: a share of light of which nobody knows the l, which is taken
// for large, where m is nothing.
template <class M>
double size_of_states(const Cells& cells, double b, double of_samples, double unmet, M&& m) {
  double mean = 0, variance = 0, spread = 0;  // of the mean of all groups
  for (const Cell& c : cells.all()) mean += c.states * m(c.state_ratio);
  for (const Cell& c : cells.all()) variance += c.states * squared(m(c.state_ratio) - mean);
  const auto nothing = [](double) { return 0.0; };
  for (std::size_t g = 0; g < cells.groups(); ++g) {
    const auto sums = cells.sums_of(g, nothing, m);
    spread += squared((sums.states - sums.mass * mean) / cells.state_mass());
  }
  const double groups = cells.groups_with_states();
  const double unseen =
      std::max(unseen_variance(cells, b, of_samples + spread / squared(mean), m, mean),
               unmet * squared(mean));
  constexpr double rounding = 1e-20;
  if (!(variance + unseen > rounding * squared(mean))) return groups;
  return (variance + unseen) / (spread + unseen / groups);
}

// The same of E_B[Σ h], were paths that are found independent.
template <class H>
double size_of_samples(const Cells& cells, H&& h) {
  double mean = 0, square = 0, spread = 0;
  for (const Cell& c : cells.all()) {
    mean += c.found * h(c.found_ratio);
    square += c.found * squared(h(c.found_ratio));
  }
  for (std::size_t g = 0; g < cells.groups(); ++g) {
    const auto sums = cells.sums_of(g, h, [](double) { return 0.0; });
    spread += squared((sums.paths - cells.samples_of(g) * mean) / cells.samples());
  }
  return square / spread;
}

// n_M / n_B: how many independent draws tell as much as each side does.  Where its groups show none, `balance` stays.
double best_balance(const Cells& cells, double balance, double beta, double unmet) {
  const double b = std::exp(beta);
  const auto h = [&](double l) { return l / (balance * l + b); };
  const auto m = [&](double l) { return 1 / (balance * l + b); };
  const double of_samples =
      1 / effective_samples(moved_by(cells, balance, beta, 0), b, cells.samples());
  const double ratio = size_of_states(cells, b, of_samples, unmet, m) / size_of_samples(cells, h);
  return std::isfinite(ratio) && ratio > 0 ? ratio : balance;
}

// b of all groups but one.  Where only this one found anything, nothing; where only its chains made states, what samples say.
double b_without(const Cells& cells, std::size_t group, double balance, double beta) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!cells.has_samples_without(group)) return unknown;
  if (!cells.has_found_without(group))
    return cells.direct() * cells.light_of_samples_without(group);
  if (!cells.has_states_without(group)) return cells.direct_without(group);
  const std::optional<double> part = refined(cells.without(group), balance, beta);
  return part ? cells.direct() * (std::exp(*part) + cells.light_of_samples_without(group))
              : unknown;
}

// Where chains tell nothing.
BridgeFit of_samples(const Cells& cells) {
  BridgeFit fit;
  fit.b = cells.direct();
  fit.balance = 0;
  for (std::size_t g = 0; g < cells.groups(); ++g) {
    const bool is_all = !cells.has_samples_without(g);
    fit.without.push_back(is_all ? not_known : cells.direct_without(g));
    const double share = cells.samples_of(g) / cells.samples();
    fit.moved.push_back(is_all ? 0 : (1 - share) * (fit.b - fit.without[g]));
  }
  fit.effective_samples = effective_samples(fit.moved, fit.b, cells.samples());
  return fit;
}

}  // namespace

BridgeFit bridge(std::span<const BridgeGroup> groups, double unmet) {
  BridgeFit fit;
  const Cells cells(groups);
  if (!(cells.direct() > 0)) {
    fit.failure = "it needs paths of the seed pass and states of chains";
    return fit;
  }
  if (!cells.has_states() || !cells.has_found()) return of_samples(cells);
  fit.balance = cells.balance_at_first();
  std::optional<double> beta = solve(cells.all(), fit.balance, 0);
  for (int round = 0; round < 2 && beta && groups.size() > 1; ++round) {
    fit.balance = best_balance(cells, fit.balance, *beta, unmet);
    beta = solve(cells.all(), fit.balance, *beta);
  }
  if (!beta) {
    fit.failure = "the logistic fit did not converge";
    return fit;
  }
  fit.b = cells.direct() * (std::exp(*beta) + cells.light_of_samples());
  fit.moved = moved_by(cells, fit.balance, *beta, cells.light_of_samples());
  for (double& moved : fit.moved) moved *= cells.direct();
  fit.effective_samples = effective_samples(fit.moved, fit.b, cells.samples());
  fit.without.resize(groups.size());
  in_parallel(groups.size(),
              [&](std::size_t g) { fit.without[g] = b_without(cells, g, fit.balance, *beta); });
  return fit;
}

}  // namespace wander

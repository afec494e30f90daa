#include "mlt/run/bridge.h"

#include <ceres/ceres.h>

#include <cmath>
#include <limits>
#include <optional>

#include "mlt/run/solver_log.h"
#include "work/parallel.h"

namespace wander {

namespace {

// Paths whose l is about the same: of each side its mean l, in units of the direct estimate, and
// how many there are, per sample of the seed pass and as a share of all states.
struct Cell {
  double found_ratio, state_ratio;
  double found, states;
};

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

// The cells of all groups together, and what each group adds to them.
class Cells {
 public:
  explicit Cells(std::span<const BridgeGroup> groups) : groups_(groups) {
    RatioHistogram found, states;
    for (const BridgeGroup& g : groups) {
      samples_ += g.samples;
      found_count_ += g.found->count();
      state_count_ += g.states->count();
      found.add(*g.found, 1);
      states.add(*g.states, g.state_weight);
      state_mass_.push_back(g.state_weight * g.states->count());
      all_states_ += state_mass_.back();
    }
    double total = 0;
    for (int i = found.first(); i < found.end(); ++i) total += found[i].sum;
    direct_ = total / samples_;
    const int low = std::min(found.first(), states.first());
    for (int i = low; i < std::max(found.end(), states.end()); ++i) {
      const RatioHistogram::Bin f = found[i], s = states[i];
      if (f.count + s.count == 0) continue;
      cells_.push_back({f.count > 0 ? f.sum / f.count / direct_ : 1,
                        s.count > 0 ? s.sum / s.count / direct_ : 1, f.count / samples_,
                        s.count / all_states_});
      bins_.push_back(i);
    }
  }

  double direct() const { return direct_; }
  double samples() const { return samples_; }
  bool has_states() const { return all_states_ > 0; }
  // Until the groups tell: few states know no more than as many samples.
  double balance_at_first() const { return std::min(1.0, state_count_ / samples_); }
  std::span<const Cell> all() const { return cells_; }

  // What is left of a side without a group, but for rounding.
  bool has_samples_without(std::size_t group) const { return samples_ > groups_[group].samples; }
  bool has_found_without(std::size_t group) const {
    return found_count_ > (1 + rounding) * groups_[group].found->count();
  }
  bool has_states_without(std::size_t group) const {
    return state_count_ > (1 + rounding) * groups_[group].states->count();
  }
  // The direct estimate, of samples alone.
  double direct_without(std::size_t group) const {
    const BridgeGroup& g = groups_[group];
    double total = 0;
    for (std::size_t k = 0; k < cells_.size(); ++k)
      total += std::max(0.0, cells_[k].found * samples_ * cells_[k].found_ratio * direct_ -
                                 (*g.found)[bins_[k]].sum);
    return total / (samples_ - g.samples);
  }
  // Where something is left of both sides.
  std::vector<Cell> without(std::size_t group) const {
    const BridgeGroup& g = groups_[group];
    const double samples = samples_ - g.samples, states = all_states_ - state_mass_[group];
    std::vector<Cell> cells(cells_.size());
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      const Cell& c = cells_[k];
      const double their_states = g.state_weight * (*g.states)[bins_[k]].count;
      cells[k] = {c.found_ratio, c.state_ratio,
                  std::max(0.0, c.found * samples_ - (*g.found)[bins_[k]].count) / samples,
                  std::max(0.0, c.states * all_states_ - their_states) / states};
    }
    return cells;
  }

  // Σ over cells of a group: found paths weighted by h, states by m.
  struct Sums {
    double paths = 0, states = 0, mass = 0;
  };
  template <class H, class M>
  Sums sums_of(std::size_t group, H&& h, M&& m) const {
    const BridgeGroup& g = groups_[group];
    Sums sums{.mass = state_mass_[group]};
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      sums.paths += (*g.found)[bins_[k]].count * h(cells_[k].found_ratio);
      sums.states += g.state_weight * (*g.states)[bins_[k]].count * m(cells_[k].state_ratio);
    }
    return sums;
  }
  std::size_t groups() const { return groups_.size(); }
  double samples_of(std::size_t group) const { return groups_[group].samples; }
  double state_mass() const { return all_states_; }

 private:
  static constexpr double rounding = 1e-9;

  std::span<const BridgeGroup> groups_;
  double samples_ = 0, all_states_ = 0, direct_ = 0, found_count_ = 0, state_count_ = 0;
  std::vector<double> state_mass_;
  std::vector<Cell> cells_;
  std::vector<int> bins_;
};

// n_M / n_B: how many independent draws tell as much as each side does.  A side's own variance,
// were its paths independent, over the variance that its groups show.  Where these show none, `balance` stays.
double best_balance(const Cells& cells, double balance, double beta) {
  const auto h = [&](double l) { return l / (balance * l + std::exp(beta)); };
  const auto m = [&](double l) { return 1 / (balance * l + std::exp(beta)); };
  double mean_h = 0, square_h = 0, mean_m = 0, square_m = 0;
  for (const Cell& c : cells.all()) {
    mean_h += c.found * h(c.found_ratio);
    square_h += c.found * h(c.found_ratio) * h(c.found_ratio);
    mean_m += c.states * m(c.state_ratio);
    square_m += c.states * m(c.state_ratio) * m(c.state_ratio);
  }
  double spread_h = 0, spread_m = 0;  // of the means of all groups
  for (std::size_t g = 0; g < cells.groups(); ++g) {
    const auto sums = cells.sums_of(g, h, m);
    const double dh = (sums.paths - cells.samples_of(g) * mean_h) / cells.samples();
    const double dm = (sums.states - sums.mass * mean_m) / cells.state_mass();
    spread_h += dh * dh;
    spread_m += dm * dm;
  }
  const double size_h = square_h / spread_h, size_m = (square_m - mean_m * mean_m) / spread_m;
  const double ratio = size_m / size_h;
  return std::isfinite(ratio) && ratio > 0 ? ratio : balance;
}

// How many independent events would tell E_B[Σ h] as well as the groups do.
double effective_samples(const Cells& cells, double balance, double beta) {
  const auto h = [&](double l) { return l / (balance * l + std::exp(beta)); };
  double mean = 0, spread = 0;
  for (const Cell& c : cells.all()) mean += c.found * h(c.found_ratio);
  for (std::size_t g = 0; g < cells.groups(); ++g) {
    const double paths = cells.sums_of(g, h, [](double) { return 0.0; }).paths;
    const double d = (paths - cells.samples_of(g) * mean) / cells.samples();
    spread += d * d;
  }
  return spread > 0 ? std::min(mean * mean / spread, cells.samples()) : cells.samples();
}

// b of all groups but one.  Where only this one found anything, nothing; where only its chains made states, what samples say.
double b_without(const Cells& cells, std::size_t group, double balance, double beta) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (!cells.has_samples_without(group)) return unknown;
  if (!cells.has_found_without(group)) return 0;
  if (!cells.has_states_without(group)) return cells.direct_without(group);
  const std::optional<double> part = refined(cells.without(group), balance, beta);
  return part ? cells.direct() * std::exp(*part) : unknown;
}

}  // namespace

BridgeFit bridge(std::span<const BridgeGroup> groups) {
  BridgeFit fit;
  const Cells cells(groups);
  if (!(cells.direct() > 0) || !cells.has_states()) {
    fit.failure = "it needs paths of the seed pass and states of chains";
    return fit;
  }
  fit.balance = cells.balance_at_first();
  std::optional<double> beta = solve(cells.all(), fit.balance, 0);
  for (int round = 0; round < 2 && beta && groups.size() > 1; ++round) {
    fit.balance = best_balance(cells, fit.balance, *beta);
    beta = solve(cells.all(), fit.balance, *beta);
  }
  if (!beta) {
    fit.failure = "the logistic fit did not converge";
    return fit;
  }
  fit.b = cells.direct() * std::exp(*beta);
  fit.effective_samples = effective_samples(cells, fit.balance, *beta);
  fit.without.resize(groups.size());
  in_parallel(groups.size(),
              [&](std::size_t g) { fit.without[g] = b_without(cells, g, fit.balance, *beta); });
  return fit;
}

}  // namespace wander

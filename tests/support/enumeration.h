// All outcomes of a random program, one after the other, with their probabilities; and from them
// the transition matrix of a chain in Pointland:
//
//   P(x→y) = Σ_choices Pr(choices) a(x→y) [y ≠ x],   P(x→x) = 1 - Σ_{y ≠ x} P(x→y)
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "mlt/chain.h"
#include "tests/support/pointland.h"

namespace wander::test {

// What is exact but for rounding is within.
inline constexpr double rounding = 1e-13;

// A source of choices instead of random numbers.  Each run replays the choices that led to the last
// outcome up to one that still has an alternative, and takes the next (depth first).  A pmf that
// does not sum to one is an error at once.
class Enumeration {
 public:
  static constexpr double tolerance = 1e-13;

  int choose(std::span<const double> pmf) {
    if (depth_ == choices_.size()) push(pmf);
    const std::vector<double>& level = levels_[depth_];
    if (level.size() != pmf.size()) throw std::logic_error("a choice depends on hidden state");
    probability_ *= level[static_cast<std::size_t>(choices_[depth_])];
    return choices_[depth_++];
  }
  int choose(int count) {
    if (count < 1) throw std::logic_error("a choice among nothing");
    uniform_.assign(static_cast<std::size_t>(count), 1.0 / count);
    return choose(std::span<const double>(uniform_));
  }
  // The acceptance test u < a of a chain comes out negative: its state never moves, and what would
  // have happened is read from the acceptance probability.
  double uniform() { return 1; }

  double probability() const { return probability_; }
  std::span<const int> choices() const { return std::span(choices_).first(depth_); }

  // To the next outcome; false when there is none.
  bool advance() {
    choices_.resize(depth_);
    probability_ = 1;
    for (; depth_ > 0; --depth_) {
      const int next = possible(levels_[depth_ - 1], choices_.back() + 1);
      if (next >= 0) {
        choices_.back() = next;
        depth_ = 0;
        return true;
      }
      choices_.pop_back();
    }
    return false;
  }

 private:
  static int possible(const std::vector<double>& pmf, int first) {
    for (std::size_t i = static_cast<std::size_t>(first); i < pmf.size(); ++i)
      if (pmf[i] > 0) return static_cast<int>(i);
    return -1;
  }
  void push(std::span<const double> pmf) {
    double total = 0;
    for (const double p : pmf) {
      if (!(p >= 0)) throw std::logic_error("a probability is negative, or no number");
      total += p;
    }
    if (!(std::abs(total - 1) < tolerance)) throw std::logic_error("a pmf does not sum to one");
    if (levels_.size() <= depth_) levels_.emplace_back();
    levels_[depth_].assign(pmf.begin(), pmf.end());
    choices_.push_back(possible(levels_[depth_], 0));
  }

  std::vector<std::vector<double>> levels_;  // kept, to be filled again without allocating
  std::vector<int> choices_;
  std::vector<double> uniform_;
  std::size_t depth_ = 0;
  double probability_ = 1;
};

// All light paths of a graph, and the chain's target π = f / Σ f.
class StateSpace {
 public:
  explicit StateSpace(const Graph& graph) : nodes_(graph.nodes()) {
    for (const Nodes& nodes : graph.light_paths()) {
      states_.push_back(graph.path(nodes));
      target_.push_back(graph.target(nodes));
      const std::size_t c = code(states_.back());
      if (c >= indices_.size()) indices_.resize(c + 1, -1);
      indices_[c] = size() - 1;
    }
    pi_ = Eigen::Map<const Eigen::VectorXd>(target_.data(), size());
    pi_ /= pi_.sum();
  }

  int size() const { return static_cast<int>(states_.size()); }
  const PointPath& operator[](int i) const { return states_[static_cast<std::size_t>(i)]; }
  double target(int i) const { return target_[static_cast<std::size_t>(i)]; }
  const Eigen::VectorXd& pi() const { return pi_; }

  int index_of(const PointPath& x) const {
    const std::size_t c = code(x);
    const int index = c < indices_.size() ? indices_[c] : -1;
    if (index < 0) throw std::logic_error("a path was proposed that has f = 0");
    return index;
  }

 private:
  // The nodes of a path as the digits of a number; no digit is zero.
  std::size_t code(const PointPath& x) const {
    std::size_t c = 0;
    for (int i = 0; i < x.size(); ++i)
      c = c * (static_cast<std::size_t>(nodes_) + 1) + static_cast<std::size_t>(x[i].place.node) +
          1;
    return c;
  }

  int nodes_;
  std::vector<PointPath> states_;
  std::vector<double> target_;
  std::vector<int> indices_;  // by code; -1: no state
  Eigen::VectorXd pi_;
};

// Calls visit(x, step, choices) for every outcome of one step of a chain from every state x.
template <class Kernel, class Visit>
void for_each_step(const Graph& graph, const StateSpace& states, const Kernel& kernel,
                   Visit&& visit) {
  for (int x = 0; x < states.size(); ++x) {
    Chain<Graph, Kernel> chain(graph, kernel, states[x]);
    Enumeration choices;
    do {
      chain.step(choices, [&](const Step<Pointland>& step) { visit(x, step, choices); });
    } while (choices.advance());
  }
}

// `accept(step)` is the probability with which a proposal is accepted.
template <class Kernel, class Accept>
Eigen::MatrixXd transition_matrix(const Graph& graph, const StateSpace& states,
                                  const Kernel& kernel, Accept&& accept) {
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(states.size(), states.size());
  for_each_step(graph, states, kernel,
                [&](int x, const Step<Pointland>& step, const Enumeration& choices) {
                  // All numbers of a graph are moderate.
                  if (step.reason == Reason::not_finite)
                    throw std::logic_error("a step comes to what is no number");
                  const bool proposed = std::holds_alternative<Proposal>(step.outcome);
                  const double a = proposed ? accept(step) : 0;
                  if (a > 0) p(x, states.index_of(step.proposed)) += choices.probability() * a;
                  p(x, x) += choices.probability() * (1 - a);
                });
  return p;
}
template <class Kernel>
Eigen::MatrixXd transition_matrix(const Graph& graph, const StateSpace& states,
                                  const Kernel& kernel) {
  return transition_matrix(graph, states, kernel,
                           [](const Step<Pointland>& step) { return step.acceptance; });
}

struct Defects {
  double invariance;  // |πP - π|∞
  double balance;     // max |π_x P_xy - π_y P_yx|
  double rows;        // max |Σ_y P_xy - 1|
};

inline Defects defects(const Eigen::VectorXd& pi, const Eigen::MatrixXd& p) {
  const Eigen::MatrixXd flow = pi.asDiagonal() * p;
  return {(p.transpose() * pi - pi).cwiseAbs().maxCoeff(),
          (flow - flow.transpose()).cwiseAbs().maxCoeff(),
          (p.rowwise().sum().array() - 1).abs().maxCoeff()};
}

// Second largest absolute eigenvalue of a reversible matrix: that of the symmetric √π P / √π.
inline double second_eigenvalue(const Eigen::VectorXd& pi, const Eigen::MatrixXd& p) {
  const Eigen::VectorXd root = pi.cwiseSqrt();
  const Eigen::MatrixXd s = root.asDiagonal() * p * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((s + s.transpose()) / 2,
                                                              Eigen::EigenvaluesOnly);
  const auto n = solver.eigenvalues().size();
  return n < 2 ? 0 : std::max(solver.eigenvalues()[n - 2], -solver.eigenvalues()[0]);
}

}  // namespace wander::test

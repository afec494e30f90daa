#include "core/exact/gauss.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

namespace wander::exact {

namespace {

struct Legendre {
  double value, derivative;
};

// P_n(x) by the three-term recurrence k P_k = (2k-1) x P_{k-1} - (k-1) P_{k-2}, and P_n'(x).
Legendre legendre(std::size_t n, double x) {
  double before = 0, value = 1;
  for (std::size_t k = 1; k <= n; ++k) {
    const auto j = static_cast<double>(k);
    const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
    before = value;
    value = next;
  }
  return {value, static_cast<double>(n) * (x * value - before) / (x * x - 1)};
}

GaussRule make_rule(std::size_t n) {
  GaussRule rule{std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    // Tricomi's estimate of the root is close enough for Newton to converge in a few steps.
    const double angle =
        std::numbers::pi * (static_cast<double>(i) + 0.75) / (static_cast<double>(n) + 0.5);
    double x = -std::cos(angle);
    for (int step = 0; step < 8; ++step) {
      const Legendre p = legendre(n, x);
      x -= p.value / p.derivative;
    }
    const double slope = legendre(n, x).derivative;
    rule.nodes[i] = 0.5 * (1 + x);
    rule.weights[i] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace

const GaussRule& gauss_rule(std::size_t points) {
  static std::mutex mutex;
  static std::map<std::size_t, GaussRule> rules;  // a map never moves its elements
  const std::scoped_lock lock(mutex);
  const auto found = rules.find(points);
  if (found != rules.end()) return found->second;
  return rules.emplace(points, make_rule(points)).first->second;
}

}  // namespace wander::exact

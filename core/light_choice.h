// Which light a subpath begins on: each with a probability in proportion to its power, by the inverse of the cumulative
// distribution.  Unlike an alias table it is monotone in its number, so that a small step of that number stays on a light or goes to
// the next, and the number is told from the light as easily.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace wander {

class LightChoice {
 public:
  LightChoice() = default;
  explicit LightChoice(std::span<const double> powers) {
    double all = 0;
    for (const double power : powers) all += power;
    double before = 0;
    for (const double power : powers) {
      before_.push_back(before);
      probability_.push_back(power / all);
      before += probability_.back();
    }
  }

  std::size_t size() const { return before_.size(); }
  double probability(std::size_t light) const { return probability_[light]; }

  // Of a number in [0, 1); O(log n).
  std::size_t operator()(double u) const {
    const auto next = std::upper_bound(before_.begin() + 1, before_.end(), u);
    return static_cast<std::size_t>(next - before_.begin()) - 1;
  }
  // A number that chooses this light, for each u in [0, 1).
  double number(std::size_t light, double u) const {
    const double end = light + 1 < size() ? before_[light + 1] : 1;
    return std::min(before_[light] + u * probability_[light], std::nextafter(end, 0.));
  }

 private:
  std::vector<double> before_;  // Σ of the probabilities of those before
  std::vector<double> probability_;
};

}  // namespace wander

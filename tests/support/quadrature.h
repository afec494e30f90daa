// Integrals over intervals and boxes by an adaptive rule with error control.
//
// It compares one tensor rule with the sum of the rules on the 2^N halves of the box, and bisects
// where the two differ; a jump or a kink of the integrand costs depth, not accuracy.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/exact/gauss.h"

namespace wander::test {

using namespace exact;

template <std::size_t N>
struct Box {
  std::array<double, N> low{}, high{};

  double measure() const {
    double product = 1;
    for (std::size_t d = 0; d < N; ++d) product *= high[d] - low[d];
    return product;
  }
};

struct Accuracy {
  double absolute = 1e-12;  // accepted difference between a box and its halves
  int depth = 40;           // at most this many bisections below the first box
};

template <std::size_t N, class Function>
double gauss_integral(const Function& f, const Box<N>& box, const GaussRule& rule) {
  const std::size_t n = rule.nodes.size();
  std::size_t points = 1;
  for (std::size_t d = 0; d < N; ++d) points *= n;
  double sum = 0;
  for (std::size_t i = 0; i < points; ++i) {
    std::array<double, N> x{};
    double weight = 1;
    std::size_t rest = i;
    for (std::size_t d = 0; d < N; ++d, rest /= n) {
      x[d] = std::lerp(box.low[d], box.high[d], rule.nodes[rest % n]);
      weight *= rule.weights[rest % n];
    }
    sum += weight * f(x);
  }
  return sum * box.measure();
}

// The part `child` (one bit per dimension) of the box cut in halves along every axis.
template <std::size_t N>
Box<N> half_of(const Box<N>& box, std::size_t child) {
  Box<N> part = box;
  for (std::size_t d = 0; d < N; ++d) {
    const double middle = 0.5 * (box.low[d] + box.high[d]);
    ((child >> d) & 1 ? part.low[d] : part.high[d]) = middle;
  }
  return part;
}

template <std::size_t N, class Function>
double refined_integral(const Function& f, const Box<N>& box, double estimate, Accuracy accuracy) {
  constexpr std::size_t children = std::size_t{1} << N;
  std::array<double, children> parts{};
  double sum = 0;
  for (std::size_t c = 0; c < children; ++c)
    sum += parts[c] = gauss_integral(f, half_of(box, c), gauss_rule(7));
  if (std::abs(sum - estimate) <= accuracy.absolute || accuracy.depth == 0) return sum;
  // The tolerance is not divided: an error that halves with the interval, as at a jump, would then
  // never get below it.
  const Accuracy next{accuracy.absolute, accuracy.depth - 1};
  double total = 0;
  for (std::size_t c = 0; c < children; ++c)
    total += refined_integral(f, half_of(box, c), parts[c], next);
  return total;
}

// ∫ f over the box; f takes std::array<double, N>.
template <std::size_t N, class Function>
double integral(const Function& f, const Box<N>& box, Accuracy accuracy = {}) {
  return refined_integral(f, box, gauss_integral(f, box, gauss_rule(7)), accuracy);
}

// ∫ f(x) dx over [low, high].
template <class Function>
double integral(const Function& f, double low, double high, Accuracy accuracy = {}) {
  const auto of_array = [&](const std::array<double, 1>& x) { return f(x[0]); };
  return integral<1>(of_array, Box<1>{{low}, {high}}, accuracy);
}

}  // namespace wander::test

// Gauss-Legendre rules: with n points exact for polynomials of degree 2n - 1.
#pragma once

#include <cstddef>
#include <vector>

namespace wander::exact {

struct GaussRule {
  std::vector<double> nodes, weights;  // on [0, 1]; the weights sum to 1
};

// The rule of that many points, by Newton's method on the Legendre polynomial; computed once each.
const GaussRule& gauss_rule(std::size_t points);

}  // namespace wander::exact

// Kelemen's small step in one primary coordinate [Kelemen et al. 2002]: a distance with density
// ∝ 1/distance between s1 and s2, either way, on the circle [0,1).  The kernel is symmetric,
//   K(u→v) = 1 / (2 |v - u| ln(s2/s1)).
#pragma once

#include <algorithm>
#include <cmath>

namespace wander {

struct Kelemen {
  double smallest = 1.0 / 1024, largest = 1.0 / 64;
  double log_ratio = std::log(largest / smallest);

  // The same moves so many times as far; half the circle is the farthest.
  Kelemen scaled(double factor) const {
    return {smallest * factor, std::min(largest * factor, 0.5)};
  }

  struct Move {
    double u;
    double density;  // of the move, per unit of the coordinate
  };

  template <class Random>
  Move move(double u, Random& random) const {
    const double either = 2 * random.uniform() - 1;  // its sign is one number, the rest another
    const double distance = largest * std::exp(-log_ratio * std::abs(either));
    double v = u + std::copysign(distance, either);
    if (v >= 1) v -= 1;
    if (v < 0) v += 1;
    if (v >= 1) v = 0;  // -1e-20 + 1 is 1 in floating point
    return {v, 1 / (2 * distance * log_ratio)};
  }
};

}  // namespace wander

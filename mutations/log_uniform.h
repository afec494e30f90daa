// A distance whose logarithm is uniform: many scales, each as often [Veach and Guibas 1997, 5.3.2].
//   p(d) = 1 / (d ln(largest / smallest)),  smallest < d <= largest
#pragma once

#include <algorithm>
#include <cmath>

namespace wander {

struct LogUniform {
  double smallest, largest;
  double log_ratio = std::log(largest / smallest);

  // The same distances so many times as long, up to `most`.
  LogUniform scaled(double factor, double most) const {
    return {smallest * factor, std::min(largest * factor, most)};
  }

  struct Distance {
    double value;
    double density;  // p(value)
  };

  template <class Random>
  Distance draw(Random& random) const {
    const double distance = largest * std::exp(-log_ratio * random.uniform());
    return {distance, 1 / (distance * log_ratio)};
  }
};

}  // namespace wander

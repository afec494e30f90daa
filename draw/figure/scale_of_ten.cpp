#include "draw/figure/scale_of_ten.h"

#include <cmath>

namespace wander::figure {

int common_exponent(double magnitude) {
  if (magnitude == 0 || (magnitude >= 1e-2 && magnitude < 1e4)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(magnitude) / 3 + 1e-9));
}

// A negative power is divided by.
double decimal(double mantissa, int exponent) {
  return exponent >= 0 ? mantissa * std::pow(10, exponent) : mantissa / std::pow(10, -exponent);
}

}  // namespace wander::figure

#include "statistics/visible_error.h"

#include <cmath>

#include "statistics/decision.h"

namespace wander {

namespace {

double normal_quantile_of_power() { return sidak_threshold(2 * (1 - power_of_visible), 1); }

}  // namespace

double visible_sum(double squares, double largest, double threshold) {
  const double q = normal_quantile_of_power();
  // S² - 2 p S + r = 0
  const double p = q * std::sqrt(squares) + threshold * threshold * largest / 4;
  const double r = (q * q - threshold * threshold) * squares;
  return p + std::sqrt(p * p - r);
}

double visible_difference(double standard_error, double degrees, double false_alarm) {
  return standard_error * (student_threshold(false_alarm, degrees) +
                           student_threshold(2 * (1 - power_of_visible), degrees));
}

double visible_normal(double standard_error, double threshold) {
  return standard_error * (threshold + normal_quantile_of_power());
}

}  // namespace wander

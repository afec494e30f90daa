// What a decision would have seen: the least error that it finds with a stated probability, as far as the
// spread of what it compares tells.
#pragma once

namespace wander {

// With which it finds it.
inline constexpr double power_of_visible = 0.99;

// The expectation that a sum would need to be found, if it is rejected where
//   |S| > T √(V + M |S| / 2),
// with V the sum of its terms' squares and M the largest that a term can be: the solution of
//   S - q √V = T √(V + M S / 2),   q the quantile of the normal distribution at 0.99.
double visible_sum(double squares, double largest, double threshold);

// The difference of two means that would be found, of a standard error of so many degrees of freedom, if
// so many of those that are equal are rejected.
double visible_difference(double standard_error, double degrees, double false_alarm);

// The same where errors are known: of |z| above the threshold.
double visible_normal(double standard_error, double threshold);

}  // namespace wander

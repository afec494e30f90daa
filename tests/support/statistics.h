// The decisions that only tests make, beside those of statistics/decision.h: against exact values,
// of whole distributions, and of proportions.
//
// Every test takes the probability with which it may reject a correct program, for the whole family
// of comparisons that it makes.  Bonferroni's rate α/m of each holds without independence.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "statistics/decision.h"

namespace wander::test {

// False-alarm rate of one test (one family).  With fewer than a thousand of them in the suite, a
// correct program fails less than once in 10^6 runs with new seeds.
inline constexpr double usual_false_alarm = 1e-9;

double bonferroni_threshold(double family_false_alarm, std::size_t comparisons);

std::ostream& operator<<(std::ostream& out, const Decision& decision);
std::string describe(const Decision& decision);

// An estimate with a known standard error against an exact value: z = (estimate - exact) / error.
Decision z_test(double estimate, double standard_error, double exact, double false_alarm);
Decision z_test(const Moments& sample, double exact, double false_alarm);
// The same with the error estimated from few values: Student's t with count - 1 degrees.
Decision t_test(const Moments& sample, double exact, double false_alarm);
// Differences of pairs have mean zero.
Decision paired_t_test(std::span<const double> a, std::span<const double> b, double false_alarm);
// Equal means, unequal variances [Welch 1947].  Count independent chains, never their steps.
Decision welch_test(const Moments& a, const Moments& b, double false_alarm);
double welch_p_value(const Moments& a, const Moments& b);

// One comparison of a family: its z, the standard error behind it, and the size of what is compared; 0 if
// that has none.
struct Compared {
  double z, standard_error, size;
};
// The largest |z| against Šidák's threshold, which knows what it would have seen: in half of the comparisons
// that have an error and a size.
Decision largest_z_test(std::span<const Compared> family, double false_alarm);
using wander::largest_z_test;  // of z alone, which has no size

// One z per bin.  A bin without spread must equal its exact value.  `sizes`: of what is compared, if those
// are not the exact values, as where bins are differences.
Decision bins_z_test(std::span<const Moments> bins, std::span<const double> exact,
                     double false_alarm, std::span<const double> sizes = {});
// One Welch test per bin, the smallest p against Šidák's rate.
Decision bins_welch_test(std::span<const Moments> a, std::span<const Moments> b,
                         double false_alarm);

// Cells expected to hold less than this many counts are pooled, so that χ² holds.
inline constexpr double smallest_expected_count = 5;
// Pearson's Σ (observed - expected)² / expected.  The totals are taken as equal by construction;
// `fitted` parameters cost a degree of freedom each.  Counts where none are expected fail at once.
Decision chi_square_test(std::span<const double> observed, std::span<const double> expected,
                         double false_alarm, std::size_t fitted = 0);
// Values (p-values, ranks) are uniform on [0, 1]: χ² over equal cells.
Decision uniformity_test(std::span<const double> values, double false_alarm,
                         std::size_t cells = 20);

struct ConfidenceInterval {
  double low = 0, high = 1;

  bool contains(double value) const { return low <= value && value <= high; }
};
// The exact interval of a proportion [Clopper and Pearson 1934], for coverage tests.
// `binomial_test` passes while the interval of confidence 1 - false_alarm holds the probability.
ConfidenceInterval binomial_interval(std::uint64_t successes, std::uint64_t trials,
                                     double confidence);
Decision binomial_test(std::uint64_t successes, std::uint64_t trials, double probability,
                       double false_alarm);

}  // namespace wander::test

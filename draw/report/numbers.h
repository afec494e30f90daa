// Numbers of a report: few digits, the same decimals down a column, never "nan".
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lab/compare/comparison.h"

namespace wander::report {

inline constexpr const char* unknown_number = "–";

// Three significant digits: "0.0123", "412", "1.23·10⁻⁷".
std::string rounded(double value);
// "[0.011, 0.014]", "[0.011, ?]" where a bound excludes nothing, unknown_number where both do.
std::string rounded(const compare::Interval& interval);
// "0.0123 [0.011, 0.014]"
std::string with_interval(const compare::Measured& measured);

// With the same decimals, as far as that takes few digits.
std::vector<std::string> aligned(std::span<const double> values);

// Values and their intervals as the cells of two columns, each value times `unit`.
struct MeasuredColumn {
  std::vector<std::string> values, intervals;
};
MeasuredColumn aligned(const std::vector<compare::Measured>& column, double unit = 1);

// Value ± 1.96 standard errors; not known where the error is not.
compare::Measured with_normal_interval(const Estimate& estimate);

// "1 bin", "3 bins"
std::string counted(std::size_t count, const std::string& noun);
// "a", "a and b", "a, b and c"
std::string listed(const std::vector<std::string>& words);

}  // namespace wander::report

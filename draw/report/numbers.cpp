#include "draw/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "statistics/number_text.h"

namespace wander::report {
namespace {

using compare::Interval;
using compare::Measured;

// Digits after the point, or none where a power of ten has to be named.
std::optional<int> decimals_for(double value, int significant) {
  const double size = std::abs(value);
  if (size == 0) return 0;
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  if (exponent < -4 || exponent > 6) return std::nullopt;
  return std::max(0, significant - 1 - exponent);
}

std::string with_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

std::string in_powers(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  // Two steps: a single power of ten may lie beyond what a double holds.
  const double mantissa =
      value / std::pow(10, exponent / 2) / std::pow(10, exponent - exponent / 2);
  return with_minus(fmt::format("{:.2f}·10{}", mantissa, superscript(exponent)));
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return unknown_number;
  // Three digits are enough of a large number, too.
  if (std::abs(value) >= 1000) {
    const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 2);
    value = std::round(value / unit) * unit;
  }
  return with_minus(fmt::format("{:.{}f}", value, decimals));
}

// One bound is enough; the other may exclude nothing.
bool is_known(const Interval& interval) {
  return !std::isnan(interval.low) || !std::isnan(interval.high);
}

// The decimals that show the least of the numbers with two digits and the greatest with few.
std::optional<int> common_decimals(std::span<const double> values) {
  double least = INFINITY, greatest = 0;
  for (const double value : values) {
    if (!std::isfinite(value) || value == 0) continue;
    least = std::min(least, std::abs(value));
    greatest = std::max(greatest, std::abs(value));
  }
  if (greatest == 0) return 0;
  if (greatest > 1e3 * least) return std::nullopt;
  const std::optional<int> decimals = decimals_for(least, greatest > 3 * least ? 2 : 3);
  return greatest < 1e6 ? decimals : std::nullopt;
}

std::string in_brackets(const Interval& interval, std::optional<int> decimals) {
  if (!is_known(interval)) return unknown_number;
  const auto end = [&](double value) {
    if (std::isnan(value)) return std::string("?");
    if (std::isinf(value)) return std::string(value < 0 ? "−∞" : "∞");
    return decimals ? fixed(value, *decimals) : rounded(value);
  };
  return fmt::format("[{}, {}]", end(interval.low), end(interval.high));
}

}  // namespace

std::string rounded(double value) {
  if (!std::isfinite(value)) return unknown_number;
  const std::optional<int> decimals = decimals_for(value, 3);
  return decimals ? fixed(value, *decimals) : in_powers(value);
}

std::string rounded(const Interval& interval) { return in_brackets(interval, std::nullopt); }

std::string with_interval(const Measured& measured) {
  if (!std::isfinite(measured.value)) return unknown_number;
  if (!is_known(measured.interval)) return rounded(measured.value);
  // Enough digits to tell the ends apart, where they are near the value.
  const double width = measured.interval.high - measured.interval.low;
  std::optional<int> decimals = decimals_for(measured.value, 3);
  if (const auto finer = width > 0 && std::isfinite(width) ? decimals_for(width, 2) : std::nullopt;
      decimals && finer && measured.value != 0)
    decimals = std::max(*decimals, *finer);
  const std::string value = decimals ? fixed(measured.value, *decimals) : rounded(measured.value);
  return value + " " + in_brackets(measured.interval, decimals);
}

std::vector<std::string> aligned(std::span<const double> values) {
  const std::optional<int> decimals = common_decimals(values);
  std::vector<std::string> cells;
  for (const double value : values)
    cells.push_back(decimals ? fixed(value, *decimals) : rounded(value));
  return cells;
}

MeasuredColumn aligned(const std::vector<Measured>& column, double unit) {
  std::vector<double> values;
  for (const Measured& measured : column) values.push_back(unit * measured.value);
  const std::optional<int> decimals = common_decimals(values);
  MeasuredColumn cells{aligned(values), {}};
  for (std::size_t k = 0; k < column.size(); ++k) {
    const Interval interval{unit * column[k].interval.low, unit * column[k].interval.high};
    const auto own = std::isfinite(values[k]) ? decimals_for(values[k], 3) : std::nullopt;
    cells.intervals.push_back(in_brackets(interval, decimals ? decimals : own));
  }
  return cells;
}

Measured with_normal_interval(const Estimate& estimate) {
  const double half_width = 1.96 * estimate.standard_error;
  return {estimate.value, {estimate.value - half_width, estimate.value + half_width}};
}

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) text += k + 1 == words.size() ? " and " : ", ";
    text += words[k];
  }
  return text;
}

}  // namespace wander::report

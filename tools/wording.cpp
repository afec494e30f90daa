#include "tools/wording.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace wander {

std::string count_in_words(double count) {
  // Three digits: from 999.5 of one unit on, rounding gives the next.
  if (count >= 999.5e6) return fmt::format("{:.3g} G", count / 1e9);
  if (count >= 999.5e3) return fmt::format("{:.3g} M", count / 1e6);
  if (count >= 1e4) return fmt::format("{:.3g} k", count / 1e3);
  return fmt::format("{:.0f}", count);
}

std::string duration_in_words(double seconds) {
  if (seconds < 10) return fmt::format("{:.2g} s", seconds);
  if (seconds < 60) return fmt::format("{:.0f} s", seconds);
  const double minutes = std::floor(seconds / 60);
  if (minutes < 60)
    return fmt::format("{:.0f} min {:.0f} s", minutes, std::floor(seconds - 60 * minutes));
  const double hours = std::floor(minutes / 60);
  return fmt::format("{:.0f} h {:.0f} min", hours, minutes - 60 * hours);
}

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.3g} %", 100 * share) : "unknown";
}

std::string with_error(const Estimate& estimate) {
  if (!std::isfinite(estimate.standard_error))
    return fmt::format("{:.6g} (error unknown)", estimate.value);
  return fmt::format("{:.6g} ± {:.2g}", estimate.value, estimate.standard_error);
}

std::string superscript(int value) {
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result;
  for (const char c : std::to_string(value))
    result += c == '-' ? std::string_view("⁻") : digits[c - '0'];
  return result;
}

}  // namespace wander

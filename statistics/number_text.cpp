#include "statistics/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace wander {

namespace {

constexpr int least_plain = -4, most_plain = 6;  // powers of ten

void drop_last_zeros(std::string& text) {
  if (text.find('.') == std::string::npos) return;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
}

}  // namespace

std::string number_text(double value, int digits) {
  if (std::isnan(value)) return "unknown";
  const std::string sign = std::signbit(value) && value != 0 ? "−" : "";
  if (std::isinf(value)) return sign + "∞";
  if (value == 0) return "0";
  // Rounded once, by the library: "1.47e+03".
  const std::string scientific = fmt::format("{:.{}e}", std::abs(value), std::max(digits, 1) - 1);
  const std::size_t e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1));
  if (exponent >= least_plain && exponent <= most_plain) {
    std::string plain =
        fmt::format("{:.{}f}", std::stod(scientific), std::max(0, digits - 1 - exponent));
    drop_last_zeros(plain);
    return sign + plain;
  }
  std::string mantissa = scientific.substr(0, e);
  drop_last_zeros(mantissa);
  return sign + (mantissa == "1" ? "" : mantissa + "·") + "10" + superscript(exponent);
}

std::string superscript(int value) {
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string result;
  for (const char c : std::to_string(value))
    result += c == '-' ? std::string_view("⁻") : digits[c - '0'];
  return result;
}

}  // namespace wander

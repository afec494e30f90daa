#include "scenes/import/number_words.h"

#include <charconv>
#include <cmath>

namespace wander {

namespace {

constexpr std::string_view separators = ", \t\r\n";

}  // namespace

std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    if (text.empty()) return words;
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<double> number_in(std::string_view text) {
  const auto numbers = numbers_in(text);
  if (!numbers || numbers->size() != 1) return {};
  return numbers->front();
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (std::string_view word : words_in(text)) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stopped != word.data() + word.size() || !std::isfinite(value))
      return {};
    numbers.push_back(value);
  }
  return numbers;
}

}  // namespace wander

#include "scenes/format/json_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/format/byte_order_mark.h"

namespace wander {

namespace {

constexpr std::size_t longest_excerpt = 60;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool is_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '+' || c == '-' || c == '.';
}

// The later bytes of a character in UTF-8.
bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

std::size_t bounded(std::size_t found, std::string_view text, std::size_t past) {
  return found == std::string_view::npos ? text.size() : found + past;
}

// Comments end where nlohmann's parser ends them, at a carriage return too.
std::size_t skip_blank(std::string_view text, std::size_t i) {
  if (i == 0 && text.starts_with(byte_order_mark)) i = byte_order_mark.size();
  while (i < text.size()) {
    const std::string_view rest = text.substr(i, 2);
    if (is_space(text[i]))
      ++i;
    else if (rest == "//")
      i = bounded(text.find_first_of("\r\n", i), text, 0);
    else if (rest == "/*")
      i = bounded(text.find("*/", i + 2), text, 2);
    else
      break;
  }
  return i;
}

std::size_t end_of_string(std::string_view text, std::size_t i) {
  for (++i; i < text.size() && text[i] != '"' && text[i] != '\n'; ++i)
    if (text[i] == '\\') ++i;
  return std::min(i + 1, text.size());
}

// Bytes of the character that begins here, 0 if it is none [Unicode 15, table 3-7].
std::size_t character_size(std::string_view s) {
  const auto at = [&](std::size_t i) {
    return i < s.size() ? static_cast<unsigned char>(s[i]) : static_cast<unsigned char>(0);
  };
  const unsigned lead = at(0), next = at(1);
  if (lead < 0x80) return lead == 0 ? 0 : 1;
  const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  unsigned low = 0x80, high = 0xBF;  // of the second byte: no overlong forms, no surrogates
  if (lead == 0xE0) low = 0xA0;
  if (lead == 0xED) high = 0x9F;
  if (lead == 0xF0) low = 0x90;
  if (lead == 0xF4) high = 0x8F;
  if (lead < 0xC2 || lead > 0xF4 || next < low || next > high) return 0;
  for (std::size_t i = 2; i < size; ++i)
    if (at(i) < 0x80 || at(i) > 0xBF) return 0;
  return size;
}

}  // namespace

Token token_after(std::string_view text, std::size_t begin) {
  const std::size_t first = skip_blank(text, begin);
  if (first >= text.size()) return {text.size(), text.size()};
  if (text[first] == '"') return {first, end_of_string(text, first)};
  std::size_t end = first;
  while (end < text.size() && is_word(text[end])) ++end;
  if (end > first) return {first, end};
  for (++end; end < text.size() && continues_character(text[end]);) ++end;
  return {first, end};
}

std::optional<std::size_t> first_bad_byte(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = character_size(text.substr(i, 4));
    if (size == 0) return i;
    i += size;
  }
  return std::nullopt;
}

LineColumn Places::of(std::size_t byte) {
  if (byte < byte_) {
    byte_ = 0;
    place_ = {};
  }
  if (byte_ == 0 && byte > 0 && text_.starts_with(byte_order_mark)) byte_ = byte_order_mark.size();
  for (; byte_ < byte && byte_ < text_.size(); ++byte_) {
    if (text_[byte_] == '\n')
      place_ = {place_.line + 1, 1};
    else if (byte_ + 1 >= text_.size() || !continues_character(text_[byte_ + 1]))
      ++place_.column;
  }
  return place_;
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const auto c = static_cast<unsigned char>(text.front());
    const std::size_t size = character_size(text);
    // U+0080 to U+009F, which terminals may obey as well, are C2 80 to C2 9F.
    const bool second_set = c == 0xC2 && size == 2 && static_cast<unsigned char>(text[1]) < 0xA0;
    if (second_set)
      shown += fmt::format("\\u{:04x}", static_cast<unsigned char>(text[1]));
    else if (c < 0x20 || c == 0x7F)
      shown += fmt::format("\\u{:04x}", c);
    else if (size == 0)
      shown += fmt::format("\\x{:02x}", c);
    else
      shown += text.substr(0, size);
    text.remove_prefix(std::max(size, std::size_t{1}));
  }
  return shown;
}

std::string excerpt(std::string_view text) {
  if (text.size() <= longest_excerpt) return printable(text);
  std::size_t end = longest_excerpt - 3;
  while (end > 0 && continues_character(text[end])) --end;
  return printable(text.substr(0, end)) + "...";
}

}  // namespace wander

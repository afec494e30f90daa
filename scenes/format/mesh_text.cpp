#include "scenes/format/mesh_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "scenes/format/byte_order_mark.h"
#include "scenes/format/json_text.h"
#include "scenes/format/mesh_file.h"

namespace wander {

namespace {

constexpr std::string_view spaces = " \t\r\v\f";

// A sign + is none of from_chars.
template <class Number>
bool parse(std::string_view word, Number& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, value);
  return error == std::errc() && stopped == end;
}

std::string shown(std::string_view word) { return word.empty() ? "the end" : excerpt(word); }

}  // namespace

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(spaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(spaces));
  line.remove_prefix(word.size());
  return word;
}

MeshText::MeshText(std::string_view text) : left_(text) {
  if (left_.starts_with(byte_order_mark)) left_.remove_prefix(byte_order_mark.size());
}

std::string_view MeshText::next_line() {
  const std::size_t end = left_.find('\n');
  const std::string_view line = left_.substr(0, end);
  left_.remove_prefix(end == std::string_view::npos ? left_.size() : end + 1);
  ++line_;
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

std::string_view MeshText::next_word() {
  while (!left_.empty()) {
    if (line_is_over_) ++line_;
    line_is_over_ = false;
    left_.remove_prefix(std::min(left_.find_first_not_of(spaces), left_.size()));
    const std::string_view word = left_.substr(0, left_.find_first_of(" \t\r\v\f\n"));
    left_.remove_prefix(word.size());
    if (!word.empty()) return word;
    if (left_.empty()) break;
    left_.remove_prefix(1);
    line_is_over_ = true;
  }
  return {};
}

void MeshText::refuse(std::string_view what) const {
  throw MeshFileError(fmt::format("line {}: {}", line_, what));
}

double coordinate(double value, const MeshText& text) {
  if (!(std::abs(value) <= largest_coordinate))
    text.refuse(
        fmt::format("{} is not allowed; a coordinate is a number from -1e60 to 1e60", value));
  return value;
}

double number_of(std::string_view word, const MeshText& text) {
  double value = 0;
  if (!parse(word, value)) text.refuse(fmt::format("{} is no number", shown(word)));
  return value;
}

std::int64_t integer_of(std::string_view word, const MeshText& text) {
  std::int64_t value = 0;
  if (!parse(word, value)) text.refuse(fmt::format("{} is no integer", shown(word)));
  return value;
}

void add_fan(Triangles& triangles, std::span<const std::int32_t> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.corners.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace wander

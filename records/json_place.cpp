#include "records/json_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "records/key_limit.h"
#include "scenes/format/json_document.h"
#include "scenes/format/json_text.h"

namespace wander {

using nlohmann::ordered_json;

namespace {

template <class Whole>
Whole whole_number(const ordered_json& json, const JsonPlace& place) {
  const bool fits = json.is_number_unsigned() ? std::in_range<Whole>(json.get<std::uint64_t>())
                                              : json.is_number_integer() &&
                                                    std::in_range<Whole>(json.get<std::int64_t>());
  if (!fits)
    place.refuse(fmt::format("a whole number from {} to {} is expected",
                             std::numeric_limits<Whole>::min(), std::numeric_limits<Whole>::max()));
  return json.get<Whole>();
}

}  // namespace

void JsonPlace::refuse(std::string_view what) const {
  throw JsonPlaceError(fmt::format("{}: {}", pointer_.empty() ? "/" : pointer_, what));
}

JsonPlace JsonPlace::inside(const ordered_json& value, std::string_view token) const {
  return JsonPlace(value, fmt::format("{}{}", pointer_, token));
}

std::optional<JsonPlace> JsonPlace::find(std::string_view key) const {
  if (!value_->is_object()) refuse("an object is expected");
  const auto found = value_->find(std::string(key));
  if (found == value_->end()) return std::nullopt;
  return inside(*found, printable(pointer_token(key)));
}

JsonPlace JsonPlace::at(std::string_view key) const {
  if (auto found = find(key)) return *std::move(found);
  inside(*value_, printable(pointer_token(key))).refuse("it is missing");
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  if (!value_->is_object()) refuse("an object is expected");
  std::vector<std::pair<std::string, JsonPlace>> members;
  for (const auto& [key, member] : value_->items())
    members.emplace_back(key, inside(member, printable(pointer_token(key))));
  return members;
}

std::vector<JsonPlace> JsonPlace::elements() const {
  if (!value_->is_array()) refuse("a list is expected");
  std::vector<JsonPlace> elements;
  for (std::size_t i = 0; i < value_->size(); ++i)
    elements.push_back(inside((*value_)[i], "/" + std::to_string(i)));
  return elements;
}

double JsonPlace::number() const {
  return value_->is_null() ? std::numeric_limits<double>::quiet_NaN() : get<double>();
}

// Without the place of each, for a film may have 10⁷ of them.
std::vector<double> JsonPlace::numbers() const {
  if (!value_->is_array()) refuse("a list of numbers is expected");
  std::vector<double> numbers;
  for (const ordered_json& element : *value_) {
    if (!element.is_number() && !element.is_null())
      inside(element, "/" + std::to_string(numbers.size())).refuse("a number or null is expected");
    numbers.push_back(element.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                        : element.get<double>());
  }
  return numbers;
}

std::vector<JsonPlace> JsonPlace::elements_if(std::string_view key) const {
  const auto found = find(key);
  return found ? found->elements() : std::vector<JsonPlace>{};
}
std::vector<double> JsonPlace::numbers_if(std::string_view key) const {
  const auto found = find(key);
  return found ? found->numbers() : std::vector<double>{};
}
double JsonPlace::number_if(std::string_view key) const {
  const auto found = find(key);
  return found ? found->number() : std::numeric_limits<double>::quiet_NaN();
}

void JsonPlace::read(bool& value) const {
  if (!value_->is_boolean()) refuse("true or false is expected");
  value = value_->get<bool>();
}
void JsonPlace::read(int& value) const { value = whole_number<int>(*value_, *this); }
void JsonPlace::read(std::uint64_t& value) const {
  value = whole_number<std::uint64_t>(*value_, *this);
}
void JsonPlace::read(double& value) const {
  if (!value_->is_number()) refuse("a number is expected");
  value = value_->get<double>();
}
void JsonPlace::read(std::string& value) const {
  if (!value_->is_string()) refuse("a text is expected");
  value = value_->get<std::string>();
}
void JsonPlace::read(std::vector<bool>& values) const {
  const auto is_flag = [](const ordered_json& element) { return element.is_boolean(); };
  if (!value_->is_array() || !std::ranges::all_of(*value_, is_flag))
    refuse("a list of true and false is expected");
  for (const ordered_json& element : *value_) values.push_back(element.get<bool>());
}

ordered_json parsed_json(std::string_view text) {
  KeyLimit limit;
  try {
    return ordered_json::parse(text, [&limit](int depth, auto event, const ordered_json&) {
      return limit.keeps(depth, event);
    });
  } catch (const ordered_json::parse_error& problem) {
    const std::size_t byte = std::min(problem.byte, text.size());
    const LineColumn at = Places(text).of(byte > 0 ? byte - 1 : 0);
    throw JsonPlaceError(fmt::format("line {}, column {}: this is no JSON", at.line, at.column));
  } catch (const ordered_json::exception&) {
    throw JsonPlaceError("/: a number is too large");
  }
}

}  // namespace wander

// Numbers in the attributes of Mitsuba's XML.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace wander {

// A finite number and nothing else, spaces around it apart.
std::optional<double> number_in(std::string_view text);
// Numbers between spaces and commas; nothing if one of them is none.
std::optional<std::vector<double>> numbers_in(std::string_view text);
std::vector<std::string_view> words_in(std::string_view text);

}  // namespace wander

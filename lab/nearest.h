// "Did you mean ...?" for words of the command line.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace wander {

// `unknown KIND "WORD"; did you mean "KNOWN"? allowed are A, B, C`
std::string unknown_word(std::string_view kind, std::string_view word,
                         std::span<const std::string_view> known);

}  // namespace wander

// Files that only the version of the program that wrote them reads: @VERSION@ stands for it in
// an input.
#pragma once

#include <string>
#include <string_view>

#include "records/version.h"

namespace wander::fuzz {

inline std::string of_this_version(std::string_view input) {
  constexpr std::string_view mark = "@VERSION@";
  std::string text(input);
  if (const std::size_t place = text.find(mark); place != text.npos)
    text.replace(place, mark.size(), program_version());
  return text;
}

}  // namespace wander::fuzz

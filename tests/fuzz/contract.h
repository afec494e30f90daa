// What the program owes to whoever gives it a file, whatever is in it: it is read, or refused by
// the failures that become exit code 3, with lines `FILE: PLACE: WHAT` in the program's own
// words.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "tests/fuzz/target.h"

namespace wander::fuzz {

// How the target breaks it on these bytes; none if it does not.
std::optional<std::string> breach(const Target& target, std::string_view bytes);

}  // namespace wander::fuzz

// "Did you mean ...?": the known word nearest to an unknown one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wander {

// By edit distance, where swapping two neighbours is one edit and case counts little; the first of
// equals.  Empty when none is near enough for a slip of the finger.
std::string likely_word(std::string_view word, const std::vector<std::string>& known);

// `did you mean "radius"? allowed are type, center, radius`, with as many words as fit in a line;
// names the nearest word even when it is far.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace wander

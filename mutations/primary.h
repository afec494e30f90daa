// What the small and the large step in primary sample space share.
#pragma once

#include <string_view>

namespace wander {

// Both steps go by one word, with one weight.
inline constexpr std::string_view primary_word = "primary";
// Of the primary steps, the share that is large.
inline constexpr double default_large_step = 0.3;

}  // namespace wander

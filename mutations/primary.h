// What the small and the large step in primary sample space share.
#pragma once

#include <string_view>

namespace wander {

// Both steps go by one word, with one weight.
inline constexpr std::string_view primary_word = "primary";
// Of that word, where `auto` chooses: small steps mix best where light has an easy way, and large
// ones lead everywhere.
inline constexpr double primary_auto_weight = 1.5;
// Of the primary steps, the share that is large.
inline constexpr double default_large_step = 0.3;

}  // namespace wander

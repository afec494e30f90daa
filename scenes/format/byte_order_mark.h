// What some editors put before a text in UTF-8.
#pragma once

#include <string_view>

namespace wander {

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace wander

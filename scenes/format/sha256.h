// SHA-256, the identity of a scene's text.
#pragma once

#include <string>
#include <string_view>

namespace wander {

// 64 hexadecimal digits in lower case.
std::string sha256(std::string_view text);

}  // namespace wander

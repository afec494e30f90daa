#include "lab/shell_words.h"

#include <filesystem>
#include <string_view>

namespace wander {

std::string quoted_for_shell(int count, const char* const* arguments) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  std::string line = std::filesystem::path(arguments[0]).filename().string();
  for (int i = 1; i < count; ++i) {
    const std::string_view word = arguments[i];
    line += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char letter : word)
      line += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    line += '\'';
  }
  return line;
}

}  // namespace wander

#include "lab/nearest.h"

#include <fmt/format.h>

#include <vector>

#include "scenes/format/scene_file_nearest.h"

namespace wander {

std::string unknown_word(std::string_view kind, std::string_view word,
                         std::span<const std::string_view> known) {
  return fmt::format("unknown {} \"{}\"; {}", kind, word,
                     suggestion(word, std::vector<std::string>(known.begin(), known.end())));
}

}  // namespace wander

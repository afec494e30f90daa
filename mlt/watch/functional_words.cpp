#include "mlt/watch/functional_words.h"

#include <algorithm>
#include <array>

#include "mlt/watch/functionals.h"

namespace wander {

std::string_view spoken_functional(std::string_view name) {
  constexpr std::array<std::string_view, functional_names.size()> words{
      "position on the sensor", "log f", "number of vertices", "specular vertices"};
  const auto* const found = std::ranges::find(functional_names, name);
  return found == functional_names.end()
             ? name
             : words[static_cast<std::size_t>(found - functional_names.begin())];
}

}  // namespace wander

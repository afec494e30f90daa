#include "lab/reference_name.h"

#include <fmt/format.h>

#include "lab/wording.h"

namespace wander {

bool is_exact(const std::string& origin) { return origin.starts_with("exact"); }

std::string name_of_reference(const std::string& origin) {
  return is_exact(origin) ? "exact" : origin;
}

std::string origin_of(const Rendering& rendering) {
  const bool has_origin = rendering.method == reference_method_word && !rendering.warnings.empty();
  return has_origin ? rendering.warnings.front() : "";
}

std::string name_of_reference(const Rendering& rendering) {
  if (const std::string origin = origin_of(rendering); !origin.empty())
    return name_of_reference(origin);
  return fmt::format("{}, {} samples", rendering.method,
                     count_in_words(static_cast<double>(rendering.samples)));
}

}  // namespace wander

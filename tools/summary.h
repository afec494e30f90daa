// A run in a dozen lines for people, as `render` prints it when it is done and `inspect` later.
#pragma once

#include <string>

#include "records/rendering.h"

namespace wander {

std::string summary_of(const Rendering& rendering);
// The table of its mutations alone.
std::string mutation_lines(const std::vector<MutationRecord>& mutations);

}  // namespace wander

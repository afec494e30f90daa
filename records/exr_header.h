// Whether a file of OpenEXR can hold what its header promises, before the library takes memory for it.
#pragma once

#include <filesystem>

namespace wander {

// Throws std::runtime_error where an attribute is longer than the file or not as long as its type says, the
// picture larger than pixels can be compressed, or of a kind that no film has.
void require_plausible_header(const std::filesystem::path& path);

}  // namespace wander

// What lint finds worth a warning, in the plane and in space alike.
#pragma once

#include <cstddef>

namespace wander {

// In units of the scene's diameter.
constexpr double smallest_feature = 1e-12;
constexpr double most_remote = 1e6;

constexpr std::size_t most_warnings = 100;

}  // namespace wander

// What people call the scalars of a chain's states; files know them by functional_names.
#pragma once

#include <string_view>

namespace wander {

// "position on the sensor" for film; a name that is not known speaks for itself.
std::string_view spoken_functional(std::string_view name);

}  // namespace wander

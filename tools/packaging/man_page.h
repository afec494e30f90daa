// The manual page wander(1), from what `--help` says.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace wander::packaging {

std::string man_page(CLI::App& app);

}  // namespace wander::packaging

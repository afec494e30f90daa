// Scripts with which shells complete verbs, options, methods and scenes of the gallery.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace wander::packaging {

std::string bash_completion(CLI::App& app);
std::string zsh_completion(CLI::App& app);
std::string fish_completion(CLI::App& app);

}  // namespace wander::packaging

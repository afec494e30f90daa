// What a scene requires of the program: which kinds of transport, geometry and mutation it can use.
// A scene pays only for what is listed here.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/description.h"

namespace wander {

struct Requirements {
  int dimension = 2;
  int colour_channels = 1;  // 3 when some number that describes light is coloured
  std::vector<std::string> materials, shapes;  // types present on shapes, each once, sorted
  bool specular = false;                       // some surface reflects or refracts as a mirror does
  bool caustic_paths_possible = false;  // light, then specular, then a surface it can fall on
  std::vector<std::string> mutations;   // that `auto` takes
  std::map<std::string, std::string> left_out;  // mutation -> why the scene cannot use it
};

// `known_mutations`: the mutations of the caller, for the core knows none by name.
Requirements requires_of(const description::Scene& scene,
                         const std::vector<std::string>& known_mutations);

// As scene files call it: "segment", "arc", ...
std::string type_of(const description::ShapeKind& kind);

}  // namespace wander

// What a schema cannot say of a scene: references, the counts of lights and sensors, degenerate
// shapes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "scenes/format/json_document.h"

namespace wander {

// `faults` are those known so far: the parts of the document in which they lie are taken as they
// are.  `meant` are keys that seem to stand there misspelt, so that they are not said to be
// missing.
std::vector<JsonFault> check_scene(const JsonDocument& document,
                                   const std::vector<JsonFault>& faults,
                                   const std::set<std::string>& meant);

}  // namespace wander

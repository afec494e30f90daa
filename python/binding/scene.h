// A valid scene as Python holds it.
#pragma once

#include <string>

#include "lab/scene_source.h"

namespace wander::python {

struct BoundScene {
  SceneDocument document;
  std::string source;  // a path, gallery:NAME, or what it was called
};

}  // namespace wander::python

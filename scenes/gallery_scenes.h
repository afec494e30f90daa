// The scenes that come with the program.  The build writes the definition from scenes/*.json.
#pragma once

#include <cstddef>

namespace wander {

struct GalleryScene {
  const char* name;  // what follows `gallery:`
  const char* text;  // the scene file
};

extern const GalleryScene gallery_scenes[];
extern const std::size_t gallery_scene_count;

}  // namespace wander

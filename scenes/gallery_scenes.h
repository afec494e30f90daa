// The scenes that come with the program, and their meshes.  The build writes the definitions from
// scenes/*.json and scenes/meshes/*.obj.
#pragma once

#include <cstddef>

namespace wander {

struct GalleryScene {
  const char* name;  // what follows `gallery:`
  const char* text;  // the scene file
};

struct GalleryMesh {
  const char* file;  // as scenes call it: meshes/egg.obj
  const char* text;
};

extern const GalleryScene gallery_scenes[];
extern const std::size_t gallery_scene_count;

extern const GalleryMesh gallery_meshes[];
extern const std::size_t gallery_mesh_count;

}  // namespace wander

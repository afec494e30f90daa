// Where a scene's meshes come from.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/geometry/triangles.h"

namespace wander {

// Of the file that a scene calls so.  Throws MeshFileError.
using MeshReader = std::function<Triangles(const std::string& file)>;

// Of a scene in this folder.  A path is relative to it and stays in it: neither `..` nor a symbolic
// link leads out.
MeshReader meshes_in(std::filesystem::path folder);

// Of a scene that is no file, and has no folder.
Triangles no_mesh(const std::string& file);

}  // namespace wander

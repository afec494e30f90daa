// Where a scene's meshes come from.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/surfaces.h"

namespace wander {

// Of the file that a scene calls so; with the normals that it has, if they are wanted.  Throws
// MeshFileError.
using MeshReader =
    std::function<Triangles(const std::string& file, description::MeshNormals wanted)>;

// Of a scene in this folder.  A path is relative to it and stays in it: neither `..` nor a symbolic
// link leads out.
MeshReader meshes_in(std::filesystem::path folder);

// Of a scene that is no file, and has no folder.
Triangles no_mesh(const std::string& file, description::MeshNormals wanted);

}  // namespace wander

// Meshes in files, OBJ and PLY (ASCII and binary), as triangles.
//
// Corners of faces are all that is read, and their normals where they are wanted; a face of more than
// three corners is a fan.  Decimal
// numbers are read as those of a scene file are, to the nearest double, so that what has the same
// coordinates in both is the same point.  Any file is safe to read: nothing is reserved that the
// file is too small to hold.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "core/surfaces.h"

namespace wander {

// What is wrong with a file, and a remedy: "line 7: ...".
struct MeshFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using description::MeshNormals;

// For smooth shading with the normals of the file, of which there may be none.  All throw
// MeshFileError.
Triangles parse_obj(std::string_view text, MeshNormals wanted = MeshNormals::flat);
Triangles parse_ply(std::string_view text, MeshNormals wanted = MeshNormals::flat);
// By the ending of the name.
Triangles read_mesh(const std::filesystem::path& path, MeshNormals wanted);

}  // namespace wander

// Meshes in files, OBJ and PLY (ASCII and binary), as triangles.
//
// Corners of faces are all that is read; a face of more than three corners is a fan.  Decimal
// numbers are read as those of a scene file are, to the nearest double, so that what has the same
// coordinates in both is the same point.  Any file is safe to read: nothing is reserved that the
// file is too small to hold.
#pragma once

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "core/geometry/triangles.h"

namespace wander {

// What is wrong with a file, and a remedy: "line 7: ...".
struct MeshFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// All throw MeshFileError.
Triangles parse_obj(std::string_view text);
Triangles parse_ply(std::string_view text);
// And the normals of its points, of any length; as many as points, or none.
Triangles parse_ply_with_normals(std::string_view text,
                                 std::vector<std::array<double, 3>>& normals);
// By the ending of the name.
Triangles read_mesh(const std::filesystem::path& path);

}  // namespace wander

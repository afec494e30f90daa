// Meshes in files, OBJ and PLY (ASCII and binary), as triangles.
//
// Corners of faces are all that is read, and their normals and texture coordinates where they are
// wanted; a face of more than three corners is a fan.  Decimal
// numbers are read as those of a scene file are, to the nearest double, so that what has the same
// coordinates in both is the same point.  Any file is safe to read: nothing is reserved that the
// file is too small to hold.
#pragma once

#include <compare>
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
enum class MeshCoordinates { none, of_textures };

// What of a file is wanted beside its triangles.
struct MeshWants {
  MeshNormals normals;
  MeshCoordinates coordinates;

  MeshWants(MeshNormals wanted = MeshNormals::flat, MeshCoordinates also = MeshCoordinates::none)
      : normals(wanted), coordinates(also) {}
  auto operator<=>(const MeshWants&) const = default;
};

// Of normals there may be none; coordinates are those of every corner.  All throw MeshFileError.
Triangles parse_obj(std::string_view text, MeshWants wanted = {});
Triangles parse_ply(std::string_view text, MeshWants wanted = {});
// By the ending of the name.
Triangles read_mesh(const std::filesystem::path& path, MeshWants wanted);

}  // namespace wander

#include "scenes/format/mesh_reader.h"

#include <algorithm>
#include <utility>

#include "scenes/format/mesh_file.h"

namespace wander {

namespace {

namespace fs = std::filesystem;

// Throws MeshFileError.
fs::path path_of(const std::string& file, const fs::path& folder) {
  if (fs::path(file).is_absolute())
    throw MeshFileError("the path is absolute; a mesh's path is relative to the scene");
  std::error_code problem;
  const fs::path root = fs::weakly_canonical(folder, problem),
                 path = fs::weakly_canonical(folder / file, problem);
  const auto [end_of_root, in_path] = std::ranges::mismatch(root, path);
  if (problem || end_of_root != root.end())
    throw MeshFileError(
        "the path leads out of the scene's folder; meshes lie in it, or in folders in it");
  return path;
}

}  // namespace

MeshReader meshes_in(fs::path folder) {
  return [folder = std::move(folder)](const std::string& file, MeshNormals wanted) {
    return read_mesh(path_of(file, folder), wanted);
  };
}

Triangles no_mesh(const std::string&, MeshNormals) {
  throw MeshFileError(
      "a scene that is no file has no folder to look for meshes in; save it beside them");
}

}  // namespace wander

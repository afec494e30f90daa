#include "scenes/format/scene_files.h"

#include <algorithm>
#include <utility>

#include "scenes/format/sha256.h"
#include "scenes/format/texture_file.h"

namespace wander {

namespace {

namespace fs = std::filesystem;

template <class Error>
fs::path path_of(const std::string& file, const fs::path& folder, const std::string& what) {
  if (fs::path(file).is_absolute())
    throw Error("the path is absolute; a " + what + "'s path is relative to the scene");
  std::error_code problem;
  const fs::path root = fs::weakly_canonical(folder, problem),
                 path = fs::weakly_canonical(folder / file, problem);
  const auto [end_of_root, in_path] = std::ranges::mismatch(root, path);
  if (problem || end_of_root != root.end())
    throw Error("the path leads out of the scene's folder; " + what +
                (what.ends_with('h') ? "es" : "s") + " lie in it, or in folders in it");
  return path;
}

}  // namespace

SceneFiles files_in(const fs::path& folder) {
  return {[folder](const std::string& file, MeshWants wanted) {
            return read_mesh(path_of<MeshFileError>(file, folder, "mesh"), wanted);
          },
          [folder](const std::string& file) {
            return read_texture(path_of<TextureFileError>(file, folder, "texture"));
          },
          [folder](const std::string& file) {
            return sha256_of_file(path_of<std::runtime_error>(file, folder, "mesh"));
          }};
}

Triangles no_mesh(const std::string&, MeshWants) {
  throw MeshFileError(
      "a scene that is no file has no folder to look for meshes in; save it beside them");
}

std::shared_ptr<const Texture> no_texture(const std::string&) {
  throw TextureFileError(
      "a scene that is no file has no folder to look for textures in; save it beside them");
}

}  // namespace wander

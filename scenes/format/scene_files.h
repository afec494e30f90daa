// Where the files come from that a scene names: meshes, and the pictures of textures.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/texture.h"
#include "scenes/format/mesh_file.h"

namespace wander {

// Of the file that a scene calls so; with what it has of what is wanted.  Throws MeshFileError.
using MeshReader = std::function<Triangles(const std::string& file, MeshWants wanted)>;
// Throws TextureFileError.
using TextureReader = std::function<std::shared_ptr<const Texture>(const std::string& file)>;

// Of a scene that is no file, and has no folder.
Triangles no_mesh(const std::string& file, MeshWants wanted);
std::shared_ptr<const Texture> no_texture(const std::string& file);

// The SHA-256 of what is in it.
using DigestOfFile = std::function<std::string(const std::string& file)>;

struct SceneFiles {
  MeshReader mesh = no_mesh;
  TextureReader texture = no_texture;
  DigestOfFile
      digest{};  // of a file that was read; none where what is in the files is of no concern
};

// Of a scene in this folder.  A path is relative to it and stays in it: neither `..` nor a symbolic
// link leads out.
SceneFiles files_in(const std::filesystem::path& folder);

}  // namespace wander

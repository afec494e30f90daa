// The meshes and pictures of an imported scene: each content once, in one folder beside the scene.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/geometry/triangles.h"

namespace wander {

struct ImportedFile {
  std::string path;  // relative to the scene
  std::string bytes;
};

class MeshStore {
 public:
  explicit MeshStore(std::string folder) : folder_(std::move(folder)) {}

  // The path of the file, in whose name stands what can be typed of `name`.
  std::string add(std::string bytes, const std::string& name);
  std::vector<ImportedFile> files() && { return std::move(files_); }

 private:
  std::string folder_;
  std::vector<ImportedFile> files_;
  std::map<std::string, std::string> known_;  // SHA-256 -> path
  std::set<std::string> paths_;
  std::map<std::string, int> numbers_;  // the last one given to a path that several want
};

// Binary, in double precision; with its normals and texture coordinates, if it has any.
std::string ply_of(const Triangles& mesh);
// With inside and outside exchanged.
Triangles turned_round(Triangles mesh);

}  // namespace wander

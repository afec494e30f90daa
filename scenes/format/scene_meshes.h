// The meshes that a scene names.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/geometry/triangles.h"
#include "scenes/format/json_document.h"
#include "scenes/format/scene_files.h"

namespace wander {

class SceneMeshes {
 public:
  // Reads those of shapes without a fault so far, and puts them where their transforms say; returns
  // the faults.
  std::vector<JsonFault> read(const JsonDocument& document, const std::vector<JsonFault>& faults,
                              const MeshReader& read_file);

  // Of a shape of the document that was read.
  std::shared_ptr<const Triangles> of(const nlohmann::ordered_json& shape) const {
    return meshes_.at(&shape);
  }

  // Those that were read, as the document names them.
  const std::set<std::string>& files() const { return files_; }

 private:
  std::set<std::string> files_;
  std::map<const nlohmann::ordered_json*, std::shared_ptr<const Triangles>> meshes_;
};

}  // namespace wander

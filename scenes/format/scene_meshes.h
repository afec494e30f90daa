// The mesh files that a scene names.
//
// A path is relative to the folder of the scene and stays in it: neither `..` nor a symbolic link
// leads out.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/triangles.h"
#include "scenes/format/json_document.h"

namespace wander {

class SceneMeshes {
 public:
  // Reads those of shapes without a fault so far, and puts them where their transforms say; returns
  // the faults.  A scene that is no file has no folder.
  std::vector<JsonFault> read(const JsonDocument& document, const std::vector<JsonFault>& faults,
                              const std::optional<std::filesystem::path>& folder);

  // Of a shape of the document that was read.
  std::shared_ptr<const Triangles> of(const nlohmann::ordered_json& shape) const {
    return meshes_.at(&shape);
  }

 private:
  std::map<const nlohmann::ordered_json*, std::shared_ptr<const Triangles>> meshes_;
};

}  // namespace wander

// The textures that a scene names.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "scenes/format/json_document.h"
#include "scenes/format/scene_files.h"

namespace wander {

class SceneTextures {
 public:
  // Reads those of materials without a fault so far, each file once; returns the faults.
  std::vector<JsonFault> read(const JsonDocument& document, const std::vector<JsonFault>& faults,
                              const TextureReader& read_file);

  // Of a reflectance of the document that was read, { "texture": ... }.
  std::shared_ptr<const Texture> of(const nlohmann::ordered_json& reflectance) const {
    return textures_.at(&reflectance);
  }

  // Those that were read, as the document names them.
  const std::set<std::string>& files() const { return files_; }

 private:
  std::set<std::string> files_;
  std::map<const nlohmann::ordered_json*, std::shared_ptr<const Texture>> textures_;
};

// Does a material of this name say its reflectance by a texture?
bool has_texture(const JsonDocument& document, const std::string& material);

}  // namespace wander

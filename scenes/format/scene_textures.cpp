#include "scenes/format/scene_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "scenes/format/json_text.h"
#include "scenes/format/texture_file.h"

namespace wander {

std::vector<JsonFault> SceneTextures::read(const JsonDocument& document,
                                           const std::vector<JsonFault>& faults,
                                           const TextureReader& read_file) {
  std::vector<JsonFault> found;
  const auto materials = document.find(document.root(), "materials");
  if (!materials || !(*materials)->is_object() || faults.size() > json_limits.faults) return found;
  std::map<std::string, std::shared_ptr<const Texture>> files;
  for (const JsonMember& material : document.children(*materials)) {
    const auto reflectance = document.find(material.node, "reflectance");
    if (!reflectance || !(*reflectance)->is_object() || found.size() > json_limits.faults) continue;
    const bool is_faulty = std::ranges::any_of(faults, [&](const JsonFault& fault) {
      return document.holds_byte(material.node, fault.byte);
    });
    if (is_faulty) continue;
    const JsonNode node = *document.find(*reflectance, "texture");
    const auto file = node->get<std::string>();
    try {
      if (!files.contains(file)) files.emplace(file, read_file(file));
      files_.insert(file);
      textures_[reflectance->value] = files.at(file);
    } catch (const TextureFileError& error) {
      found.push_back(document.fault(node, fmt::format("{}: {}", excerpt(file), error.what())));
    }
  }
  return found;
}

bool has_texture(const JsonDocument& document, const std::string& material) {
  const auto materials = document.find(document.root(), "materials");
  if (!materials) return false;
  const auto found = document.find(*materials, material);
  if (!found) return false;
  const auto reflectance = document.find(*found, "reflectance");
  return reflectance && (*reflectance)->is_object();
}

}  // namespace wander

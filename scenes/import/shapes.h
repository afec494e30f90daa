// Mitsuba's shapes as shapes of a scene file, with their materials and lights.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "scenes/import/back_sides.h"
#include "scenes/import/materials.h"
#include "scenes/import/mesh_store.h"

namespace wander {

class ImportedShapes {
 public:
  ImportedShapes(const ImportContext& context, std::string mesh_folder)
      : context_(context), meshes_(std::move(mesh_folder)), materials_(context, meshes_) {}

  void add(const XmlElement& shape);
  // Says which surfaces are seen from behind but are black there in Mitsuba.
  void look_behind(std::span<const glm::dvec3> eyes);

  const nlohmann::ordered_json& json() const { return json_; }
  const ImportedMaterials& materials() const { return materials_; }
  // The element that made the shape of this number.
  const XmlElement& source(std::size_t shape) const { return *sources_.at(shape); }
  std::vector<ImportedFile> files() && { return std::move(meshes_).files(); }

 private:
  friend class ShapeReader;

  const ImportContext& context_;
  MeshStore meshes_;
  ImportedMaterials materials_;
  nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
  std::vector<const XmlElement*> sources_;
  std::vector<PlacedSurface> surfaces_;
};

}  // namespace wander

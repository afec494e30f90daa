// Mitsuba's bsdfs as materials of a scene file.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scenes/format/mesh_file.h"
#include "scenes/import/back_sides.h"
#include "scenes/import/import_context.h"
#include "scenes/import/mesh_store.h"

namespace wander {

// What a shape is made of.
struct ImportedMaterial {
  enum class Presence { here, absent };  // absent: light passes as if there were no shape

  std::string name;  // empty: black
  Presence presence = Presence::here;
  PlacedSurface::Back back = PlacedSurface::Back::same;  // in Mitsuba
  bool refracts = false;
};

class ImportedMaterials {
 public:
  // Pictures are added to the files of the scene.
  ImportedMaterials(const ImportContext& context, MeshStore& files)
      : context_(context), files_(files) {}

  // Of a <bsdf>, on a shape that has texture coordinates or none; the same of the same element.
  ImportedMaterial of(const XmlElement& bsdf, MeshCoordinates coordinates);
  // What a shape without a bsdf is made of: diffuse, 0.5.
  ImportedMaterial usual();

  struct Entry {
    std::string name;
    nlohmann::ordered_json json;
    const XmlElement* source;  // null if there is none
  };
  // In the order of their use.
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  struct Made {
    nlohmann::ordered_json json;  // null: black
    ImportedMaterial::Presence presence = ImportedMaterial::Presence::here;
    PlacedSurface::Back back = PlacedSurface::Back::same;
  };
  friend class BsdfReader;

  std::string name_of(const nlohmann::ordered_json& json, const XmlElement* bsdf);

  const ImportContext& context_;
  MeshStore& files_;
  std::vector<Entry> entries_;
  std::map<std::pair<const XmlElement*, MeshCoordinates>, ImportedMaterial> known_;
  std::set<std::string> names_;
  std::map<std::string, int> numbers_;          // the last one given to a name that several want
  std::map<std::string, std::string> unnamed_;  // JSON text -> name
};

}  // namespace wander

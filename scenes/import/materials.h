// Mitsuba's bsdfs as materials of a scene file.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "scenes/import/import_context.h"

namespace wander {

// What a shape is made of.
struct ImportedMaterial {
  enum class Presence { here, absent };  // absent: light passes as if there were no shape
  enum class Sides { both, front };      // front: in Mitsuba its back is black

  std::string name;  // empty: black
  Presence presence = Presence::here;
  Sides sides = Sides::both;
  bool refracts = false;
};

class ImportedMaterials {
 public:
  explicit ImportedMaterials(const ImportContext& context) : context_(context) {}

  // Of a <bsdf>; the same of the same element.
  ImportedMaterial of(const XmlElement& bsdf);
  // What a shape without a bsdf is made of: diffuse, 0.5.
  ImportedMaterial usual();

  // By name, in the order of their use.
  const nlohmann::ordered_json& json() const { return json_; }
  // The element that a material was made of; null if there is none.
  const XmlElement* source(const std::string& name) const;

 private:
  struct Made {
    nlohmann::ordered_json json;  // null: black
    ImportedMaterial::Presence presence = ImportedMaterial::Presence::here;
    ImportedMaterial::Sides sides = ImportedMaterial::Sides::both;
  };
  friend class BsdfReader;

  std::string name_of(const nlohmann::ordered_json& json, const XmlElement* bsdf);

  const ImportContext& context_;
  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
  std::map<const XmlElement*, ImportedMaterial> known_;
  std::map<std::string, const XmlElement*> sources_;
  std::map<std::string, std::string> unnamed_;  // JSON text -> name
};

}  // namespace wander

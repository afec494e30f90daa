#include "scenes/import/import_context.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/format/json_text.h"
#include "scenes/format/scene_file_nearest.h"

namespace wander {

namespace {

constexpr int most_references = 16;

}  // namespace

ImportContext::ImportContext(const XmlScene& scene, Diagnosis& said)
    : diagnosis(said), scene_(scene) {
  collect(scene.root);
  if (references_within(scene.root, 0) > most_references) diagnosis.require_sound();
}

int ImportContext::references_within(const XmlElement& element, int so_far) {
  if (const auto known = references_.find(&element); known != references_.end())
    return known->second;
  int most = 0;
  for (const XmlElement& child : element.children) {
    const bool refers = child.tag == "ref";
    const auto found = objects_.find(child.attribute("id"));
    if (refers && found == objects_.end()) continue;  // a fault of whoever follows it
    const XmlElement* object = refers ? found->second : &child;
    if (refers && so_far == most_references) {
      diagnosis.fault(child,
                      fmt::format("objects refer to each other in a circle, or more than {} deep",
                                  most_references));
      return most_references + 1;
    }
    most = std::max(most, refers + references_within(*object, so_far + refers));
    if (so_far + most > most_references) break;
  }
  references_[&element] = most;
  return most;
}

void ImportContext::collect(const XmlElement& element) {
  for (const XmlElement& child : element.children) {
    if (child.has("id") && child.tag != "ref" && child.tag != "alias" &&
        !objects_.emplace(child.attribute("id"), &child).second)
      diagnosis.fault(child,
                      fmt::format("there is another object with the id {}; an id is given once",
                                  excerpt(child.attribute("id"))));
    collect(child);
  }
  for (const XmlElement& child : element.children)
    if (child.tag == "alias")
      if (const XmlElement* object = resolved(child))
        objects_.emplace(child.attribute("as"), object);
}

const XmlElement* ImportContext::known(const XmlElement& element) const {
  if (element.tag != "ref" && element.tag != "alias") return &element;
  const auto found = objects_.find(element.attribute("id"));
  return found == objects_.end() ? nullptr : found->second;
}

const XmlElement* ImportContext::resolved(const XmlElement& element) const {
  if (const XmlElement* object = known(element)) return object;
  std::vector<std::string> ids;
  for (const auto& [id, object] : objects_) ids.push_back(id);
  diagnosis.fault(element, fmt::format("there is no object with the id \"{}\"; {}",
                                       excerpt(element.attribute("id")),
                                       suggestion(element.attribute("id"), ids)));
  return nullptr;
}

std::filesystem::path ImportContext::known_file(const std::string& name) const {
  return find_file(scene_.folders, name);
}

std::filesystem::path ImportContext::file(const XmlElement& element,
                                          const std::string& name) const {
  const std::filesystem::path path = known_file(name);
  if (path.empty())
    diagnosis.fault(element, fmt::format("there is no file {}; paths are relative to the scene",
                                         name.empty() ? "without a name" : excerpt(name)));
  return path;
}

}  // namespace wander

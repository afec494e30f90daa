// An element of a Mitsuba scene, with includes put in their places and parameters replaced.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wander {

struct XmlPlace {
  std::shared_ptr<const std::string> file;
  int line = 1, column = 1;
  std::string path;
};

struct XmlElement {
  std::string tag;
  std::map<std::string, std::string, std::less<>> attributes;
  std::vector<XmlElement> children;
  XmlPlace place;

  // Empty if there is none.
  std::string attribute(std::string_view name) const {
    const auto found = attributes.find(name);
    return found == attributes.end() ? "" : found->second;
  }
  bool has(std::string_view name) const { return attributes.contains(name); }
  std::string type() const { return attribute("type"); }
};

}  // namespace wander

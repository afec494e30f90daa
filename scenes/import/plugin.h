// The properties of one object of a Mitsuba scene, by the names of version 3; those of 0.6, such as
// toWorld and intIOR, are the same names.
//
// Each property is asked for or passed over by name; done() finds fault with what is left, so that
// nothing in a file is overlooked.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/import/colour.h"
#include "scenes/import/import_context.h"

namespace wander {

// toWorld -> to_world, intIOR -> int_ior
std::string present_name(std::string_view name);

class Plugin {
 public:
  Plugin(const XmlElement& element, const ImportContext& context);

  const XmlElement& element() const { return element_; }
  std::string type() const { return element_.type(); }
  bool has(std::string_view name) const { return values_.contains(name); }
  // The element that gives the property; the object itself if none does.
  const XmlElement& where(std::string_view name) const;

  double number(std::string_view name, double otherwise);
  int integer(std::string_view name, int otherwise);
  bool flag(std::string_view name, bool otherwise);
  std::string text(std::string_view name, std::string_view otherwise);
  glm::dvec3 point(std::string_view name, glm::dvec3 otherwise);
  glm::dmat4 transform(std::string_view name);
  // Reflectances are from 0 to 1 in every channel, radiances and indices of refraction are not below 0.
  Colour reflectance(std::string_view name, double otherwise);
  Colour radiance(std::string_view name, double otherwise);
  Colour refraction(std::string_view name, double otherwise);

  // Objects in it, and those that it refers to: of this tag, in their order.
  std::vector<const XmlElement*> objects(std::string_view tag);
  bool is_of_tag(const XmlElement& child, std::string_view tag) const;

  void ignore(std::initializer_list<std::string_view> names);
  // Faults of what was not asked for.
  void done();

 private:
  const XmlElement* take(std::string_view name, std::initializer_list<std::string_view> tags);
  Colour colour(std::string_view name, double otherwise, Light light, double most);
  void refuse(const XmlElement& value, std::string_view what) const;

  const XmlElement& element_;
  const ImportContext& context_;
  std::map<std::string, const XmlElement*, std::less<>> values_;  // by name
  std::set<const XmlElement*> used_;
  std::vector<std::string> asked_;  // names
};

}  // namespace wander
